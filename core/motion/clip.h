// SPDX-License-Identifier: Apache-2.0
// An animation: a skeleton and its pose at equal steps of time. Metres, seconds, world of math/conventions.h.
#pragma once

#include <string>
#include <vector>

#include "core/body/skeleton.h"

namespace noctule {

struct MotionClip {
    std::string name;
    Skeleton skeleton;  ///< of a file's own hierarchy: root free, all others ball
    double frame_time_s = 1.0 / 120;
    std::vector<Pose> frames;
    /// Per frame and joint the joint's position in its parent's frame, where a file animates it; it replaces
    /// offset_m. Empty when no joint but the root moves so.
    std::vector<std::vector<Vector3d>> p_parent_joint_m;

    double duration_s() const { return frame_time_s * static_cast<double>(frames.size()); }
};

/// World positions and orientations of all joints in one frame (joint translations taken into account).
GlobalPose globalPose(const MotionClip& clip, size_t frame);

}  // namespace noctule
