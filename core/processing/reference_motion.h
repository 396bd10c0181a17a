// SPDX-License-Identifier: Apache-2.0
// An animation on a clock of its own as a reference: frame n at n times its frame time.
#pragma once

#include "core/body/actor.h"
#include "core/motion/clip.h"
#include "core/motion/timed_poses.h"

namespace noctule {

/// With the mean of animated joint positions in place of offsets that a file leaves empty.
Skeleton skeletonOfClip(const MotionClip& clip);

TimedMotion timedMotion(const MotionClip& clip);

/// Somebody with the clip's skeleton, who rests in its zero pose and has no flesh.
Actor actorOfClip(const MotionClip& clip);

}  // namespace noctule
