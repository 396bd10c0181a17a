// SPDX-License-Identifier: Apache-2.0
#include "core/processing/line_of_sight.h"

#include <gtest/gtest.h>

#include "core/math/rotation.h"

namespace noctule {
namespace {

/// A trunk of 15 cm radius; source in front of it, boards in front and behind, all on the root.
class LineOfSightTest : public testing::Test {
protected:
    void SetUp() override {
        Joint root;
        root.name = "Hips";
        root.type = JointType::kFree;
        actor_.skeleton = Skeleton::make({root}).value();
        actor_.capsules = {{"Hips", {0, -0.3, 0}, {0, 0.3, 0}, 0.15}};
        suit_.sources = {{"front", "", "Hips", {0, 0, 0.15}, {0, 0, 1}}};
        for (const auto& [id, p_m] : {std::pair("before", Vector3d(0.1, 0, 0.6)),
                                      {"behind", Vector3d(0, 0, -0.2)},
                                      {"beside", Vector3d(0.5, 0, 0.16)}}) {
            Board board;
            board.id = id;
            board.segment = "Hips";
            board.p_segment_board_m = p_m;
            suit_.boards.push_back(board);
        }
    }
    std::vector<bool> blocked(const Pose& pose) {
        LineOfSight sight(suit_, calibration_, actor_);
        sight.setPose(pose);
        return {sight.isBlocked(0, 0), sight.isBlocked(0, 1), sight.isBlocked(0, 2)};
    }

    Actor actor_;
    Suit suit_;
    Calibration calibration_;
};

TEST_F(LineOfSightTest, WhatFacesTheSourceIsSeenAndItsOwnCapsuleDoesNotHideIt) {
    EXPECT_EQ(blocked(actor_.skeleton.zeroPose()), (std::vector<bool>{false, true, false}));
}

TEST_F(LineOfSightTest, ThePoseOfTheWholeBodyDoesNotMatter) {
    Pose pose = actor_.skeleton.zeroPose();
    pose.p_world_root = {3, 1, -2};
    pose.q_parent_joint[0] = axisAngle(Vector3d(1, 2, 3).normalized(), 2);
    EXPECT_EQ(blocked(pose), (std::vector<bool>{false, true, false}));
}

TEST_F(LineOfSightTest, ASourceDoesNotShineBackwardsEvenWithoutABody) {
    actor_.capsules.clear();
    EXPECT_EQ(blocked(actor_.skeleton.zeroPose()), (std::vector<bool>{false, true, false}));
}

TEST_F(LineOfSightTest, ABodyBetweenHides) {
    suit_.sources[0].segment = "";  // in the room, two metres ahead, turned to the performer
    suit_.sources[0].p_segment_source_m = {0, 0, 2};
    suit_.sources[0].normal_segment = {0, 0, -1};
    EXPECT_EQ(blocked(actor_.skeleton.zeroPose()), (std::vector<bool>{false, true, false}));
    Pose turned = actor_.skeleton.zeroPose();
    turned.q_parent_joint[0] = axisAngle(Vector3d::UnitY(), 3.14159265);
    EXPECT_EQ(blocked(turned), (std::vector<bool>{true, false, false}));
}

TEST_F(LineOfSightTest, ACorrectedMountingCounts) {
    calibration_.boards.push_back({});
    calibration_.boards[0].id = "behind";
    calibration_.boards[0].p_segment_board_m = Vector3d(0, 0.1, 0.5);
    EXPECT_EQ(blocked(actor_.skeleton.zeroPose()), (std::vector<bool>{false, false, false}));
}

TEST_F(LineOfSightTest, AnUnknownSegmentIsNeverHidden) {
    suit_.boards[1].segment = "Tail";
    EXPECT_FALSE(blocked(actor_.skeleton.zeroPose())[1]);
}

}  // namespace
}  // namespace noctule
