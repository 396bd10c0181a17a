// SPDX-License-Identifier: Apache-2.0
// A motion on our joints is the same whatever its file's zero pose, axes, names and carriers are.
#include "core/figure/our_frames.h"

#include "tests/core/figure/dialects.h"

namespace noctule::figure {
namespace {

MotionClip onOurs(const MotionClip& clip) {
    const UnderstoodMotion motion = understood(clip);
    return inOurFrames(motion.clip, motion.joints, defaultActor().skeleton);
}

/// Mean angle between local rotations of the joints of ours, degrees, and the joint with the largest.
std::pair<double, std::string> localDifference(const MotionClip& a, const MotionClip& b) {
    std::pair<double, std::string> worst{0, ""};
    for (const std::string& joint : mainJoints()) {
        const int i = a.skeleton.find(joint), k = b.skeleton.find(joint);
        EXPECT_GE(i, 0) << joint;
        EXPECT_GE(k, 0) << joint;
        if (i < 0 || k < 0)
            continue;
        double sum = 0;
        for (size_t f = 0; f < a.frames.size(); ++f) {
            const auto local = [&](const MotionClip& clip, int j) {
                const GlobalPose pose = globalPose(clip, f);
                const auto hips = static_cast<size_t>(clip.skeleton.find("Hips"));
                return Quaterniond(pose.q_world_joint[hips].conjugate() *
                                   pose.q_world_joint[static_cast<size_t>(j)]);
            };
            sum += degrees(angleBetween(local(a, i), local(b, k)));
        }
        const double mean = sum / static_cast<double>(a.frames.size());
        if (mean > worst.first)
            worst = {mean, joint};
    }
    return worst;
}

std::map<std::string, Quaterniond> loweredArms(double angle_rad) {
    return {{"LeftArm", axisAngle(Vector3d::UnitZ(), -angle_rad)},
            {"RightArm", axisAngle(Vector3d::UnitZ(), angle_rad)}};
}

TEST(OurFrames, DialectsOfOneWalkHaveTheSameLocalRotations) {
    const MotionClip plain = onOurs(walk());
    const std::pair<const char*, MotionClip> dialects[] = {
        {"A pose", withZeroPose(walk(), loweredArms(0.7))},
        {"arms down", withZeroPose(walk(), loweredArms(1.45))},
        {"Z up", turnedInWorld(walk(), axisAngle(Vector3d::UnitX(), std::numbers::pi / 2))},
        {"other names", renamed(walk(), {{"LeftArm", "lShldr"}, {"LeftForeArm", "lForeArm"}})},
        {"moved joints", withPositionChannels(walk())},
    };
    for (const auto& [name, clip] : dialects) {
        const auto [deg, joint] = localDifference(plain, onOurs(clip));
        EXPECT_LT(deg, 1) << name << ", worst " << joint;
    }
    for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, -1)}) {
        const auto [deg, joint] =
            localDifference(plain, onOurs(alongAxis(walk(), axis, [](int) { return 0.5; })));
        EXPECT_LT(deg, 3) << axis.transpose() << ", worst " << joint;
    }
}

TEST(OurFrames, PlacesInTheWorldStay) {
    const UnderstoodMotion motion =
        understood(alongAxis(walk(), Vector3d::UnitX(), [](int j) { return 0.5 * j; }));
    const MotionClip ours = inOurFrames(motion.clip, motion.joints, defaultActor().skeleton);
    for (const size_t f : {size_t{0}, size_t{50}, ours.frames.size() - 1}) {
        const GlobalPose before = globalPose(motion.clip, f), after = globalPose(ours, f);
        for (const auto& [name, joint] : motion.joints)
            EXPECT_LT((before.p_world_joint[static_cast<size_t>(joint)] -
                       after.p_world_joint[static_cast<size_t>(ours.skeleton.find(name))])
                          .norm(),
                      1e-9)
                << name;
    }
}

TEST(OurFrames, ACarrierFarAwayIsNoBone) {
    MotionClip clip = walk();
    std::vector<Joint> joints = clip.skeleton.joints();
    Joint carrier;
    carrier.name = "Reference";
    carrier.type = JointType::kFree;
    for (Joint& joint : joints) {
        joint.parent += 1;
        if (joint.type == JointType::kFree) {
            joint.type = JointType::kBall;
            joint.dof = {{"x", Vector3d::UnitX()}, {"y", Vector3d::UnitY()}, {"z", Vector3d::UnitZ()}};
            joint.offset_m = Vector3d(0, 0, 15);
        }
    }
    joints.insert(joints.begin(), carrier);
    clip.skeleton = Skeleton::make(std::move(joints)).value();
    for (Pose& pose : clip.frames) {
        pose.q_parent_joint.insert(pose.q_parent_joint.begin(), Quaterniond::Identity());
        pose.p_world_root.z() -= 1;
    }
    const MotionClip ours = onOurs(clip);
    EXPECT_EQ(ours.skeleton.joint(0).name, "Hips");
    EXPECT_NEAR(ours.frames[0].p_world_root.z(), 14, 1e-6);
    EXPECT_LT(localDifference(onOurs(walk()), ours).first, 0.1);
}

TEST(OurFrames, WhatIsNotMappedCannotPassForOurs) {
    const MotionClip ours = onOurs(walk());
    EXPECT_LT(ours.skeleton.find("Spine1"), 0) << "a joint of the file that is none of ours";
    for (const Joint& joint : ours.skeleton.joints())
        EXPECT_TRUE(joint.name.rfind("unmapped ", 0) == 0 ||
                    std::ranges::count(canonicalJointNames(), joint.name) == 1)
            << joint.name;
}

}  // namespace
}  // namespace noctule::figure
