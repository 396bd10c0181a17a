// SPDX-License-Identifier: Apache-2.0
#include "core/body/skeleton.h"

#include <gtest/gtest.h>

#include <random>

#include "core/body/actor.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

TEST(Skeleton, RefusesWhatIsNoTree) {
    Joint root{"Hips", -1, Vector3d::Zero(), JointType::kFree, {}, {}, {}};
    Joint child{"Spine", 3, Vector3d::Zero(), JointType::kFixed, {}, {}, {}};
    const auto orphan = Skeleton::make({root, child});
    ASSERT_FALSE(orphan.ok());
    EXPECT_NE(orphan.error().message.find("Spine"), std::string::npos);
    child.parent = 0;
    child.name = "Hips";
    EXPECT_FALSE(Skeleton::make({root, child}).ok());
    child.name = "Spine";
    child.type = JointType::kHinge;
    EXPECT_FALSE(Skeleton::make({root, child}).ok());
    EXPECT_FALSE(Skeleton::make({}).ok());
}

TEST(Skeleton, ProjectionOntoUniversalIsTheNearestRotation) {
    const Actor actor = defaultActor();
    const Joint& joint = actor.skeleton.joint(actor.skeleton.find("LeftForeArm"));
    std::mt19937 engine(4);
    std::normal_distribution<double> normal(0, 0.8);
    for (int round = 0; round < 200; ++round) {
        const Quaterniond q = expQuaternion({normal(engine), normal(engine), normal(engine)});
        const JointAngles projected = projectOntoJoint(joint, q, false);
        double best = 10;
        for (double a = -3.14; a < 3.15; a += 0.05)
            for (double b = -3.14; b < 3.15; b += 0.05)
                best = std::min(best, angleBetween(q, rotationFromAngles(joint, Eigen::Vector2d(a, b))));
        EXPECT_LT(angleBetween(q, projected.q_parent_joint), best + 1e-6);
    }
}

TEST(Skeleton, ProjectionRecoversAnglesAndAppliesLimits) {
    const Actor actor = defaultActor();
    const Joint& knee = actor.skeleton.joint(actor.skeleton.find("RightLeg"));
    EXPECT_NEAR(projectOntoJoint(knee, axisAngle(Vector3d::UnitX(), 1.2), true).angles_rad[0], 1.2, 1e-12);
    EXPECT_NEAR(projectOntoJoint(knee, axisAngle(Vector3d::UnitX(), -1.2), true).angles_rad[0], -0.2, 1e-12);
    EXPECT_NEAR(projectOntoJoint(knee, axisAngle(Vector3d::UnitX(), -1.2), false).angles_rad[0], -1.2, 1e-12);
}

TEST(Actor, DefaultHasTheCanonicalJointsAndHeight) {
    const Actor actor = defaultActor({.height_m = 1.9});
    EXPECT_EQ(actor.skeleton.size(), 21);
    const Pose rest = actor.restPose();
    const GlobalPose global = globalPose(actor.skeleton, rest);
    const size_t head = static_cast<size_t>(actor.skeleton.find("Head"));
    const Vector3d crown = global.p_world_joint[head] +
                           global.q_world_joint[head] * *actor.skeleton.joint(static_cast<int>(head)).end_m;
    EXPECT_NEAR(crown.y(), 1.9, 0.03);
    const Vector3d hand = global.p_world_joint[static_cast<size_t>(actor.skeleton.find("LeftHand"))];
    EXPECT_GT(hand.x(), 0.15);  // to the performer's left, hanging
    EXPECT_LT(hand.y(), 1.15);
    EXPECT_GT(hand.z(), 0.0);
}

TEST(Actor, MeasuresOverrideProportions) {
    const Actor actor = defaultActor({.height_m = 1.75, .thigh_m = 0.5});
    EXPECT_NEAR(actor.skeleton.joint(actor.skeleton.find("LeftLeg")).offset_m.norm(), 0.5, 1e-12);
    EXPECT_NEAR(actor.skeleton.joint(actor.skeleton.find("LeftFoot")).offset_m.norm(), 0.43, 1e-12);
}

TEST(Actor, JsonKeepsEverything) {
    const Actor actor = defaultActor();
    const auto json = toJson(actor);
    const auto again = actorFromJson(json, "test");
    ASSERT_TRUE(again.ok()) << again.error().text();
    EXPECT_TRUE(toJson(*again) == json);
}

TEST(Actor, JsonErrorsNameTheThing) {
    auto json = toJson(defaultActor());
    json["joints"][3]["offset_m"] = {1, 2};
    auto broken = actorFromJson(json, "a.json");
    ASSERT_FALSE(broken.ok());
    EXPECT_NE(broken.error().message.find("a.json: joint number 3"), std::string::npos);
    EXPECT_FALSE(actorFromJson(nlohmann::json::array(), "x").ok());
    json = toJson(defaultActor());
    json["capsules"][0]["segment"] = "Tail";
    broken = actorFromJson(json, "a.json");
    ASSERT_FALSE(broken.ok());
    EXPECT_NE(broken.error().message.find("Tail"), std::string::npos);
    json = toJson(defaultActor());
    json["rest"]["q"][2] = {0, 0, 0, 0};
    EXPECT_FALSE(actorFromJson(json, "a.json").ok());
}

}  // namespace
}  // namespace noctule
