// SPDX-License-Identifier: Apache-2.0
// A motion as it is seen: where all joints are in some of its frames, whatever the file's zero pose is. Means
// over these frames give lengths and directions that no rest pose distorts. Any unit of length.
#pragma once

#include <functional>
#include <vector>

#include "core/motion/clip.h"

namespace noctule::figure {

class SeenMotion {
public:
    /// At most `most` frames, evenly spread; 1000 leave means of directions exact to about 0.1 degree.
    explicit SeenMotion(const MotionClip& clip, size_t most = 1000);

    const std::vector<GlobalPose>& poses() const { return poses_; }
    /// Frame of the clip of each pose.
    const std::vector<size_t>& frames() const { return frames_; }

    /// Median distance between two joints.
    double distance(int a, int b) const;
    /// From joint `from` to joint `to`, in the frame of joint `frame`, mean over the poses.
    Vector3d between(int frame, int from, int to) const;
    Vector3d mean(const std::function<Vector3d(const GlobalPose&)>& of) const;
    double meanOf(const std::function<double(const GlobalPose&)>& of) const;

private:
    std::vector<GlobalPose> poses_;
    std::vector<size_t> frames_;
};

/// Joint positions where all frames are parallel to the world. Animated joint positions replace the offsets.
std::vector<Vector3d> zeroPositions(const MotionClip& clip);

/// Index of the joint in which the ways from two joints to the root meet.
int commonAncestor(const Skeleton& skeleton, int a, int b);
/// From just below `above` down to `joint`, both ends' order kept; empty when it does not hang there.
std::vector<int> chainBetween(const Skeleton& skeleton, int above, int joint);

}  // namespace noctule::figure
