// SPDX-License-Identifier: Apache-2.0
#include "core/formats/bvh.h"
#include "core/robot/command_files.h"
#include "core/robot/performer_arms.h"
#include "tests/core/robot/robots.h"

namespace noctule::robot {
namespace {

const std::string kTrajectories = NOCTULE_SOURCE_DIR "/resources/motions/trajectories/";

/// How far the right wrist goes to each side of where the figure begins, in m: x, y, z of the chest.
struct Extent {
    Vector3d least = Vector3d::Constant(9), most = Vector3d::Constant(-9);
};

Extent extentOf(const MotionClip& clip) {
    const auto arms = PerformerArms::make(clip.skeleton, clip.name);
    EXPECT_TRUE(arms);
    Extent extent;
    const auto count = static_cast<double>(clip.frames.size());
    for (size_t i = static_cast<size_t>(count / 7); i < static_cast<size_t>(count * 6 / 7); ++i) {
        const Vector3d wrist = arms->at(globalPose(clip, i)).in_chest[1].wrist_m;
        extent.least = extent.least.cwiseMin(wrist);
        extent.most = extent.most.cwiseMax(wrist);
    }
    return extent;
}

TEST(RobotTrajectories, TheSixOfThePaperAreWhatTheirNamesSay) {
    struct One {
        const char* name;
        double wide_m, high_m;
    };
    const One all[] = {{"vertical", 0, 0.26},  {"horizontal", 0.26, 0}, {"diagonal", 0.184, 0.184},
                       {"circle", 0.24, 0.24}, {"box", 0.26, 0.26},     {"infinity", 0.26, 0.13}};
    for (const One& one : all) {
        const auto document = readBvh(kTrajectories + one.name + ".bvh");
        ASSERT_TRUE(document) << document.error().text();
        const auto clip = toClip(*document);
        ASSERT_TRUE(clip);
        const Extent extent = extentOf(*clip);
        const Vector3d size = extent.most - extent.least;
        EXPECT_NEAR(size.x(), one.wide_m, 0.02) << one.name;
        EXPECT_NEAR(size.y(), one.high_m, 0.02) << one.name;
        EXPECT_LT(size.z(), 0.02) << one.name;  // in one plane
        const Pose &first = clip->frames.front(), &last = clip->frames.back();
        for (size_t j = 0; j < first.q_parent_joint.size(); ++j)
            EXPECT_LT(first.q_parent_joint[j].angularDistance(last.q_parent_joint[j]), 1e-3);
    }
}

TEST(RobotCommands, TablesAndTrajectoriesHoldTheCommands) {
    RobotTrajectory commands;
    commands.frame_time_s = 0.5;
    commands.joints = {"a", "b,c"};
    commands.frames = {{0, 1}, {0.5, 1}, {1.5, 0}};
    EXPECT_EQ(commandTable(commands),
              "time_s,a,\"b,c\"\n0.000000000,0.000000000,1.000000000\n0.500000000,0.500000000,1.000000000\n"
              "1.000000000,1.500000000,0.000000000\n");
    const nlohmann::json message = jointTrajectory(commands);
    EXPECT_EQ(message["joint_names"], nlohmann::json({"a", "b,c"}));
    ASSERT_EQ(message["points"].size(), 3u);
    EXPECT_EQ(message["points"][1]["velocities"], nlohmann::json({1.5, -1.0}));
    EXPECT_EQ(message["points"][2]["velocities"], nlohmann::json({0.0, 0.0}));
    EXPECT_EQ(message["points"][1]["time_from_start"]["nsecs"], 500'000'000);
    EXPECT_EQ(message["points"][2]["time_from_start"]["secs"], 1);
}

}  // namespace
}  // namespace noctule::robot
