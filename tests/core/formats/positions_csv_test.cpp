// SPDX-License-Identifier: Apache-2.0
#include "core/formats/positions_csv.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/body/actor.h"
#include "core/job/atomic_file.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

MotionClip waving() {
    MotionClip clip{"wave", defaultActor().skeleton, 0.01, {}, {}};
    for (int f = 0; f < 4; ++f) {
        Pose pose = clip.skeleton.zeroPose();
        pose.p_world_root = Vector3d(0.1 * f, 1, -0.5);
        const int elbow = clip.skeleton.find("LeftForeArm");
        Eigen::VectorXd angles(2);
        angles << 0.2 * f, 0.1;
        pose.q_parent_joint[static_cast<size_t>(elbow)] =
            rotationFromAngles(clip.skeleton.joint(elbow), angles);
        clip.frames.push_back(pose);
    }
    return clip;
}

std::vector<std::string> cellsOf(const std::string& line) {
    std::vector<std::string> cells(1);
    for (const char c : line)
        if (c == ',')
            cells.emplace_back();
        else
            cells.back() += c;
    return cells;
}

TEST(PositionsCsv, HeaderFollowsTheCommandLinesSpecification) {
    const std::string text = formatPositionsCsv(waving(), false);
    EXPECT_EQ(text.rfind("time_s,Hips.x,Hips.y,Hips.z,Spine.x,", 0), 0u);
    EXPECT_NE(text.find("\n0.010000000,0.100000,1.000000,-0.500000,"), std::string::npos);
    EXPECT_EQ(cellsOf(text.substr(0, text.find('\n'))).size(), 1u + 3 * 21);
}

TEST(PositionsCsv, ReadsBackWhatWasWritten) {
    const MotionClip clip = waving();
    for (const bool angles : {false, true}) {
        const PositionTable table = parsePositionsCsv(formatPositionsCsv(clip, angles), "t.csv").value();
        ASSERT_EQ(table.time_s.size(), clip.frames.size());
        ASSERT_EQ(table.joints.size(), 21u);
        for (size_t f = 0; f < clip.frames.size(); ++f) {
            EXPECT_NEAR(table.time_s[f], 0.01 * static_cast<double>(f), 1e-9);
            for (size_t j = 0; j < table.joints.size(); ++j) {
                EXPECT_EQ(table.joints[j], clip.skeleton.joints()[j].name);
                EXPECT_LT((table.at(f, j) - globalPose(clip, f).p_world_joint[j]).norm(), 1e-6);
            }
        }
    }
}

TEST(PositionsCsv, AnglesAreTheNamedFreedomsInDegrees) {
    const std::string text = formatPositionsCsv(waving(), true);
    const std::vector<std::string> header = cellsOf(text.substr(0, text.find('\n')));
    const auto column = std::find(header.begin(), header.end(), "LeftForeArm.flexion");
    ASSERT_NE(column, header.end());
    const std::string last = text.substr(text.rfind('\n', text.size() - 2) + 1);
    EXPECT_NEAR(std::stod(cellsOf(last).at(static_cast<size_t>(column - header.begin()))), degrees(0.6),
                1e-5);
    EXPECT_NE(std::find(header.begin(), header.end(), "LeftLeg.flexion"), header.end());
}

TEST(PositionsCsv, TakesAnyColumnOrderSeparatorAndLayout) {
    for (const char* text :
         {"time_s,A.x,A.y,A.z\n0,1,2,3\n0.5,4,5,6\n", "time_s;A.x;A.y;A.z\r\n0;1;2;3\r\n0.5;4;5;6",
          "\xEF\xBB\xBF"
          "A.z\tframe\tA.y\ttime_s\tA.x\n3\tone\t2\t0\t1\n\n6\ttwo\t5\t0.5\t4\n",
          "\"time_s\" , \"A.x\",A.y,A.z\n 0, 1 ,2,3\n0.5,4,+5,6.0\n"}) {
        const Result<PositionTable> table = parsePositionsCsv(text, "t.csv");
        ASSERT_TRUE(table.ok()) << table.error().text();
        EXPECT_EQ(table->time_s, (std::vector<double>{0, 0.5}));
        EXPECT_EQ(table->joints, std::vector<std::string>{"A"});
        EXPECT_EQ(table->at(0, 0), Vector3d(1, 2, 3));
        EXPECT_EQ(table->at(1, 0), Vector3d(4, 5, 6));
    }
}

TEST(PositionsCsv, NamesWithSeparatorsStandInQuotes) {
    std::vector<Joint> joints = defaultActor().skeleton.joints();
    joints[3].name = "a \"neck\", odd";
    MotionClip clip{"odd", Skeleton::make(joints).value(), 0.01, {}, {}};
    clip.frames = {clip.skeleton.zeroPose()};
    EXPECT_EQ(parsePositionsCsv(formatPositionsCsv(clip, false), "t.csv")->joints.at(3), joints[3].name);
}

TEST(PositionsCsv, DamageIsNamedWithItsLine) {
    const struct {
        const char* text;
        const char* phrase;
    } cases[] = {
        {"", "t.csv is empty"},
        {"time,A.x,A.y,A.z\n0,1,2,3\n", "line 1: there is no column time_s"},
        {"time_s,a,b\n0,1,2\n", "line 1: there is no column JOINT.x"},
        {"time_s,A.x,A.z\n0,1,2\n", "line 1: joint A has no column A.y"},
        {"time_s,A.x,A.x,A.y,A.z\n0,1,2,3,4\n", "line 1: two columns are named \"A.x\""},
        {"time_s,A.x,A.y,A.z\n", "no row follows"},
        {"time_s,A.x,A.y,A.z\n0,1,2\n", "line 2: this row has 3 cells, but the header has 4"},
        {"time_s,A.x,A.y,A.z\n0,1,2,3\n1,1,,3\n", "line 3: A.y is \"\""},
        {"time_s,A.x,A.y,A.z\n0,1,2,nan\n", "line 2: A.z is \"nan\""},
        {"time_s,A.x,A.y,A.z\n\n0,1,2,inf\n", "line 3: A.z is \"inf\""},
        {"time_s;A.x;A.y;A.z\n0;1,5,0;2;3\n", "line 2: A.x is \"1,5,0\""},
        {"time_s,A.x,A.y,A.z\n1,1,2,3\n1,1,2,3\n", "line 3: time_s does not rise"},
    };
    for (const auto& c : cases) {
        const Result<PositionTable> failed = parsePositionsCsv(c.text, "t.csv");
        ASSERT_FALSE(failed.ok()) << c.phrase;
        EXPECT_EQ(failed.error().kind, ErrorKind::kUnreadable);
        EXPECT_NE(failed.error().message.find(c.phrase), std::string::npos) << failed.error().text();
        EXPECT_FALSE(failed.error().remedy.empty());
    }
}

TEST(PositionsCsv, RefusesWhatIsNotFiniteAndWhatExists) {
    const std::string path = testing::TempDir() + "noctule_positions.csv";
    std::filesystem::remove(path);
    MotionClip clip = waving();
    clip.frames[2].p_world_root.x() = std::numeric_limits<double>::infinity();
    const Status failed = writePositionsCsv(path, clip, false, false);
    ASSERT_FALSE(failed.ok());
    EXPECT_EQ(failed.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(failed.error().message.find("frame 3 of joint Hips"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(path));
    ASSERT_TRUE(writePositionsCsv(path, waving(), true, false).ok());
    EXPECT_EQ(readWholeFile(path).value(), formatPositionsCsv(waving(), true));
    EXPECT_EQ(readPositionsCsv(path)->time_s.size(), 4u);
    EXPECT_EQ(writePositionsCsv(path, waving(), true, false).error().kind, ErrorKind::kUsage);
    std::filesystem::remove(path);
}

}  // namespace
}  // namespace noctule
