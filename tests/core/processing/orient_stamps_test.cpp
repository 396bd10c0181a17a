// SPDX-License-Identifier: Apache-2.0
// A sensor that turns evenly about the vertical, read at instants that are not evenly apart.
#include <gtest/gtest.h>

#include <functional>

#include "core/import/import_take.h"
#include "core/math/rotation.h"
#include "core/processing/orient_take.h"
#include "tests/support/take_files.h"

namespace noctule {
namespace {

class OrientStamps : public testing::Test {
protected:
    static constexpr int kRows = 1000, kClock_hz = 1'000'000;
    static constexpr double kRests_s = 2, kTurn_rad_per_s = 0.5;

    /// `time_s` by row; the sensor rests for two seconds and turns from then on.
    void write(const std::function<double(int)>& time_s) {
        ImportedRecording recording;
        recording.name = "turn";
        recording.sensors.push_back({"one", {}});
        ImuSamples& samples = recording.sensors.front().samples;
        samples.rate_hz = 100;
        for (int i = 0; i < kRows; ++i) {
            samples.gyro_rad_per_s.push_back({0, time_s(i) > kRests_s ? kTurn_rad_per_s : 0, 0});
            samples.accel_m_per_s2.push_back({0, kStandardGravity_m_per_s2, 0});
        }
        const auto written =
            writeImportedTake(recording, {path_, "turn", "2026-01-01T00:00:00Z", "test", "u", true}, {});
        ASSERT_TRUE(written) << written.error().text();
        std::string sql = "DELETE FROM meta WHERE key='sample_count'; BEGIN;";
        for (int i = 0; i < kRows; ++i)
            sql += "UPDATE inertial SET sample=" + std::to_string(time_s(i) * kClock_hz) +
                   " WHERE frame=" + std::to_string(i) + ";";
        test::runSql(path_, sql + "COMMIT");
    }

    /// How far the sensor has turned at the end, by every estimator.
    void expectTheTurn(const std::function<double(int)>& time_s) {
        write(time_s);
        const double true_deg = degrees(kTurn_rad_per_s * (time_s(kRows - 1) - kRests_s));
        for (const OrientationEstimator& estimator : orientationEstimators())
            for (const bool smooth : {false, true}) {
                if (smooth && !estimator.can_smooth)
                    continue;
                OrientRequest request{path_,
                                      estimator.name + std::to_string(smooth),
                                      "2026-01-01T00:00:00Z",
                                      "test",
                                      &estimator,
                                      {}};
                request.choice.smooth = smooth;
                const auto summary = orientTake(request, {});
                ASSERT_TRUE(summary) << summary.error().text();
                warnings_ = summary->warnings;
                const auto rows = Take::open(path_)->orientations(summary->run, 0).value();
                ASSERT_EQ(rows.size(), size_t(kRows));
                double turned_rad = 0;
                for (size_t i = 0; i < rows.size(); ++i) {
                    EXPECT_NEAR(double(rows[i].time_ns) * 1e-9, time_s(int(i)), 1e-5);
                    if (i > 0)
                        turned_rad +=
                            logQuaternion(rows[i - 1].q_world_board.conjugate() * rows[i].q_world_board).y();
                }
                EXPECT_NEAR(degrees(turned_rad), true_deg, 2) << estimator.name << " " << smooth;
            }
    }

    test::Folder folder_;
    const std::string path_ = folder_.file("turn.noctule");
    std::vector<std::string> warnings_;
};

TEST_F(OrientStamps, AChangeOfRateIsFollowed) {
    expectTheTurn([](int i) { return i < 500 ? i * 0.01 : 5 + (i - 500) * 0.02; });
    EXPECT_TRUE(warnings_.empty());
}

TEST_F(OrientStamps, APauseTakesItsTimeAndIsTold) {
    expectTheTurn([](int i) { return i < 500 ? i * 0.01 : 7 + (i - 500) * 0.01; });
    ASSERT_EQ(warnings_.size(), 1u);
    EXPECT_NE(warnings_[0].find("paused for 2.00 s in all, first at 4.99 s"), std::string::npos)
        << warnings_[0];
}

/// A row that leaps ahead costs itself alone.
TEST_F(OrientStamps, AStampThatLeapsIsLeftOut) {
    write([](int i) { return i == 300 ? 9.0 : i < 500 ? i * 0.01 : 5 + (i - 500) * 0.02; });
    OrientRequest request{path_, "leap", "2026-01-01T00:00:00Z", "test", &orientationEstimators().front(),
                          {}};
    const auto summary = orientTake(request, {});
    ASSERT_TRUE(summary) << summary.error().text();
    ASSERT_EQ(summary->warnings.size(), 1u);
    EXPECT_NE(summary->warnings[0].find("jumps back at 1 readings"), std::string::npos)
        << summary->warnings[0];
    const auto rows = Take::open(path_)->orientations(summary->run, 0).value();
    ASSERT_EQ(rows.size(), size_t(kRows)) << "a row without reading stands in its place";
    EXPECT_NEAR(double(rows[300].time_ns) * 1e-9, 3, 1e-5);
    EXPECT_NEAR(double(rows.back().time_ns) * 1e-9, 14.98, 1e-5);
}

TEST_F(OrientStamps, SeveralStampsThatLeapInARowAreLeftOutAlone) {
    write([](int i) {
        return i >= 300 && i < 305 ? 9 + i * 0.01 : i < 500 ? i * 0.01 : 5 + (i - 500) * 0.02;
    });
    OrientRequest request{path_, "leaps", "2026-01-01T00:00:00Z", "test", &orientationEstimators().front(),
                          {}};
    const auto summary = orientTake(request, {});
    ASSERT_TRUE(summary) << summary.error().text();
    ASSERT_EQ(summary->warnings.size(), 1u);
    EXPECT_NE(summary->warnings[0].find("jumps back at 5 readings"), std::string::npos)
        << summary->warnings[0];
    const auto rows = Take::open(path_)->orientations(summary->run, 0).value();
    ASSERT_EQ(rows.size(), size_t(kRows));
    EXPECT_NEAR(double(rows[302].time_ns) * 1e-9, 3.02, 1e-5);
    EXPECT_NEAR(double(rows.back().time_ns) * 1e-9, 14.98, 1e-5);
}

/// No half of the recording is left out in silence.
TEST_F(OrientStamps, AClockThatStartsAnewIsRefused) {
    write([](int i) { return i < 400 ? i * 0.01 : (i - 400) * 0.01; });
    OrientRequest request{path_, "anew", "2026-01-01T00:00:00Z", "test", &orientationEstimators().front(),
                          {}};
    const auto summary = orientTake(request, {});
    ASSERT_FALSE(summary);
    EXPECT_NE(summary.error().text().find("would leave out 400 of 1000 readings"), std::string::npos)
        << summary.error().text();
    EXPECT_NE(summary.error().text().find("time rises"), std::string::npos) << summary.error().text();
}

/// Radios bring several readings at once, and some recorders stamp them alike.
TEST_F(OrientStamps, PacketsOfEqualStampsAreEvenlyApart) {
    write([](int i) { return i / 5 * 0.05; });
    OrientRequest request{path_, "packets", "2026-01-01T00:00:00Z", "test", &orientationEstimators().front(),
                          {}};
    const auto summary = orientTake(request, {});
    ASSERT_TRUE(summary) << summary.error().text();
    const auto rows = Take::open(path_)->orientations(summary->run, 0).value();
    ASSERT_EQ(rows.size(), size_t(kRows));
    for (size_t i = 1; i < rows.size(); ++i)
        EXPECT_NEAR(double(rows[i].time_ns - rows[i - 1].time_ns), 1e7, 1e5);
}

/// Recorders stamp a regular stream with some jitter: the line through it is truer than each stamp.
TEST_F(OrientStamps, JitterOfARegularStreamIsTakenOff) {
    write([](int i) { return i * 0.01 + (i % 3 == 1 ? 0.002 : 0); });
    OrientRequest request{path_, "jitter", "2026-01-01T00:00:00Z", "test", &orientationEstimators().front(),
                          {}};
    const auto summary = orientTake(request, {});
    ASSERT_TRUE(summary) << summary.error().text();
    const auto rows = Take::open(path_)->orientations(summary->run, 0).value();
    for (size_t i = 1; i < rows.size(); ++i)
        EXPECT_NEAR(double(rows[i].time_ns - rows[i - 1].time_ns), 1e7, 1e4);
}

}  // namespace
}  // namespace noctule
