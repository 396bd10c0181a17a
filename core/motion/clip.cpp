// SPDX-License-Identifier: Apache-2.0
#include "core/motion/clip.h"

#include "core/job/contract.h"

namespace noctule {

GlobalPose globalPose(const MotionClip& clip, size_t frame) {
    require(frame < clip.frames.size(), "the clip has no such frame");
    const Pose& pose = clip.frames[frame];
    if (clip.p_parent_joint_m.empty())
        return globalPose(clip.skeleton, pose);

    const std::vector<Joint>& joints = clip.skeleton.joints();
    const std::vector<Vector3d>& p_parent_joint_m = clip.p_parent_joint_m.at(frame);
    require(pose.q_parent_joint.size() == joints.size() && p_parent_joint_m.size() == joints.size(),
            "the pose does not fit the skeleton");
    GlobalPose global{{pose.p_world_root}, {pose.q_parent_joint[0]}};
    for (size_t j = 1; j < joints.size(); ++j) {
        const size_t parent = static_cast<size_t>(joints[j].parent);
        const Quaterniond q_world_parent = global.q_world_joint[parent];
        global.p_world_joint.push_back(global.p_world_joint[parent] + q_world_parent * p_parent_joint_m[j]);
        global.q_world_joint.push_back(q_world_parent * pose.q_parent_joint[j]);
    }
    return global;
}

}  // namespace noctule
