// SPDX-License-Identifier: Apache-2.0
// Our pose on other rigs: limbs point the same way in the world, soles stand on the ground.
#include "core/mesh/retarget/retarget.h"

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
    const auto retargeter = Retargeter::make(target, map, walk().skeleton, {}, name);
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
    const auto retargeter = Retargeter::make(rig, findBoneMap(rig), walk().skeleton, {}, "rig");
    ASSERT_TRUE(retargeter);
    EXPECT_NEAR(retargeter->scale(), 1, 1e-4);
    for (size_t f = 0; f < walk().frames.size(); f += 100) {
        const GlobalPose ours = globalPose(walk().skeleton, walk().frames[f]);
        const RigPose theirs = retargeter->pose(walk().frames[f]);
        for (int j = 0; j < walk().skeleton.size(); ++j) {
            const std::string& name = walk().skeleton.joint(j).name;
            const auto& T = theirs[static_cast<size_t>(rig.find(name))];
            const bool lies_flat = name.ends_with("Foot") || name.ends_with("ToeBase");
            EXPECT_LT((T.linear() - ours.q_world_joint[static_cast<size_t>(j)].toRotationMatrix()).norm(),
                      lies_flat ? 1e-3 : 1e-6);
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
    const auto retargeter = Retargeter::make(rig, crossed, walk().skeleton, {}, "rig");
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
    const auto retargeter = Retargeter::make(rig, findBoneMap(rig), walk().skeleton, {}, "rig");
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

/// How far the feet wander from where ours would stand, at our size: what a planted foot can slide.
double worstWander_m(const RiggedMesh& rig, const std::string& name) {
    const BoneMap map = findBoneMap(rig);
    const auto retargeter = Retargeter::make(rig, map, walk().skeleton, {}, name);
    double worst = 0;
    for (const char* foot : {"LeftFoot", "RightFoot"}) {
        Vector3d first = Vector3d::Zero();
        for (size_t f = 0; f < walk().frames.size(); f += 10) {
            const Vector3d ours = globalPose(walk().skeleton, walk().frames[f])
                                      .p_world_joint[static_cast<size_t>(walk().skeleton.find(foot))];
            const RigPose pose = retargeter->pose(walk().frames[f]);
            const Vector3d theirs =
                pose[static_cast<size_t>(rig.find(map.node_of_joint.at(foot)))].translation();
            Vector3d off = theirs / retargeter->scale() - ours;
            off.y() = 0;
            if (f == 0)
                first = off;
            worst = std::max(worst, (off - first).norm());
        }
    }
    std::printf("%s: feet wander %.0f mm at most\n", name.c_str(), 1e3 * worst);
    return worst;
}

/// Four fingers ahead of each hand and a thumb that the rest pose turns about the arm by `palm_deg`.
RiggedMesh rigWithFingers(double palm_deg) {
    RiggedMesh rig = namedRig([](const std::string& joint) { return joint; });
    for (const double side : {1.0, -1.0}) {
        const int hand = rig.find(side > 0 ? "LeftHand" : "RightHand");
        const Quaterniond palm = axisAngle(Vector3d::UnitX(), radians(palm_deg));
        for (int finger = 0; finger < 5; ++finger) {
            const Vector3d end = finger == 0 ? palm * Vector3d(0.08 * side, -0.02, 0.08)
                                             : Vector3d(0.18 * side, 0, 0.005 * finger);
            RigNode node{(side > 0 ? "L" : "R") + std::to_string(finger), hand};
            node.T_parent_node = Eigen::Translation3d(end);
            node.T_world_rest = rig.nodes[static_cast<size_t>(hand)].T_world_rest * node.T_parent_node;
            rig.nodes.push_back(node);
        }
    }
    return rig;
}

TEST(Retarget, PalmsFaceAsOursWhateverTheRestPose) {
    for (const double palm_deg : {0.0, 45.0, -80.0}) {
        const RiggedMesh rig = rigWithFingers(palm_deg);
        const BoneMap map = findBoneMap(rig);
        const auto retargeter = Retargeter::make(rig, map, walk().skeleton, {}, "rig");
        ASSERT_TRUE(retargeter);
        EXPECT_LT(worstLimb_deg(rig, map, *retargeter, walk()), 0.01);
        const RigPose pose = retargeter->pose(bindPose(walk().skeleton));
        for (const char* side : {"L", "R"}) {
            const auto& hand = pose[static_cast<size_t>(rig.find(*side == 'L' ? "LeftHand" : "RightHand"))];
            Vector3d thumb = pose[static_cast<size_t>(rig.find(side + std::string("0")))].translation() -
                             hand.translation();
            thumb.x() = 0;
            EXPECT_LT(degrees(angleBetweenDirections(thumb, {0, -0.25, 1})), 3) << side << " " << palm_deg;
        }
    }
}

TEST(Retarget, FeetHardlyWander) {
    if (!test::isShared(test::kKenney))
        GTEST_SKIP() << test::sayMissing(test::kKenney);
    EXPECT_LT(worstWander_m(test::sharedMesh(test::kKenney), "Kenney"), 0.06);
    EXPECT_LT(worstWander_m(test::sharedMesh(test::kCesiumMan), "CesiumMan"), 0.06);
    EXPECT_LT(worstWander_m(test::MakeHuman().mesh(), "MakeHuman"), 0.06);
}

/// Programs hide what they do not show by a scale of zero.
TEST(Retarget, NodesWithoutSizeHurtNothing) {
    RiggedMesh rig =
        namedRig([](const std::string& joint) { return joint; }, aPose, 1, expQuaternion({1, 2, 0}));
    const auto whole = Retargeter::make(rig, findBoneMap(rig), walk().skeleton, {}, "rig");
    RigNode hidden{"hidden", rig.find("LeftHand")};
    hidden.T_world_rest.linear().setZero();
    hidden.T_world_rest.translation() = Vector3d(0.8, 1.4, 0);
    RigNode held{"held", static_cast<int>(rig.nodes.size())};
    held.T_world_rest = hidden.T_world_rest;
    rig.nodes.insert(rig.nodes.end(), {hidden, held});
    const auto retargeter = Retargeter::make(rig, findBoneMap(rig), walk().skeleton, {}, "rig");
    ASSERT_TRUE(whole && retargeter);
    const RigPose pose = retargeter->pose(walk().frames[200]), expected = whole->pose(walk().frames[200]);
    for (size_t n = 0; n < pose.size(); ++n)
        EXPECT_TRUE(pose[n].matrix().allFinite()) << rig.nodes[n].name;
    for (size_t n = 0; n < expected.size(); ++n)
        EXPECT_LT((pose[n].matrix() - expected[n].matrix()).norm(), 1e-12);
    const auto hand = static_cast<size_t>(rig.find("LeftHand"));
    EXPECT_NEAR((pose.back().translation() - pose[hand].translation()).norm(),
                (held.T_world_rest.translation() - rig.nodes[hand].T_world_rest.translation()).norm(), 1e-9)
        << "goes along with the hand";
}

}  // namespace
}  // namespace noctule
