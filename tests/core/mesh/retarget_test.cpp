// SPDX-License-Identifier: Apache-2.0
// Our pose on other rigs: limbs point the same way in the world, soles stand on the ground.
#include "core/mesh/retarget.h"

#include <gtest/gtest.h>

#include <random>

#include "core/body/actor.h"
#include "core/formats/bvh.h"
#include "core/math/rotation.h"
#include "tests/support/named_rig.h"
#include "tests/support/shared_meshes.h"

namespace noctule {
namespace {

using test::namedRig;

const MotionClip& walk() {
    static const MotionClip clip = [] {
        const auto document = readBvh(NOCTULE_SOURCE_DIR "/resources/motions/sample.bvh");
        return toClip(document.value(), BvhUnit::kCentimetre).value();
    }();
    return clip;
}

constexpr std::pair<const char*, const char*> kLimbs[] = {
    {"LeftArm", "LeftForeArm"},    {"LeftForeArm", "LeftHand"}, {"RightArm", "RightForeArm"},
    {"RightForeArm", "RightHand"}, {"LeftUpLeg", "LeftLeg"},    {"LeftLeg", "LeftFoot"},
    {"RightUpLeg", "RightLeg"},    {"RightLeg", "RightFoot"}};

double angleBetweenDirections(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The largest angle between a limb of ours and the target's, over some frames of a motion.
double worstLimb_deg(const RiggedMesh& target, const BoneMap& map, const Retargeter& retargeter,
                     const MotionClip& clip) {
    double worst = 0;
    for (size_t f = 0; f < clip.frames.size(); f += 37) {
        const GlobalPose ours = globalPose(clip.skeleton, clip.frames[f]);
        const RigPose theirs = retargeter.pose(clip.frames[f]);
        for (const auto& [from, to] : kLimbs) {
            const auto our = [&](const char* joint) {
                return ours.p_world_joint[static_cast<size_t>(clip.skeleton.find(joint))];
            };
            const auto their = [&](const char* joint) {
                return theirs[static_cast<size_t>(target.find(map.node_of_joint.at(joint)))].translation();
            };
            worst = std::max(worst, angleBetweenDirections(our(to) - our(from), their(to) - their(from)));
        }
    }
    return degrees(worst);
}

void expectFollows(const RiggedMesh& target, const std::string& name) {
    const BoneMap map = findBoneMap(target);
    const auto retargeter = Retargeter::make(target, map, walk().skeleton, name);
    ASSERT_TRUE(retargeter) << retargeter.error().text();
    EXPECT_LT(worstLimb_deg(target, map, *retargeter, walk()), 0.01) << name;
}

Quaterniond aPose(const std::string& joint) {
    const double side = joint.starts_with("Left") ? -1 : 1;
    if (joint == "LeftArm" || joint == "RightArm")
        return axisAngle(Vector3d::UnitZ(), side * radians(45));
    if (joint.ends_with("ForeArm"))
        return axisAngle(Vector3d::UnitY(), side * radians(15));
    return joint.ends_with("UpLeg") ? axisAngle(Vector3d::UnitZ(), -side * radians(6))
                                    : Quaterniond::Identity();
}

TEST(Retarget, ARigLikeOursGetsOurPoseItself) {
    const RiggedMesh rig = namedRig([](const std::string& joint) { return joint; });
    const auto retargeter = Retargeter::make(rig, findBoneMap(rig), walk().skeleton, "rig");
    ASSERT_TRUE(retargeter);
    EXPECT_NEAR(retargeter->scale(), 1, 1e-4);
    for (size_t f = 0; f < walk().frames.size(); f += 100) {
        const GlobalPose ours = globalPose(walk().skeleton, walk().frames[f]);
        const RigPose theirs = retargeter->pose(walk().frames[f]);
        for (int j = 0; j < walk().skeleton.size(); ++j) {
            const auto& T = theirs[static_cast<size_t>(rig.find(walk().skeleton.joint(j).name))];
            EXPECT_LT((T.linear() - ours.q_world_joint[static_cast<size_t>(j)].toRotationMatrix()).norm(),
                      1e-6);
            EXPECT_LT((T.translation() - ours.p_world_joint[static_cast<size_t>(j)]).norm(), 0.02);
        }
    }
}

TEST(Retarget, AnyRestPoseSizeAndFrameFollows) {
    const auto mixamo = [](const std::string& joint) { return "mixamorig:" + joint; };
    expectFollows(namedRig(mixamo), "T pose");
    expectFollows(namedRig(mixamo, aPose), "A pose");
    expectFollows(namedRig(mixamo, aPose, 3.1), "a giant");
    expectFollows(namedRig(mixamo, aPose, 0.2, expQuaternion({0.3, -2, 0.7})), "frames along bones");
    expectFollows(namedRig(mixamo,
                           [](const std::string& joint) {
                               return joint == "Hips" ? axisAngle(Vector3d::UnitY(), radians(90))
                                                      : aPose(joint);
                           }),
                  "faces to the side");
}

TEST(Retarget, OtherProgramsFiguresFollow) {
    if (!test::isShared(test::kKenney))
        GTEST_SKIP() << test::sayMissing(test::kKenney);
    expectFollows(test::sharedMesh(test::kKenney), "Kenney");
    expectFollows(test::sharedMesh(test::kCesiumMan), "CesiumMan");
    expectFollows(test::MakeHuman().mesh(), "MakeHuman");
}

TEST(Retarget, AWrongBoneIsSeenInTheLimbs) {
    const RiggedMesh rig = namedRig([](const std::string& joint) { return joint; }, aPose);
    const BoneMap good = findBoneMap(rig);
    BoneMap crossed = good;
    for (const char* limb : {"UpLeg", "Leg", "Foot", "ToeBase"})
        std::swap(crossed.node_of_joint[std::string("Left") + limb],
                  crossed.node_of_joint[std::string("Right") + limb]);
    const auto retargeter = Retargeter::make(rig, crossed, walk().skeleton, "rig");
    ASSERT_TRUE(retargeter);
    EXPECT_GT(worstLimb_deg(rig, good, *retargeter, walk()), 5);
}

double lowestFoot_m(const RiggedMesh& rig, const RigPose& pose) {
    double low = 1e9;
    for (const char* foot : {"LeftFoot", "RightFoot"})
        low = std::min(low, pose[static_cast<size_t>(rig.find(foot))].translation().y());
    return low;
}

TEST(Retarget, SolesStandOnTheGroundAndJumpsAreScaled) {
    // Shins a third longer than ours: a mere scale of the root would let the feet sink or float.
    RiggedMesh rig = namedRig([](const std::string& joint) { return joint; }, aPose, 1.4);
    for (RigNode& node : rig.nodes)
        if (node.name.ends_with("Foot") || node.name.ends_with("ToeBase"))
            node.T_world_rest.translation().y() -= 0.2;
    const auto retargeter = Retargeter::make(rig, findBoneMap(rig), walk().skeleton, "rig");
    ASSERT_TRUE(retargeter);
    const Pose standing = bindPose(walk().skeleton);
    const double ankle = lowestFoot_m(rig, retargeter->pose(standing));
    Pose jumping = standing;
    jumping.p_world_root.y() += 0.3;
    EXPECT_NEAR(lowestFoot_m(rig, retargeter->pose(jumping)) - ankle, 0.3 * retargeter->scale(), 1e-9);
    Pose crouching = standing;
    for (const char* joint : {"LeftUpLeg", "RightUpLeg", "LeftLeg", "RightLeg", "LeftFoot", "RightFoot"}) {
        const double turn = std::string(joint).ends_with("UpLeg") ? -50
                            : std::string(joint).ends_with("Leg") ? 90
                                                                  : -40;
        crouching.q_parent_joint[static_cast<size_t>(walk().skeleton.find(joint))] =
            axisAngle(Vector3d::UnitX(), radians(turn));
    }
    const GlobalPose ours = globalPose(walk().skeleton, crouching);
    const GlobalPose bound = globalPose(walk().skeleton, standing);
    const auto foot = static_cast<size_t>(walk().skeleton.find("LeftFoot"));
    crouching.p_world_root.y() += bound.p_world_joint[foot].y() - ours.p_world_joint[foot].y();
    EXPECT_NEAR(lowestFoot_m(rig, retargeter->pose(crouching)), ankle, 1e-9);
}

TEST(Retarget, LocalTransformsGiveThePoseBack) {
    const RiggedMesh rig =
        namedRig([](const std::string& joint) { return joint; }, aPose, 1, expQuaternion({1, 2, 0}));
    const auto retargeter = Retargeter::make(rig, findBoneMap(rig), walk().skeleton, "rig");
    ASSERT_TRUE(retargeter);
    const RigPose pose = retargeter->pose(walk().frames[200]);
    const RigPose again = posed(rig, localTransforms(rig, pose));
    for (size_t n = 0; n < pose.size(); ++n)
        EXPECT_LT((pose[n].matrix() - again[n].matrix()).norm(), 1e-9);
}

}  // namespace
}  // namespace noctule
