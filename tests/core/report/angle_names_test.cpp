// SPDX-License-Identifier: Apache-2.0
// Names against geometry: a positive angle must move the limb the way that its name says.
#include "core/report/angle_names.h"

#include <gtest/gtest.h>

#include "core/body/actor.h"
#include "core/body/kinematics.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

/// How the end of the bone of `joint` moves when it turns by 0.3 rad about an axis from the T pose.
Vector3d moved(const std::string& joint, const std::string& end, const Vector3d& axis) {
    const Skeleton skeleton = defaultActor().skeleton;
    Pose pose = skeleton.zeroPose();
    const auto place = [&] {
        return globalPose(skeleton, pose).p_world_joint[static_cast<size_t>(skeleton.find(end))];
    };
    const Vector3d before = place();
    pose.q_parent_joint[static_cast<size_t>(skeleton.find(joint))] = axisAngle(axis, 0.3);
    return place() - before;
}

const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();

TEST(AngleNames, SayWhichWayTheLimbMoves) {
    EXPECT_EQ(anatomicalAngle("LeftUpLeg", 0), "abduction");
    EXPECT_GT(moved("LeftUpLeg", "LeftLeg", kZ).x(), 0.05) << "to the left";
    EXPECT_EQ(anatomicalAngle("RightUpLeg", 0), "adduction");
    EXPECT_GT(moved("RightUpLeg", "RightLeg", kZ).x(), 0.05);
    EXPECT_EQ(anatomicalAngle("LeftUpLeg", 1), "extension");
    EXPECT_LT(moved("LeftUpLeg", "LeftLeg", kX).z(), -0.05) << "backward";
    EXPECT_EQ(anatomicalAngle("RightLeg", 1), "flexion");
    EXPECT_LT(moved("RightLeg", "RightFoot", kX).z(), -0.05);
    EXPECT_EQ(anatomicalAngle("LeftFoot", 1), "plantarflexion");
    EXPECT_LT(moved("LeftFoot", "LeftToeBase", kX).y(), -0.01) << "toes down";
    EXPECT_EQ(anatomicalAngle("LeftFoot", 2), "abduction");
    EXPECT_GT(moved("LeftFoot", "LeftToeBase", kY).x(), 0.01) << "toes out";
    EXPECT_EQ(anatomicalAngle("LeftArm", 0), "abduction");
    EXPECT_GT(moved("LeftArm", "LeftForeArm", kZ).y(), 0.05) << "up";
    EXPECT_EQ(anatomicalAngle("RightArm", 2), "horizontal flexion");
    EXPECT_GT(moved("RightArm", "RightForeArm", kY).z(), 0.05) << "forward";
    EXPECT_EQ(anatomicalAngle("RightForeArm", 2), "flexion");
    EXPECT_GT(moved("RightForeArm", "RightHand", kY).z(), 0.05);
    EXPECT_EQ(anatomicalAngle("Spine", 1), "flexion");
    EXPECT_GT(moved("Spine", "Head", kX).z(), 0.05) << "forward";
    EXPECT_EQ(anatomicalAngle("Spine", 0), "bending to the right");
    EXPECT_LT(moved("Spine", "Head", kZ).x(), -0.05);
}

TEST(AngleNames, StrangeJointsHaveNone) {
    EXPECT_EQ(anatomicalAngle("LeftTail", 0), "");
    EXPECT_EQ(anatomicalAngle("", 2), "");
}

}  // namespace
}  // namespace noctule
