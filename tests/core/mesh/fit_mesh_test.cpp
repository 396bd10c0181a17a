// SPDX-License-Identifier: Apache-2.0
// A body in another performer's measures, and bones that follow joints which the performer's skeleton lacks.
#include "core/mesh/retarget/fit_mesh.h"

#include <gtest/gtest.h>

#include "core/body/actor.h"
#include "core/math/rotation.h"
#include "core/mesh/skinning.h"

namespace noctule {
namespace {

using Eigen::Vector3f;

/// A ring of points round the middle of every segment that ends in a child, wholly its own.
SkinnedMesh rings(const Skeleton& skeleton) {
    SkinnedMesh mesh;
    mesh.bones = bonesOf(skeleton);
    const GlobalPose bind = globalPose(skeleton, bindPose(skeleton));
    for (int j = 1; j < skeleton.size(); ++j) {
        const size_t parent = static_cast<size_t>(skeleton.joint(j).parent);
        const Vector3d middle_m =
            (bind.p_world_joint[parent] + bind.p_world_joint[static_cast<size_t>(j)]) / 2;
        for (const Vector3d& aside : {Vector3d(0.04, 0, 0), Vector3d(0, 0.04, 0), Vector3d(0, 0, 0.04)})
            mesh.vertices.push_back({(middle_m + aside).cast<float>(),
                                     aside.normalized().cast<float>(),
                                     {static_cast<uint16_t>(parent), 0, 0, 0},
                                     {1, 0, 0, 0}});
    }
    return mesh;
}

Vector3f jointOf(const SkinnedMesh& mesh, size_t bone) {
    return -mesh.bones[bone].bind_inverse.topRightCorner<3, 1>();
}

TEST(FitMesh, TheSameMeasuresChangeNothing) {
    const Skeleton skeleton = defaultActor().skeleton;
    const SkinnedMesh mesh = rings(skeleton), same = fitted(mesh, skeleton, skeleton);
    for (size_t v = 0; v < mesh.vertices.size(); ++v) {
        EXPECT_LT((same.vertices[v].p_m - mesh.vertices[v].p_m).norm(), 1e-6F);
        EXPECT_LT((same.vertices[v].normal - mesh.vertices[v].normal).norm(), 1e-6F);
    }
}

TEST(FitMesh, ATallerActorIsLargerAllOver) {
    const Skeleton from = defaultActor().skeleton, to = defaultActor({.height_m = 1.925}).skeleton;
    const SkinnedMesh mesh = rings(from), taller = fitted(mesh, from, to);
    for (size_t v = 0; v < mesh.vertices.size(); ++v)
        EXPECT_LT((taller.vertices[v].p_m - 1.1F * mesh.vertices[v].p_m).norm(), 1e-4F) << v;
}

TEST(FitMesh, BonesStandInThePerformersJoints) {
    const Skeleton from = defaultActor().skeleton;
    const Skeleton to = defaultActor({.height_m = 1.62, .upper_arm_m = 0.33, .thigh_m = 0.36}).skeleton;
    const SkinnedMesh mesh = fitted(rings(from), from, to);
    const GlobalPose bind = globalPose(to, bindPose(to));
    for (size_t b = 0; b < mesh.bones.size(); ++b)
        EXPECT_LT((jointOf(mesh, b) - bind.p_world_joint[b].cast<float>()).norm(), 1e-5F)
            << mesh.bones[b].joint;
}

/// A skeleton whose hands end at the knuckles has whole hands all the same.
TEST(FitMesh, HandsAreNotCrushedIntoAWrongTip) {
    const Skeleton from = defaultActor().skeleton, to = defaultActor({.hand_m = 0.04}).skeleton;
    SkinnedMesh hand;
    hand.bones = bonesOf(from);
    const auto bone = static_cast<size_t>(from.find("LeftHand"));
    const Vector3f wrist = jointOf(hand, bone), finger = wrist + Vector3f(0.17F, 0, 0);
    hand.vertices.push_back({finger, Vector3f::UnitX(), {static_cast<uint16_t>(bone)}, {1, 0, 0, 0}});
    const SkinnedMesh after = fitted(hand, from, to);
    EXPECT_NEAR((after.vertices[0].p_m - jointOf(after, bone)).norm(), 0.17, 1e-5);
}

/// Legs apart in the zero pose, and feet that lie flat when they are tilted back: the body's legs and feet
/// are.
TEST(FitMesh, LegsAndFeetTurnAsThePerformersDo) {
    const Skeleton from = defaultActor().skeleton;
    std::vector<Joint> joints = from.joints();
    const Quaterniond apart = axisAngle(Vector3d::UnitZ(), radians(20));
    for (Joint& joint : joints)
        if (joint.name == "LeftLeg" || joint.name == "LeftFoot")
            joint.offset_m = apart * joint.offset_m;
    const Skeleton to = Skeleton::make(joints).value();
    const SkinnedMesh before = rings(from);
    const SkinnedMesh after = fitted(before, from, to, {{apart * Vector3d::UnitY(), Vector3d::UnitY()}});
    int seen = 0;
    for (size_t v = 0; v < before.vertices.size(); ++v) {
        const auto bone = static_cast<size_t>(before.vertices[v].bones[0]);
        const std::string& joint = before.bones[bone].joint;
        const bool is_turned = joint == "LeftUpLeg" || joint == "LeftLeg" || joint == "LeftFoot";
        if (!is_turned && joint != "RightLeg")
            continue;
        const Vector3d was = (before.vertices[v].p_m - jointOf(before, bone)).cast<double>();
        const Vector3d is = (after.vertices[v].p_m - jointOf(after, bone)).cast<double>();
        const Vector3d turned = is_turned ? Vector3d(apart * was) : was;
        EXPECT_LT((is.normalized() - turned.normalized()).norm(), 0.03) << joint;
        ++seen;
    }
    EXPECT_EQ(seen, 12);
}

TEST(FitMesh, LongerArmsAreNotThicker) {
    const Skeleton from = defaultActor().skeleton, to = defaultActor({.upper_arm_m = 0.40}).skeleton;
    const SkinnedMesh before = rings(from), after = fitted(before, from, to);
    const size_t bone = static_cast<size_t>(from.find("LeftArm"));
    int seen = 0;
    for (size_t v = 0; v < before.vertices.size(); ++v) {
        if (before.vertices[v].bones[0] != bone)
            continue;
        const Vector3f a = before.vertices[v].p_m - jointOf(before, bone);
        const Vector3f b = after.vertices[v].p_m - jointOf(after, bone);
        EXPECT_NEAR(b.x(), a.x() * 0.40F / 0.29F, 1e-5);
        EXPECT_NEAR(b.y(), a.y(), 1e-5);
        EXPECT_NEAR(b.z(), a.z(), 1e-5);
        ++seen;
    }
    EXPECT_EQ(seen, 3);
}

TEST(Skinning, ABoneWithoutItsJointFollowsTheOneAbove) {
    const Skeleton full = defaultActor().skeleton;
    std::vector<Joint> joints = full.joints();
    while (joints.back().name != "RightLeg")
        joints.pop_back();
    const Skeleton without_foot = Skeleton::make(joints).value();
    const SkinnedMesh mesh = rings(full);
    Pose pose = without_foot.zeroPose();
    pose.q_parent_joint.back() = axisAngle(Vector3d::UnitX(), 1.0);
    const auto matrices = skinMatrices(mesh, without_foot, globalPose(without_foot, pose));
    const size_t shin = static_cast<size_t>(full.find("RightLeg"));
    EXPECT_EQ(matrices[shin], matrices[static_cast<size_t>(full.find("RightFoot"))]);
    EXPECT_EQ(matrices[shin], matrices[static_cast<size_t>(full.find("RightToeBase"))]);
    EXPECT_NE(matrices[shin], matrices[static_cast<size_t>(full.find("RightUpLeg"))]);
}

TEST(Skinning, AMovedRootCarriesTheWholeBody) {
    const Skeleton skeleton = defaultActor().skeleton;
    const SkinnedMesh mesh = rings(skeleton);
    Pose pose = bindPose(skeleton);
    pose.p_world_root += Vector3d(1, 0.5, -2);
    const PosedSurface moved = skinned(mesh, skinMatrices(mesh, skeleton, globalPose(skeleton, pose)));
    for (size_t v = 0; v < mesh.vertices.size(); ++v) {
        EXPECT_LT((moved.points_m[v] - mesh.vertices[v].p_m - Vector3f(1, 0.5F, -2)).norm(), 1e-5F);
        EXPECT_LT((moved.normals[v] - mesh.vertices[v].normal).norm(), 1e-6F);
    }
}

TEST(Skinning, ABentElbowMovesTheForearmOnly) {
    const Skeleton skeleton = defaultActor().skeleton;
    const SkinnedMesh mesh = rings(skeleton);
    Pose pose = bindPose(skeleton);
    pose.q_parent_joint[static_cast<size_t>(skeleton.find("LeftForeArm"))] =
        axisAngle(-Vector3d::UnitY(), std::numbers::pi / 2);
    const PosedSurface bent = skinned(mesh, skinMatrices(mesh, skeleton, globalPose(skeleton, pose)));
    const size_t forearm = static_cast<size_t>(skeleton.find("LeftForeArm"));
    for (size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (mesh.vertices[v].bones[0] == forearm) {
            const Vector3f a = mesh.vertices[v].p_m - jointOf(mesh, forearm);
            EXPECT_LT((bent.points_m[v] - jointOf(mesh, forearm) - Vector3f(-a.z(), a.y(), a.x())).norm(),
                      1e-5F);
        } else if (mesh.vertices[v].bones[0] < forearm) {
            EXPECT_LT((bent.points_m[v] - mesh.vertices[v].p_m).norm(), 1e-5F);
        }
    }
}

}  // namespace
}  // namespace noctule
