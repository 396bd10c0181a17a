// SPDX-License-Identifier: Apache-2.0
// Curves of a motion for plots: joint angles in degrees with what the estimator thinks of its own error, and
// the root's position, height and heading. Ball joints are shown as three angles free of jumps
// (motion/joint_angles.h), other joints by their named degrees of freedom within half a turn either way.
#pragma once

#include <string>
#include <vector>

#include "core/motion/timed_poses.h"
#include "core/review/series.h"

namespace noctule {

/// One curve: which joint, and which of its freedoms. Ids; the screen words them.
struct CurveChoice {
    std::string joint;  ///< "LeftLeg"
    /// Of the joint: "flexion"; balls "z", "x", "y" (the order of rotation); the root "left", "up",
    /// "forward" (m in the world, up is the height) and "yaw", "pitch", "roll".
    std::string freedom;

    bool operator==(const CurveChoice&) const = default;
    auto operator<=>(const CurveChoice&) const = default;
};

/// Everything of a skeleton that can be plotted, in its order, the root first.
std::vector<CurveChoice> curveChoices(const Skeleton& skeleton);

/// Of balls and hinges the freedom that tells most at a glance (flexion, or the first).
CurveChoice mainCurve(const Skeleton& skeleton, const std::string& joint);

enum class CurveUnit { kDegrees, kMetres };

struct MotionCurve {
    CurveUnit unit = CurveUnit::kDegrees;
    SeriesPyramid value;      ///< breaks where nothing was seen, and where a hinge passes half a turn
    SeriesPyramid low, high;  ///< value -+ 2 sigma; empty when the motion carries none
};

/// Empty when the motion's skeleton has no such joint or freedom. `freedoms_of`: whose joints the freedoms
/// are, where the motion's own may have others (a knee that is a ball); null: the motion's.
MotionCurve motionCurve(const TimedMotion& motion, const CurveChoice& choice,
                        const Skeleton* freedoms_of = nullptr);

}  // namespace noctule
