// SPDX-License-Identifier: Apache-2.0
#include "core/processing/reference_motion.h"

#include <cmath>

namespace noctule {

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
    actor.skeleton = skeletonOfClip(clip);
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

}  // namespace noctule
