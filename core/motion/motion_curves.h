// SPDX-License-Identifier: Apache-2.0
// Curves over time by which two recordings of one motion are recognised, whatever their skeletons, axes and
// rest poses are. On an even grid that starts at the motion's first frame.
#pragma once

#include <vector>

#include "core/motion/common_joints.h"
#include "core/motion/timed_poses.h"

namespace noctule {

struct AlignmentCurve {
    std::vector<float> values;
    double least_deviation = 0;  ///< standard deviation below which nobody moves
};

/// One curve per common joint (angular speed, rad/s), some per pair of hands, feet, head and hips (distance,
/// m), and the root's turn about the vertical (rad/s). `second`: of which of the two skeletons the motion is.
/// Equal lists of common joints give equal lists of curves.
std::vector<AlignmentCurve> motionCurves(const TimedMotion& motion, const std::vector<CommonJoint>& common,
                                         bool second, int64_t step_ns);

}  // namespace noctule
