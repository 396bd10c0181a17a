// SPDX-License-Identifier: Apache-2.0
#include "core/processing/calibration_observations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/support/observed_take.h"

namespace noctule {
namespace {

using simulation::Level;
using simulation::RigKind;

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values.at(values.size() / 2);
}

/// Three boards and two sources: sound takes its time to make.
simulation::StageRequest smallStage(RigKind rig) {
    simulation::StageRequest request = test::stageOf(rig, 3);
    request.suit.boards.resize(3);
    request.suit.sources.resize(2);
    return request;
}

TEST(CalibrationObservations, SoundAndReadingsOfAJigTellTheSameFlightTimes) {
    simulation::StageRequest request = smallStage(RigKind::kJig);
    request.duration_s = 16;
    const auto sound = test::observe(request, Level::kSignal), rows = test::observe(request);
    ASSERT_TRUE(sound) << sound.error().text();
    ASSERT_TRUE(rows) << rows.error().text();
    ASSERT_EQ(sound->observations.placements.size(), 6U);
    EXPECT_EQ(sound->observations.kind, "jig");
    for (const Stretch& placement : sound->observations.placements) {
        std::map<std::pair<int, int>, std::vector<double>> heard[2];
        for (const Observations* observations : {&sound->observations, &rows->observations})
            for (const FlightTime& flight : observations->flights)
                if (placement.contains(flight.time_s - 0.2) && placement.contains(flight.time_s + 0.2))
                    heard[observations == &rows->observations][{flight.source, flight.board}].push_back(
                        flight.flight_s);
        ASSERT_EQ(heard[0].size(), 6U) << placement.label;
        for (const auto& [pair, times] : heard[0]) {
            ASSERT_GT(heard[1][pair].size(), 3U);
            EXPECT_NEAR(median(times), median(heard[1][pair]), 1.5e-6) << "0.5 mm";
        }
    }
}

TEST(CalibrationObservations, ReadingsKeepTheirInstantsAndCounts) {
    const auto sound = test::observe(smallStage(RigKind::kLevelPlate), Level::kSignal);
    ASSERT_TRUE(sound) << sound.error().text();
    const Observations& seen = sound->observations;
    EXPECT_EQ(seen.began_s, 1767225600.0) << "2026-01-01T00:00:00Z";
    ASSERT_EQ(seen.boards.size(), 3U);
    for (size_t b = 0; b < seen.boards.size(); ++b) {
        EXPECT_GT(static_cast<double>(seen.boards[b].size()), 0.9 * 140 * seen.duration_s);
        const AxisCalibration& accel = sound->stage.truth.inertia[b].accel.calibration;
        double off_g = 0;
        int still = 0;
        for (const CountReading& reading : seen.boards[b]) {
            EXPECT_FALSE(reading.clipped);
            for (const simulation::RigStation& station : sound->stage.stations)
                if (reading.time_s > station.begin_s + 0.5 && reading.time_s < station.end_s) {
                    off_g += accel.apply(reading.accel_counts).norm() - kStandardGravity_m_per_s2;
                    ++still;
                }
        }
        ASSERT_GT(still, 1000);
        EXPECT_LT(std::abs(off_g / still), 0.05);
    }
}

}  // namespace
}  // namespace noctule
