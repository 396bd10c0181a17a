// SPDX-License-Identifier: Apache-2.0
// A robot's commands and states in a take: written, read back equal; what is damaged is skipped and named.
#include <gtest/gtest.h>

#include "core/recording/take_edit.h"
#include "tests/support/take_files.h"

namespace noctule {
namespace {

RobotDriveRow twoJointDrive() {
    RobotDriveRow drive;
    drive.created_utc = "2026-01-01T00:00:00Z";
    drive.software = "test";
    drive.robot = "arm";
    drive.address = "udp://127.0.0.1:41950";
    drive.leader = "take";
    drive.rate_hz = 140;
    drive.joints = {"shoulder", "elbow, left"};
    drive.arms = {"left"};
    return drive;
}

RobotRows rowsOfDrive(int64_t from, int64_t count) {
    RobotRows rows;
    for (int64_t i = from; i < from + count; ++i) {
        RobotCommandRow command{i + 1, i * 7'000'000, {}, {}, "holding", "no-pose", {0.1, -0.2}, {{1, 2, 3}}};
        if (i % 2 == 1) {
            command.pose_time_ns = 5 * i;
            command.pose_arrived_ns = i * 7'000'000 - 3;
            command.trouble = "";
        }
        rows.commands.push_back(command);
        RobotStateRow state{i * 7'000'000 + 1, {}, i == 3, {0.5, 1e-9}, {0, -3}, {{-1, 0, 0.25}}};
        if (i > 0)
            state.obeyed_sequence = i;
        rows.states.push_back(state);
    }
    rows.take_time_ns = -42;
    rows.lost_rows = from;
    return rows;
}

class RobotRowsTest : public testing::Test {
protected:
    void SetUp() override {
        Take take = Take::open(path_, Access::kReadWrite).value();
        auto edit = TakeEdit::begin(take).value();
        ASSERT_EQ(edit.addRobotDrive(twoJointDrive()).value(), 1);
        ASSERT_TRUE(edit.addRobotRows(1, rowsOfDrive(0, 5)));
        ASSERT_TRUE(edit.addRobotRows(1, rowsOfDrive(5, 2)));
        ASSERT_EQ(edit.addRobotDrive(twoJointDrive()).value(), 2);
        ASSERT_TRUE(edit.commit());
    }
    const test::Folder folder_;
    const std::string path_ = test::tinyTake(folder_);
};

TEST_F(RobotRowsTest, AreReadAsTheyWereWritten) {
    const auto take = Take::open(path_);
    ASSERT_TRUE(take) << take.error().text();
    const auto drives = take->robotDrives();
    ASSERT_TRUE(drives) << drives.error().text();
    ASSERT_EQ(drives->size(), 2u);
    const RobotDriveRow& drive = drives->front();
    EXPECT_EQ(drive.robot, "arm");
    EXPECT_EQ(drive.leader, "take");
    EXPECT_EQ(drive.rate_hz, 140);
    EXPECT_EQ(drive.joints, twoJointDrive().joints);
    EXPECT_EQ(drive.arms, std::vector<std::string>{"left"});
    EXPECT_EQ(drive.take_time_ns, -42);
    EXPECT_EQ(drive.lost_rows, 5);
    EXPECT_FALSE(drives->back().take_time_ns);
    const auto commands = take->robotCommands(drive);
    const auto states = take->robotStates(drive);
    ASSERT_TRUE(commands && states);
    RobotRows expected = rowsOfDrive(0, 7);
    ASSERT_EQ(commands->size(), 7u);
    ASSERT_EQ(states->size(), 7u);
    for (size_t i = 0; i < 7; ++i) {
        const RobotCommandRow &told = (*commands)[i], &meant = expected.commands[i];
        EXPECT_EQ(told.sequence, meant.sequence);
        EXPECT_EQ(told.time_ns, meant.time_ns);
        EXPECT_EQ(told.pose_time_ns, meant.pose_time_ns);
        EXPECT_EQ(told.pose_arrived_ns, meant.pose_arrived_ns);
        EXPECT_EQ(told.state, meant.state);
        EXPECT_EQ(told.trouble, meant.trouble);
        EXPECT_EQ(told.q, meant.q);
        EXPECT_EQ(told.tips_m, meant.tips_m);
        const RobotStateRow &was = (*states)[i], &sent = expected.states[i];
        EXPECT_EQ(was.time_ns, sent.time_ns);
        EXPECT_EQ(was.obeyed_sequence, sent.obeyed_sequence);
        EXPECT_EQ(was.refuses, sent.refuses);
        EXPECT_EQ(was.q, sent.q);
        EXPECT_EQ(was.v, sent.v);
        EXPECT_EQ(was.tips_m, sent.tips_m);
    }
    EXPECT_TRUE(take->robotCommands(drives->back())->empty());
    EXPECT_TRUE(take->skippedRows().empty());
}

TEST_F(RobotRowsTest, AreNoDerivedDataAndNeedFormat11) {
    Take take = Take::open(path_, Access::kReadWrite).value();
    auto edit = TakeEdit::begin(take).value();
    const auto run = edit.beginRun({0, "pose", "p", "", "test", "{}", {}, {}});
    ASSERT_TRUE(run);
    ASSERT_TRUE(edit.dropRun(*run));
    ASSERT_TRUE(edit.commit());
    EXPECT_EQ(take.robotDrives()->size(), 2u);
    const auto database = Database::open(path_, Access::kRead);
    ASSERT_TRUE(database);
    EXPECT_EQ(database->queryInteger("PRAGMA user_version").value(), kTakeNewestVersion);
}

TEST_F(RobotRowsTest, DamagedOnesAreSkippedAndNamed) {
    test::runSql(path_,
                 "UPDATE robot_command SET q=zeroblob(8) WHERE sequence=2;"
                 "UPDATE robot_command SET tips=NULL WHERE sequence=3;"
                 "UPDATE robot_command SET time_ns=-1 WHERE sequence=4;"
                 "UPDATE robot_state SET v=x'000000000000f07f000000000000f07f' WHERE id=1;"
                 "UPDATE robot_drive SET json='{\"joints\":[1]}' WHERE drive=2;");
    const auto take = Take::open(path_);
    ASSERT_TRUE(take);
    const auto drives = take->robotDrives();
    ASSERT_TRUE(drives);
    ASSERT_EQ(drives->size(), 1u);
    EXPECT_EQ(take->robotCommands(drives->front())->size(), 4u);
    EXPECT_EQ(take->robotStates(drives->front())->size(), 6u) << "infinity is no speed";
    const auto skipped = take->skippedRows();
    ASSERT_EQ(skipped.size(), 3u);
    EXPECT_EQ(skipped[0].table, "robot_command");
    EXPECT_EQ(skipped[0].count, 3);
    EXPECT_NE(skipped[0].first.find("row 2: q or tips"), std::string::npos) << skipped[0].first;
}

TEST(RobotRows, ATakeWithoutThemHasNone) {
    const auto take = Take::open(test::kTinyTake);
    ASSERT_TRUE(take);
    const auto drives = take->robotDrives();
    ASSERT_TRUE(drives) << drives.error().text();
    EXPECT_TRUE(drives->empty());
}

}  // namespace
}  // namespace noctule
