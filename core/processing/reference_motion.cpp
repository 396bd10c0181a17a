// SPDX-License-Identifier: Apache-2.0
#include "core/processing/reference_motion.h"

#include <cmath>

namespace noctule {

TimedMotion timedMotion(const MotionClip& clip) {
    TimedMotion motion{clip.skeleton, {}};
    motion.frames.reserve(clip.frames.size());
    for (size_t i = 0; i < clip.frames.size(); ++i)
        motion.frames.push_back(
            {std::llround(static_cast<double>(i) * clip.frame_time_s * 1e9), clip.frames[i], {}});
    return motion;
}

Actor actorOfClip(const MotionClip& clip) {
    Actor actor;
    actor.name = clip.name;
    actor.skeleton = clip.skeleton;
    const Pose zero = clip.skeleton.zeroPose();
    actor.rest_q_parent_joint = zero.q_parent_joint;
    const GlobalPose global = globalPose(clip.skeleton, zero);
    Eigen::AlignedBox3d box;
    for (size_t j = 0; j < global.p_world_joint.size(); ++j) {
        box.extend(global.p_world_joint[j]);
        if (const auto& end_m = clip.skeleton.joints()[j].end_m)
            box.extend(Vector3d(global.p_world_joint[j] + *end_m));
    }
    actor.height_m = box.sizes().y();
    return actor;
}

}  // namespace noctule
