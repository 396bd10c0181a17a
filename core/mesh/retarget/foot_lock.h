// SPDX-License-Identifier: Apache-2.0
// Feet that stand, on a body of other proportions: legs of another shape, however well they are scaled, carry
// soles over the ground where ours stood still. While a foot stands, the ankle is moved so that the point of
// the sole that stands (heel, then toes) keeps its place, and the knee is bent for it (two-bone inverse
// kinematics, Retargeter::motions); before and after, the shift fades. The knee never turns faster for that
// than kMostKnee_rad_per_s, so that a stretched leg does not snap: the foot then gives way along the leg.
#pragma once

#include "core/mesh/retarget/retarget.h"

namespace noctule {

inline constexpr double kMostKnee_rad_per_s = 2;  ///< a walking knee turns with up to 7
inline constexpr double kMostOwnSlide_m = 0.05;   ///< of our own foot, that is taken away with the body's

/// What feet are locked by.
struct StandingFeet {
    std::vector<Pose> frames;  ///< with the root as captured; empty: feet stay free
    double frame_time_s = 0;
    FootPlants plants;  ///< seconds from the first frame
};

/// Per frame what keeps standing feet on their spot; it serves the same motion also when its root is held,
/// for it is told in the root's frame. Empty without frames.
std::vector<FootCorrections> lockFeet(const Retargeter& retargeter, const StandingFeet& feet);

}  // namespace noctule
