// SPDX-License-Identifier: Apache-2.0
// Where the front of a figure is, and so which of its sides is the left: toes point forward, knees bend
// forward and elbows backward. Says whether the joints that are called left are there.
#pragma once

#include "core/figure/joint_mapping.h"

namespace noctule::figure {

struct Sides {
    bool legs_exchanged = false, arms_exchanged = false;
    bool unknown = false;  ///< neither toes nor bent limbs show the front
};

/// Judges a mapping with all limbs; hands, feet and toes may be absent.
Sides judgeSides(const MotionClip& clip, const SeenMotion& seen, const JointMapping& mapping);

/// Whether a canonical joint belongs to the "legs" or to the "arms".
bool isOfLimbs(const std::string& joint, const std::string& limbs);
/// The same joints with left and right exchanged.
JointMapping exchanged(const JointMapping& mapping, const Sides& sides);

/// From between the hip joints to between the shoulders.
Vector3d trunkOf(const GlobalPose& pose, const JointMapping& mapping);
/// From between the ankles (knees where there are none) to between the hip joints.
Vector3d legsOf(const GlobalPose& pose, const JointMapping& mapping);

}  // namespace noctule::figure
