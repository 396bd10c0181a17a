// SPDX-License-Identifier: Apache-2.0
// Takes whose readings have holes, stray rows, a late begin or another unit than counts.
#include "core/processing/take_quality.h"
#include "tests/core/processing/made_take.h"
#include "tests/core/processing/processed_runs.h"

namespace noctule {
namespace {

class OddReadings : public test::MadeTake {
protected:
    void SetUp() override {
        MadeTake::SetUp();
        change("DELETE FROM meta WHERE key='sample_count'");
    }
    void change(const std::string& sql) const { test::runSql(path(), sql); }
    Take take() const { return Take::open(path()).value(); }
    ProcessRequest request() const {
        ProcessRequest request = test::requestFor(path());
        request.tracker.root_given = false;
        return request;
    }
    Result<ProcessSummary> processed() const { return processTake(request(), {}); }

    const int64_t end_ = std::llround((test::kFrames - 1) * test::kRate_hz / 140.0) + 1;
};

TEST_F(OddReadings, ATextAsAnInstantIsOneRowLessAndTheLengthStays) {
    EXPECT_NEAR(static_cast<double>(take().sampleCount().value()), static_cast<double>(end_), 2);
    change("UPDATE inertial SET sample='late' WHERE frame=100");
    EXPECT_NEAR(static_cast<double>(take().sampleCount().value()), static_cast<double>(end_), 2);
    EXPECT_TRUE(processed());
}

TEST_F(OddReadings, ARowFarBeyondTheOthersIsDamage) {
    change("UPDATE inertial SET sample=15000000000 WHERE frame=150 AND board=0");  // a day later
    const Take damaged = take();
    EXPECT_NEAR(static_cast<double>(damaged.sampleCount().value()), static_cast<double>(end_), 2);
    auto readings = damaged.readings(kPrimaryRun).value();
    int of_board = 0;
    for (auto reading = readings.next(); reading && *reading; reading = readings.next()) {
        EXPECT_LT((*reading)->sample, static_cast<double>(end_));
        of_board += (*reading)->board == 0;
    }
    EXPECT_EQ(of_board, test::kFrames - 1);
    ASSERT_EQ(damaged.skippedRows().size(), 1u);
    EXPECT_EQ(damaged.skippedRows()[0].first,
              "row board 0 frame 150: sample lies far beyond those around it");
    EXPECT_TRUE(processed());
}

/// A stream without a fault is complete: neither what its format leaves out nor the last frame is a loss.
TEST_F(OddReadings, WhatTheFormatDoesNotSendIsNotLost) {
    change(
        "UPDATE inertial SET ax=NULL WHERE board=0 AND frame IN (130, 250);"
        "UPDATE inertial SET gy=NULL WHERE board=0 AND frame=190;"
        "UPDATE inertial SET gz=NULL WHERE board=0 AND frame BETWEEN 200 AND 209;"
        "DELETE FROM inertial WHERE board=0 AND frame=279;"
        "INSERT INTO inertial(run,board,frame,sample,gx,gy,gz,ax,ay,az,corrected) "
        "SELECT run,1,279,sample+1071,gx,gy,gz,ax,ay,az,corrected FROM inertial "
        "WHERE board=0 AND frame=278");
    const Take changed = take();
    const auto boards = boardQuality(changed, changed.suit().value(), Calibration{}, kPrimaryRun).value();
    EXPECT_EQ(boards[0].frames_expected, test::kFrames - 1);
    EXPECT_EQ(boards[0].frames_lost, 0);
    EXPECT_EQ(boards[0].readings_expected, 6 * 159 - 3);
    EXPECT_EQ(boards[0].readings_present, 6 * 159 - 3 - 10) << "ten in a row were lost";
}

TEST_F(OddReadings, NoPoseIsCarriedOverAnHourWithoutReadings) {
    change("UPDATE inertial SET sample=sample+540000000 WHERE frame>=140");
    const auto refused = processed();
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(refused.error().message.find("no reading from 0:01 to 1:00:01"), std::string::npos)
        << refused.error().message;
}

TEST_F(OddReadings, AHoleOfAMinuteIsBridgedAndCanBeCancelled) {
    change("UPDATE inertial SET sample=sample+9000000 WHERE frame>=140");
    struct : ProgressSink {
        void progress(double, const std::string&) override {
            if (++steps > 20)
                cancel.cancel();
        }
        int steps = 0;
        CancelFlag cancel;
    } early;
    const auto cancelled = processTake(request(), {&early, &early.cancel});
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().kind, ErrorKind::kCancelled) << "within the hole, which begins at one second";
    EXPECT_TRUE(processed());
}

TEST_F(OddReadings, PosesEndSoonAfterTheLastReading) {
    change("INSERT INTO meta(key,value) VALUES('sample_count','540000000'); DELETE FROM pulse");  // an hour
    ProcessRequest quick = request();
    quick.tracker.parameters = {
        {"steps_per_frame", 1}, {"constants.estimated", 0}, {"joint_laxity.estimated", 0}};
    const auto summary = processTake(quick, {});
    ASSERT_TRUE(summary) << summary.error().text();
    EXPECT_LE(take().poses(summary->pose_run)->frames.back().time_ns, 602'100'000'000);
}

TEST_F(OddReadings, PosesBeginWithTheFirstReading) {
    change("UPDATE inertial SET sample=sample+15000000; DELETE FROM pulse");
    const auto summary = processed();
    ASSERT_TRUE(summary) << summary.error().text();
    const auto poses = take().poses(summary->pose_run);
    ASSERT_TRUE(poses);
    ASSERT_FALSE(poses->frames.empty());
    EXPECT_GE(poses->frames.front().time_ns, 100'000'000'000);
}

TEST_F(OddReadings, ReadingsInSiAreNeitherClippedNorCounts) {
    change("UPDATE inertial SET gx=0, gy=-0.5, gz=0.1, ax=0, ay=9.81, az=-0.2");
    Calibration si = nominalCalibration(take().suit().value());
    const auto clipped = [&] {
        const auto boards = boardQuality(take(), take().suit().value(), si, kPrimaryRun).value();
        return boards[0].clipped_gyro + boards[0].clipped_accel;
    };
    EXPECT_GT(clipped(), 0) << "as counts";
    for (BoardCalibration& board : si.boards)
        for (AxisCalibration* axes : {&board.gyro, &board.accel}) {
            axes->zero_counts = Vector3d(0.02, -0.01, 0.3);  // found by a calibration
            axes->matrix = 1.01 * Matrix3d::Identity();
            EXPECT_FALSE(axes->isOfCounts());
        }
    EXPECT_EQ(clipped(), 0);
    EXPECT_TRUE(processed()) << "the calibration in it says that they are counts";
    change("DELETE FROM calibration");
    const auto refused = processed();
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("no counts"), std::string::npos) << refused.error().message;
    ProcessRequest with_calibration = request();
    with_calibration.calibration = si;
    EXPECT_TRUE(processTake(with_calibration, {}));
}

}  // namespace
}  // namespace noctule
