// SPDX-License-Identifier: Apache-2.0
#include "core/body/usual_pose.h"

#include <gtest/gtest.h>

#include "core/body/actor.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

TEST(UsualPose, IsKnownOfEveryJointThatMoves) {
    const Actor actor = defaultActor();
    for (const Joint& joint : actor.skeleton.joints()) {
        const bool moves = joint.type != JointType::kFixed && joint.type != JointType::kFree;
        EXPECT_EQ(usualTurn(joint.name).has_value(), moves) << joint.name;
    }
    EXPECT_FALSE(usualTurn("Right"));
    EXPECT_FALSE(usualTurn("Tail"));
}

TEST(UsualPose, ArmsHangAndKneesBendOnBothSides) {
    const Vector3d left = usualTurn("LeftArm")->q_parent_joint * Vector3d::UnitX(),
                   right = usualTurn("RightArm")->q_parent_joint * -Vector3d::UnitX();
    EXPECT_LT(left.y(), -0.7);
    EXPECT_LT((right - Vector3d(-left.x(), left.y(), left.z())).norm(), 1e-12);
    for (const char* knee : {"LeftLeg", "RightLeg"}) {
        const Vector3d shank = usualTurn(knee)->q_parent_joint * -Vector3d::UnitY();
        EXPECT_LT(shank.z(), -0.4) << knee << " bends backwards";
        EXPECT_GT(usualTurn(knee)->sigma_rad.x(), 0.5);
        EXPECT_EQ(usualTurn(knee)->sigma_rad.y(), 0);
    }
}

}  // namespace
}  // namespace noctule
