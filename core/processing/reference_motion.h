// SPDX-License-Identifier: Apache-2.0
// An animation on a clock of its own as a reference: frame n at n times its frame time. A motion that was
// understood goes onto our joints and frames first, whatever its names, axes and zero pose are.
#pragma once

#include <map>

#include "core/body/actor.h"
#include "core/figure/understood_motion.h"
#include "core/motion/clip.h"
#include "core/motion/timed_poses.h"

namespace noctule {

/// With the mean of animated joint positions in place of offsets that a file leaves empty.
Skeleton skeletonOfClip(const MotionClip& clip);

TimedMotion timedMotion(const MotionClip& clip);

/// Somebody with the clip's skeleton, who rests in its zero pose and has no flesh.
Actor actorOfClip(const MotionClip& clip);

/// A motion of another system, ready to become a reference.
struct OutsideMotion {
    OutsideMotion() = default;
    OutsideMotion(MotionClip motion) : clip(std::move(motion)) {}
    explicit OutsideMotion(figure::UnderstoodMotion motion);

    MotionClip clip;
    std::optional<figure::JointMapping> joints;  ///< as it was understood; none: its names and axes stay
    double starts_s = 0;  ///< first frame on the file's clock; later where lost frames were cut off
};

struct ReferenceMotion {
    TimedMotion motion;  ///< on the file's clock
    Actor actor;         ///< with its skeleton
    bool in_our_frames = false;
    std::map<std::string, std::string> names;  ///< our joint, the file's joint; empty when names are as found
};

/// `target`: the skeleton that it is compared with. A motion that has that skeleton's names and zero pose
/// stays exactly as it is.
ReferenceMotion referenceFrom(const OutsideMotion& outside, const Skeleton& target);

}  // namespace noctule
