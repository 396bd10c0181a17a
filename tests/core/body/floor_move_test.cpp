// SPDX-License-Identifier: Apache-2.0
#include "core/body/floor_move.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/body/actor.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

/// One arm raised, at (1, 2) on the floor, turned by 70 degrees.
Pose standingElsewhere(const Actor& actor) {
    Pose pose = actor.restPose();
    pose.p_world_root += Vector3d(1, 0.07, 2);
    pose.q_parent_joint[0] = axisAngle(Vector3d::UnitY(), radians(70)) * pose.q_parent_joint[0];
    const auto forearm = static_cast<size_t>(actor.skeleton.find("LeftForeArm"));
    pose.q_parent_joint[forearm] = axisAngle(Vector3d::UnitY(), 0.8) * pose.q_parent_joint[forearm];
    return pose;
}

TEST(FloorMove, TheBodyComesToTheOriginAndFacesForwardAndTheRestGoesAlong) {
    const Actor actor = defaultActor();
    const Pose pose = standingElsewhere(actor);
    ASSERT_NEAR(floorHeading(pose.q_parent_joint[0]), radians(70), 1e-12);
    const FloorMove move = moveToOrigin(pose);
    const Pose moved = movedOnFloor(pose, move);
    EXPECT_NEAR(moved.p_world_root.x(), 0, 1e-12);
    EXPECT_NEAR(moved.p_world_root.z(), 0, 1e-12);
    EXPECT_EQ(moved.p_world_root.y(), pose.p_world_root.y()) << "the height stays";
    EXPECT_NEAR(floorHeading(moved.q_parent_joint[0]), 0, 1e-12);
    for (size_t j = 1; j < pose.q_parent_joint.size(); ++j)
        EXPECT_EQ(moved.q_parent_joint[j].coeffs(), pose.q_parent_joint[j].coeffs()) << "the posture stays";
    const GlobalPose before = globalPose(actor.skeleton, pose), after = globalPose(actor.skeleton, moved);
    const Quaterniond turn = axisAngle(Vector3d::UnitY(), -radians(70));
    for (size_t j = 0; j < before.p_world_joint.size(); ++j)
        EXPECT_LT((after.p_world_joint[j] - turn * (before.p_world_joint[j] - Vector3d(1, 0, 2))).norm(),
                  1e-12)
            << actor.skeleton.joint(static_cast<int>(j)).name;
}

/// Who walks 1 m forward after it is 1 m in front of the place.
TEST(FloorMove, WhatComesAfterItIsSeenFromThere) {
    const Actor actor = defaultActor();
    Pose pose = standingElsewhere(actor);
    const FloorMove move = moveToOrigin(pose);
    pose.p_world_root += axisAngle(Vector3d::UnitY(), radians(70)) * Vector3d::UnitZ();
    const Vector3d place = movedOnFloor(pose, move).p_world_root;
    EXPECT_NEAR(place.x(), 0, 1e-12);
    EXPECT_NEAR(place.z(), 1, 1e-12);
}

TEST(FloorMove, OfNobodyWhoWasMovedChangesNothing) {
    const Pose pose = standingElsewhere(defaultActor());
    const Pose same = movedOnFloor(pose, {});
    EXPECT_EQ(same.p_world_root, pose.p_world_root);
    EXPECT_EQ(same.q_parent_joint[0].coeffs(), pose.q_parent_joint[0].coeffs());
}

TEST(FloorMove, ABodyOnItsBackFacesWhereItsFeetPoint) {
    const Quaterniond on_back = axisAngle(Vector3d::UnitX(), -std::numbers::pi / 2);
    const Quaterniond turned = axisAngle(Vector3d::UnitY(), 0.4) * on_back;
    EXPECT_NEAR(floorHeading(turned), 0.4, 1e-12);
}

}  // namespace
}  // namespace noctule
