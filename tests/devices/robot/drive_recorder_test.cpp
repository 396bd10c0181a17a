// SPDX-License-Identifier: Apache-2.0
// A drive goes into a take. Locks and full disks never stop it, and what could not be written is counted.
#include "devices/robot/drive_recorder.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "core/processing/recorded_drive.h"
#include "core/recording/database.h"
#include "core/robot/live_drive.h"
#include "core/robot/urdf_reader.h"
#include "tests/support/files.h"
#include "tests/support/plain_arm.h"

namespace noctule::robot_link {
namespace {

constexpr int64_t kStep_ns = 7'000'000;

class DriveRecorderTest : public testing::Test {
protected:
    void SetUp() override {
        std::filesystem::copy_file(NOCTULE_TEST_DATA "/takes/tiny_take.noctule", path_);
        const auto model = robot::parseUrdf(test::plainArmUrdf(), "arm");
        ASSERT_TRUE(model);
        arms_ = robot::drivenParts(*model, test::plainArmProfile(), {})->arms;
        drive_.robot = "arm";
        drive_.leader = "take";
        drive_.joints = robot::drivenParts(*model, test::plainArmProfile(), {})->joints();
        drive_.arms = {"right"};
    }
    /// Steps `from` to `to`: the elbow turns, and the robot is two steps later.
    void run(DriveRecorder& recorder, int from, int to) const {
        for (int i = from; i < to; ++i) {
            robot::DriveInput input;
            input.now_ns = kBegin_ns + i * kStep_ns;
            if (i >= 10)
                input.performer = robot::PerformerSeen{input.now_ns - 2'000'000, {}, 1};
            robot::DriveOutput output;
            output.q = elbowAt(i);
            output.state = robot::TeleopState::kFollowing;
            output.trouble = i < 10 ? robot::DriveTrouble::kNoPose : robot::DriveTrouble::kNone;
            LinkStatus link;
            link.state_arrived_ns = input.now_ns - 1'000'000;
            link.state = RobotState{};
            link.state->obeyed_sequence = static_cast<uint64_t>(std::max(0, i - 1));
            link.state->q = elbowAt(i - 2);
            link.state->v.assign(7, 0.5);
            recorder.add({kBegin_ns, input.now_ns, input, output, 100'000'000 + i * kStep_ns, link,
                          static_cast<uint64_t>(i + 1)});
        }
    }
    static std::vector<double> elbowAt(int step) {
        std::vector<double> q(7, 0);
        q[3] = -1.5 + 0.5 * std::sin(0.05 * step);
        return q;
    }
    std::unique_ptr<DriveSink> sink() const { return sinkIntoTake(path_).value(); }

    static constexpr int64_t kBegin_ns = 1'000'000'000'000;
    test::Folder folder_;
    const std::string path_ = folder_.file("t.noctule");
    std::vector<robot::RobotArm> arms_;
    RobotDriveRow drive_;
};

TEST_F(DriveRecorderTest, EveryStepAndStateIsInTheTake) {
    DriveRecorder recorder(drive_, arms_, 0, sink());
    run(recorder, 0, 400);
    const DriveRecord record = recorder.finish();
    EXPECT_FALSE(record.trouble) << record.trouble->text();
    EXPECT_EQ(record.written, 800);
    EXPECT_EQ(record.lost, 0);
    const auto take = Take::open(path_);
    ASSERT_TRUE(take);
    const auto drive = readRecordedDrive(*take);
    ASSERT_TRUE(drive) << drive.error().text();
    ASSERT_EQ(drive->commands.size(), 400u);
    ASSERT_EQ(drive->states.size(), 400u);
    EXPECT_EQ(drive->commands[0].trouble, "no-pose");
    EXPECT_FALSE(drive->commands[0].pose_time_ns);
    EXPECT_EQ(drive->commands[20].time_ns, 20 * kStep_ns);
    EXPECT_EQ(drive->commands[20].q, elbowAt(20));
    EXPECT_EQ(drive->commands[20].pose_arrived_ns, 20 * kStep_ns - 2'000'000);
    EXPECT_EQ(drive->commands[20].pose_time_ns, 100'000'000 + 20 * kStep_ns);
    EXPECT_EQ(drive->states[20].q, elbowAt(18));
    EXPECT_EQ(drive->states[20].obeyed_sequence, 19);
    // The pose of time 100 ms + i steps came at i steps - 2 ms.
    EXPECT_EQ(drive->about.take_time_ns, 102'000'000);
    const DriveSummary summary = summaryOf(*drive);
    EXPECT_EQ(summary.following, 400);
    EXPECT_EQ(summary.missing, 0);
    EXPECT_NEAR(*summary.pose_to_command_ms, 2, 1e-9);
    ASSERT_TRUE(summary.tracking.at(0));
    EXPECT_NEAR(summary.tracking[0]->delay_s, 0.013, 0.0006) << "two steps less 1 ms";
    EXPECT_LT(summary.tracking[0]->rest_rms_m, 0.0005);
    EXPECT_TRUE(take->skippedRows().empty());
}

TEST_F(DriveRecorderTest, FilesSayWhatTheTakeHolds) {
    DriveRecorder recorder(drive_, arms_, 0, sink());
    run(recorder, 0, 50);
    recorder.finish();
    const auto drive = readRecordedDrive(*Take::open(path_));
    ASSERT_TRUE(drive);
    const std::string csv = driveCsv(*drive);
    EXPECT_EQ(std::ranges::count(csv, '\n'), 51);
    EXPECT_EQ(csv.rfind("time_s,pose_arrived_s,pose_time_s,sequence,state,trouble,robot_arrived_s,", 0), 0u);
    EXPECT_NE(csv.find("\n0.140000,0.138000,0.240000,21,following,,0.139000,19,"), std::string::npos) << csv;
    const nlohmann::json trajectory = driveTrajectory(*drive);
    EXPECT_EQ(trajectory["joint_names"], drive_.joints);
    ASSERT_EQ(trajectory["points"].size(), 50u);
    const nlohmann::json& point = trajectory["points"][20];
    EXPECT_EQ(point["time_from_start"]["nsecs"], 140'000'000);
    EXPECT_EQ(point["positions"], elbowAt(20));
    EXPECT_NEAR(point["velocities"][3].get<double>(), 0.5 * std::cos(1.0) * 0.05 / 0.007, 1e-2);
    EXPECT_NE(driveReportHtml(*drive).find("<polyline class='reached'"), std::string::npos);
    EXPECT_EQ(readRecordedDrive(*Take::open(path_), 2).error().kind, ErrorKind::kUnusable);
    EXPECT_EQ(readRecordedDrive(*Take::open(NOCTULE_TEST_DATA "/takes/tiny_take.noctule")).error().kind,
              ErrorKind::kUnusable);
}

TEST_F(DriveRecorderTest, AProgramThatHoldsTheTakeCostsNothing) {
    DriveRecorder recorder(drive_, arms_, 0, sink());
    const auto other = Database::open(path_, Access::kReadWrite);
    ASSERT_TRUE(other);
    ASSERT_TRUE(other->execute("BEGIN EXCLUSIVE"));
    run(recorder, 0, 100);
    for (int i = 0; i < 4000 && recorder.state().longest_wait_s <= 0; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_GT(recorder.state().longest_wait_s, 0) << "it knows that it waits";
    EXPECT_EQ(recorder.state().written, 0);
    run(recorder, 100, 200);
    ASSERT_TRUE(other->execute("ROLLBACK"));
    const DriveRecord record = recorder.finish();
    EXPECT_FALSE(record.trouble);
    EXPECT_EQ(record.written, 400);
    EXPECT_EQ(readRecordedDrive(*Take::open(path_))->commands.size(), 200u);
}

/// Files of this process cannot grow while it lives.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) {
        signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before_);
        rlimit full = before_;
        full.rlim_cur = bytes;
        EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &full), 0);
    }
    ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }

private:
    rlimit before_{};
};

TEST_F(DriveRecorderTest, AFullDiskEndsTheWritingAndIsSaid) {
    DriveRecorder recorder(drive_, arms_, 0, sink());
    {
        const FullDisk full(std::filesystem::file_size(path_));
        run(recorder, 0, 3000);
        for (int i = 0; i < 4000 && !recorder.state().trouble; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        run(recorder, 3000, 3100);
    }
    const DriveRecord record = recorder.finish();
    ASSERT_TRUE(record.trouble);
    EXPECT_EQ(record.trouble->kind, ErrorKind::kDisk) << record.trouble->text();
    EXPECT_NE(record.trouble->message.find("t.noctule"), std::string::npos);
    EXPECT_EQ(record.written + record.lost, 6200) << "nothing is lost silently";
    EXPECT_GT(record.lost, 200);
    const auto take = Take::open(path_);
    ASSERT_TRUE(take) << "the take is as it was";
    EXPECT_EQ(take->sampleCount().value(), 302500);
}

TEST_F(DriveRecorderTest, ATakeThatCannotBeWrittenIsSaidBeforeTheRobotMoves) {
    EXPECT_FALSE(sinkIntoTake(folder_.file("none.noctule")));
    std::ofstream(folder_.file("text.noctule")) << "no take";
    EXPECT_FALSE(sinkIntoTake(folder_.file("text.noctule")));
}

}  // namespace
}  // namespace noctule::robot_link
