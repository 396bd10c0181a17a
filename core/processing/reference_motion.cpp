// SPDX-License-Identifier: Apache-2.0
#include "core/processing/reference_motion.h"

#include <algorithm>
#include <cmath>

#include "core/body/bone_names.h"
#include "core/body/joint_names.h"
#include "core/figure/our_frames.h"
#include "core/motion/common_joints.h"
#include "core/motion/segment_match.h"

namespace noctule {
namespace {

bool hasMainJoints(const Skeleton& skeleton) {
    return std::ranges::all_of(mainJoints(), [&](const auto& name) { return skeleton.find(name) >= 0; });
}

/// Our own exports and those that follow them: nothing has to be found, so nothing is changed.
bool isOurs(const Skeleton& clip, const Skeleton& target) {
    if (!hasMainJoints(clip) || !hasMainJoints(target))
        return false;
    const auto known = matchZeroPoses(target, clip, commonJoints(target, clip));
    return known && isSameFigure(*known);
}

/// Not so where a name says nothing and the joint was found by the figure's shape.
bool areFoundByName(const Skeleton& theirs, const figure::JointMapping& joints) {
    return std::ranges::all_of(
        joints, [&](const auto& mapped) { return findByAnyName(theirs, mapped.first) == mapped.second; });
}

}  // namespace

Skeleton skeletonOfClip(const MotionClip& clip) {
    if (clip.p_parent_joint_m.empty())
        return clip.skeleton;
    std::vector<Joint> joints = clip.skeleton.joints();
    for (size_t j = 1; j < joints.size(); ++j) {
        Vector3d sum = Vector3d::Zero();
        for (const std::vector<Vector3d>& p_parent_joint_m : clip.p_parent_joint_m)
            sum += p_parent_joint_m[j];
        joints[j].offset_m = sum / static_cast<double>(clip.p_parent_joint_m.size());
    }
    return Skeleton::make(std::move(joints)).value();
}

TimedMotion timedMotion(const MotionClip& clip) {
    TimedMotion motion{skeletonOfClip(clip), {}};
    motion.frames.reserve(clip.frames.size());
    for (size_t i = 0; i < clip.frames.size(); ++i)
        motion.frames.push_back(
            {std::llround(static_cast<double>(i) * clip.frame_time_s * 1e9), clip.frames[i], {}});
    return motion;
}

Actor actorOfClip(const MotionClip& clip) {
    Actor actor;
    actor.name = clip.name;
    std::vector<Joint> joints = skeletonOfClip(clip).joints();
    joints[0].offset_m.setZero();  // poses say where the root is; files put theirs anywhere
    actor.skeleton = Skeleton::make(std::move(joints)).value();
    const Pose zero = actor.skeleton.zeroPose();
    actor.rest_q_parent_joint = zero.q_parent_joint;
    const GlobalPose global = globalPose(actor.skeleton, zero);
    Eigen::AlignedBox3d box;
    for (size_t j = 0; j < global.p_world_joint.size(); ++j) {
        box.extend(global.p_world_joint[j]);
        if (const auto& end_m = actor.skeleton.joints()[j].end_m)
            box.extend(Vector3d(global.p_world_joint[j] + *end_m));
    }
    actor.height_m = box.sizes().y();
    return actor;
}

OutsideMotion::OutsideMotion(figure::UnderstoodMotion motion)
    : clip(std::move(motion.clip)),
      joints(std::move(motion.joints)),
      starts_s(static_cast<double>(motion.lost.cut_first) * clip.frame_time_s) {}

ReferenceMotion referenceFrom(const OutsideMotion& outside, const Skeleton& target) {
    ReferenceMotion reference;
    const Skeleton theirs = skeletonOfClip(outside.clip);
    reference.in_our_frames =
        outside.joints && (!isOurs(theirs, target) || !areFoundByName(theirs, *outside.joints));
    if (reference.in_our_frames) {
        const MotionClip ours = figure::inOurFrames(outside.clip, *outside.joints, target);
        reference.motion = timedMotion(ours);
        reference.actor = actorOfClip(ours);
        for (const auto& [name, joint] : *outside.joints)
            reference.names[name] = theirs.joint(joint).name;
    } else {
        reference.motion = timedMotion(outside.clip);
        reference.actor = actorOfClip(outside.clip);
    }
    for (TimedPose& frame : reference.motion.frames)
        frame.time_ns += std::llround(outside.starts_s * 1e9);
    return reference;
}

}  // namespace noctule
