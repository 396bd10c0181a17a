// SPDX-License-Identifier: Apache-2.0
// Takes of a few boards on plate and turntable, and what an operator may do wrong with them.
#pragma once

#include <gtest/gtest.h>

#include <functional>

#include "core/calibration/findings.h"
#include "tests/support/observed_take.h"

namespace noctule::test {

inline simulation::StageRequest benchRequest(simulation::RigKind rig, size_t boards, uint64_t seed = 11) {
    simulation::StageRequest request = stageOf(rig, seed);
    request.suit.boards.resize(boards);
    request.suit.sources.resize(1);
    return request;
}

inline ObservedTake mustObserve(const simulation::StageRequest& request,
                                simulation::Level level = simulation::Level::kReadings) {
    auto take = observe(request, level);
    require(take.ok(), "mustObserve: no take");
    return std::move(*take);
}

/// Three boards; made once.
inline const ObservedTake& plateTake() {
    static const ObservedTake kTake = mustObserve(benchRequest(simulation::RigKind::kLevelPlate, 3));
    return kTake;
}
inline const ObservedTake& tableTake() {
    static const ObservedTake kTake = mustObserve(benchRequest(simulation::RigKind::kTurntable, 3));
    return kTake;
}

/// "+x" -> while that side was up, half a second of the movement before and after included.
inline Stretch whileUp(const ObservedTake& take, const std::string& side) {
    for (const simulation::RigStation& station : take.stage.stations)
        if (station.label == side + " up")
            return {station.begin_s - 0.5, station.end_s + 0.5, side};
    require(false, "whileUp: no such side");
    return {};
}

inline void removeReadings(Observations& all, size_t board, const Stretch& when) {
    std::erase_if(all.boards[board],
                  [&](const CountReading& reading) { return when.contains(reading.time_s); });
}

inline void changeReadings(Observations& all, size_t board, const Stretch& when,
                           const std::function<void(CountReading&)>& change) {
    for (CountReading& reading : all.boards[board])
        if (when.contains(reading.time_s))
            change(reading);
}

/// What was really at the accelerometer becomes something else.
inline void changeAcceleration(const ObservedTake& take, Observations& all, size_t board, const Stretch& when,
                               const std::function<Vector3d(const Vector3d&, double)>& change) {
    const AxisCalibration& truth = take.stage.truth.inertia[board].accel.calibration;
    changeReadings(all, board, when, [&](CountReading& reading) {
        const Vector3d accel = change(truth.apply(reading.accel_counts), reading.time_s - when.begin_s);
        reading.accel_counts = (truth.zero_counts + truth.matrix.inverse() * accel).array().round();
    });
}

/// Four seconds at rest in each of these directions of up, in the boards' frame, the board taken off the
/// wire in between.
inline Observations tiltedTake(const ObservedTake& like, const std::vector<Vector3d>& ups) {
    Observations all = like.observations;
    for (size_t b = 0; b < all.boards.size(); ++b) {
        const simulation::ChipTruth &gyro = like.stage.truth.inertia[b].gyro,
                                    &accel = like.stage.truth.inertia[b].accel;
        simulation::Random random(99, "tilted", b);
        all.boards[b].clear();
        for (size_t k = 0; k < ups.size(); ++k)
            for (int i = 0; i < 560; ++i) {
                const Vector3d a =
                    ups[k].normalized() * all.g_m_per_s2 + accel.bias + random.gaussianVector(accel.noise);
                const Vector3d w = gyro.bias + random.gaussianVector(gyro.noise);
                CountReading reading;
                reading.time_s = 5.0 * static_cast<double>(k) + i / 140.0;
                reading.accel_counts =
                    (accel.calibration.zero_counts + accel.calibration.matrix.inverse() * a).array().round();
                reading.gyro_counts =
                    (gyro.calibration.zero_counts + gyro.calibration.matrix.inverse() * w).array().round();
                all.boards[b].push_back(reading);
            }
    }
    return all;
}

/// Corners of a cube and the middles of four of its edges.
inline std::vector<Vector3d> tiltedDirections() {
    return {{1, 1, 1},   {1, 1, -1},   {1, -1, 1}, {1, -1, -1}, {-1, 1, 1}, {-1, 1, -1},
            {-1, -1, 1}, {-1, -1, -1}, {1, 1, 0},  {1, 0, -1},  {0, -1, 1}, {-1, 1, 0}};
}

/// The only finding about the board, or a failure.
inline Finding onlyFinding(const std::vector<Finding>& findings, const std::string& part) {
    std::vector<Finding> found;
    for (const Finding& finding : findings)
        if (finding.part == part)
            found.push_back(finding);
    EXPECT_EQ(found.size(), 1U) << part;
    for (const Finding& finding : found)
        if (found.size() > 1)
            ADD_FAILURE() << finding.what;
    return found.empty() ? Finding{} : found.front();
}

/// Readings without sense: noise, constants, clipped, with gaps.
inline Observations garbageTake(const ObservedTake& like, uint64_t seed) {
    Observations all = like.observations;
    simulation::Random random(seed, "garbage");
    for (auto& board : all.boards) {
        board.clear();
        double time_s = 0;
        const auto length = random.below(3000);
        const double spread = random.below(2) ? 0 : 300;
        CountReading reading;
        for (int64_t i = 0; i < length; ++i) {
            time_s += random.below(400) ? 1 / 140.0 : 1.5;
            if (random.below(300) == 0)
                for (int axis = 0; axis < 3; ++axis) {
                    reading.accel_counts[axis] = static_cast<double>(random.below(4096));
                    reading.gyro_counts[axis] = static_cast<double>(random.below(4096));
                }
            CountReading next = reading;
            next.time_s = time_s;
            next.clipped = random.below(50) == 0;
            next.accel_counts += random.gaussianVector(spread).array().round().matrix();
            board.push_back(next);
        }
    }
    return all;
}

}  // namespace noctule::test
