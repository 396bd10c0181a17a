// SPDX-License-Identifier: Apache-2.0
// A table's true speed from gravity's ripple alone: boards that turn about an axis known to lean.
#include "core/calibration/gyroscope/turntable_speed.h"

#include <gtest/gtest.h>

#include <deque>

#include "core/math/rotation.h"
#include "core/simulation/random.h"

namespace noctule {
namespace {

constexpr double kNominal_rad_per_s = 4.712, kTurn_s = 40, kReadings_hz = 140;
constexpr double kAccelNoise_m_per_s2 = 0.05;

/// Boards on a table that turns by a part `excess` faster than their gyroscopes were calibrated for.
struct LeaningTable {
    std::deque<std::vector<CountReading>> readings;
    std::deque<BoardRecord> records;
    std::vector<HeadingBoard> boards;

    LeaningTable(double excess, double leaning_rad, int count, uint64_t seed = 1,
                 double nominal_rad_per_s = kNominal_rad_per_s) {
        for (int b = 0; b < count; ++b)
            add(excess, leaning_rad, b, seed, nominal_rad_per_s);
    }

    void add(double excess, double leaning_rad, int index, uint64_t seed, double nominal_rad_per_s) {
        simulation::Random random(seed, "leaning table", static_cast<uint64_t>(index));
        const Board board;
        const Vector3d zero_counts(2060, 2030, 2041);
        const double gyro = board.gyro_full_scale_rad_per_s / 2048,
                     accel = board.accel_full_scale_m_per_s2 / 2048, rate = nominal_rad_per_s * (1 + excess);
        // Each sits on the table in a way of its own and is off by its zero and what turning adds.
        const Quaterniond q_table_board = expQuaternion(random.gaussianVector(0.7));
        const Vector3d constant_m_per_s2 = random.gaussianVector(0.3);
        const Quaterniond q_world_table = axisAngle(Vector3d::UnitX(), leaning_rad);
        readings.emplace_back();
        for (int i = 0; i < static_cast<int>(kTurn_s * kReadings_hz); ++i) {
            CountReading reading;
            reading.time_s = i / kReadings_hz;
            const Quaterniond q_world_board =
                q_world_table * axisAngle(Vector3d::UnitZ(), rate * reading.time_s) * q_table_board;
            reading.gyro_counts = zero_counts + q_table_board.conjugate() * Vector3d(0, 0, rate) / gyro;
            reading.accel_counts = Vector3d::Constant(2048) +
                                   (q_world_board.conjugate() * Vector3d(0, 0, kStandardGravity_m_per_s2) +
                                    constant_m_per_s2 + random.gaussianVector(kAccelNoise_m_per_s2)) /
                                       accel;
            readings.back().push_back(reading);
        }
        records.push_back({"board", "board", board, nullptr, {{0, &readings.back()}}});
        HeadingBoard heading;
        heading.record = &records.back();
        heading.turns = {{0, 0, readings.back().back().time_s, readings.back(), Vector3d::Zero(), true}};
        heading.matrix = gyro / (1 + excess) * Matrix3d::Identity();
        heading.zeros = {{{0.0, zero_counts}}};
        boards.push_back(heading);
    }
};

TEST(TurntableSpeed, IsThatOfTheTableWhicheverWayItIsOff) {
    for (const double excess : {0.0008, -0.0008, 0.004}) {
        const LeaningTable table(excess, radians(0.3), 3);
        const auto ratio = turntableSpeed(table.boards);
        ASSERT_TRUE(ratio);
        EXPECT_NEAR(ratio->excess, excess, 3 * ratio->sigma + 1e-5);
        EXPECT_LT(ratio->sigma, std::abs(excess) / 4) << "else the test shows nothing";
        EXPECT_NEAR(ratio->swing_m_per_s2, kStandardGravity_m_per_s2 * std::sin(radians(0.3)), 0.005);
        EXPECT_EQ(ratio->boards, 3);
    }
}

TEST(TurntableSpeed, OfATableThatHardlyTurnsNothingIsSaid) {
    for (const uint64_t seed : {1, 2, 3, 4, 5})
        EXPECT_FALSE(turntableSpeed(LeaningTable(0, radians(0.3), 3, seed, 1e-5).boards)) << "seed " << seed;
}

/// What is unsure is said to be: errors over sigmas, of tables that lean little.
TEST(TurntableSpeed, SigmaIsNoSmallerThanTheError) {
    constexpr int kTables = 20;
    double sum = 0;
    for (int t = 0; t < kTables; ++t) {
        const LeaningTable table(0.001, radians(0.1), 4, static_cast<uint64_t>(t + 1));
        const auto ratio = turntableSpeed(table.boards);
        ASSERT_TRUE(ratio);
        sum += std::pow((ratio->excess - 0.001) / ratio->sigma, 2) / kTables;
    }
    EXPECT_LT(sum, 1 + 3 * std::sqrt(2.0 / kTables));
}

TEST(TurntableSpeed, AnUprightTableTellsNothing) {
    EXPECT_FALSE(turntableSpeed(LeaningTable(0.001, 0, 2).boards));
    EXPECT_FALSE(turntableSpeed({}));
}

}  // namespace
}  // namespace noctule
