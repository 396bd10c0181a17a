// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/accelerometer/accelerometer_positions.h"

#include <algorithm>

namespace noctule {
namespace {

constexpr double kShortestStill_s = 1;    ///< gives the mean to 0.02 counts
constexpr double kCreep_m_per_s2 = 0.04;  ///< from the first half to the second: 0.25 degrees

bool accelClips(const SteadyStretch& stretch) {
    return std::ranges::any_of(stretch.readings, [&](const CountReading& reading) {
        return reading.clipped &&
               (reading.accel_counts.minCoeff() <= 0 || reading.accel_counts.maxCoeff() >= 4095);
    });
}

bool creeps(const SteadyStretch& stretch, const Vector3d& slopes) {
    const size_t half = stretch.readings.size() / 2;
    const Vector3d change =
        plainMean(stretch.readings.subspan(half)) - plainMean(stretch.readings.first(half));
    return slopes.cwiseProduct(change).norm() > kCreep_m_per_s2;
}

}  // namespace

Vector3d plainMean(std::span<const CountReading> readings) {
    Vector3d sum = Vector3d::Zero();
    for (const CountReading& reading : readings)
        sum += reading.accel_counts;
    return sum / static_cast<double>(std::max<size_t>(1, readings.size()));
}

BoardStillness stillBoard(const BoardRecord& record, const std::vector<Observations>& takes) {
    const AxisCalibration nominal = AxisCalibration::nominal(record.board.accel_full_scale_m_per_s2);
    BoardStillness still;
    for (const SteadyStretch& stretch : record.steadyStretches()) {
        if (stretch.turns)
            continue;
        if (accelClips(stretch))
            still.clipped = true;
        else if (stretch.length_s() < kShortestStill_s || creeps(stretch, nominal.matrix.diagonal()))
            still.disturbed.push_back(stretch);
        else
            still.stretches.push_back(stretch);
    }
    std::vector<std::span<const CountReading>> readings;
    for (const SteadyStretch& stretch : still.stretches)
        readings.push_back(stretch.readings);
    const std::vector<CountMean> means = countMeans(readings, &CountReading::accel_counts);
    for (size_t k = 0; k < means.size(); ++k)
        still.positions.push_back(
            {means[k], takes[static_cast<size_t>(still.stretches[k].take)].g_m_per_s2, std::nullopt, 0});
    return still;
}

/// On most sides an axis lies level and reads its zero; one that stood up and down has it in the middle.
AxisCalibration guessZero(const std::vector<StillPosition>& positions, const AxisCalibration& nominal) {
    AxisCalibration guess = nominal;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> counts;
        for (const StillPosition& position : positions)
            counts.push_back(position.mean.counts[axis]);
        std::ranges::sort(counts);
        const double range_m_per_s2 = (counts.back() - counts.front()) * nominal.matrix(axis, axis);
        guess.zero_counts[axis] = range_m_per_s2 > 1.5 * positions.front().g_m_per_s2
                                      ? (counts.front() + counts.back()) / 2
                                      : counts[counts.size() / 2];
    }
    return guess;
}

}  // namespace noctule
