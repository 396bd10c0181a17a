// SPDX-License-Identifier: Apache-2.0
#include "core/motion/clip.h"

#include <gtest/gtest.h>

#include "core/math/rotation.h"

namespace noctule {
namespace {

/// Root, child 1 m above it, grandchild 1 m above that; the child bends by 90 degrees about z.
MotionClip bent() {
    std::vector<Joint> joints(3);
    for (int j = 0; j < 3; ++j) {
        Joint& joint = joints[static_cast<size_t>(j)];
        joint.name = std::string("j") + std::to_string(j);
        joint.parent = j - 1;
        joint.offset_m = Vector3d(0, 1, 0);
        joint.type = j == 0 ? JointType::kFree : JointType::kFixed;
    }
    MotionClip clip{"bent", Skeleton::make(joints).value(), 0.5, {}, {}};
    Pose pose = clip.skeleton.zeroPose();
    pose.p_world_root = Vector3d(5, 0, 0);
    pose.q_parent_joint[1] = axisAngle(Vector3d::UnitZ(), radians(90));
    clip.frames = {pose, pose};
    return clip;
}

TEST(Clip, RootPositionReplacesItsOffset) {
    const GlobalPose global = globalPose(bent(), 1);
    EXPECT_LT((global.p_world_joint[0] - Vector3d(5, 0, 0)).norm(), 1e-15);
    EXPECT_LT((global.p_world_joint[1] - Vector3d(5, 1, 0)).norm(), 1e-15);
    EXPECT_LT((global.p_world_joint[2] - Vector3d(4, 1, 0)).norm(), 1e-15);
    EXPECT_LT(angleBetween(global.q_world_joint[2], axisAngle(Vector3d::UnitZ(), radians(90))), 1e-15);
}

TEST(Clip, JointTranslationsReplaceTheOffsetsOfTheirFrame) {
    MotionClip clip = bent();
    const Vector3d up = Vector3d::UnitY();
    clip.p_parent_joint_m = {{up, up, up}, {up, 2 * up, 3 * up}};
    const GlobalPose plain = globalPose(bent(), 0), same = globalPose(clip, 0), moved = globalPose(clip, 1);
    for (size_t j = 0; j < 3; ++j) {
        EXPECT_EQ(same.p_world_joint[j], plain.p_world_joint[j]);
        EXPECT_EQ(moved.q_world_joint[j].coeffs(), plain.q_world_joint[j].coeffs());
    }
    EXPECT_LT((moved.p_world_joint[0] - Vector3d(5, 0, 0)).norm(), 1e-15);
    EXPECT_LT((moved.p_world_joint[2] - Vector3d(2, 2, 0)).norm(), 1e-15);
}

TEST(Clip, AFrameThatIsNotThereIsABrokenPromise) {
    EXPECT_THROW(globalPose(bent(), 2), std::logic_error);
}

TEST(Clip, DurationCountsFrames) {
    EXPECT_DOUBLE_EQ(bent().duration_s(), 1.0);
}

}  // namespace
}  // namespace noctule
