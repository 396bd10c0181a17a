// SPDX-License-Identifier: Apache-2.0
// How far the rotation of each bone can be trusted, as one number from 0 to 1 for files that have a place for
// it: 1 / (1 + (sigma / 5 degrees)^2) of the estimator's standard deviation, so 0.5 at five degrees.
#pragma once

#include <vector>

#include "core/motion/timed_poses.h"

namespace noctule {

/// One value per joint, from the frame nearest to the instant; a joint that cannot move is trusted as its
/// parent. Empty when the frame tells no deviations.
std::vector<float> boneConfidence(const TimedMotion& motion, int64_t time_ns);

}  // namespace noctule
