// SPDX-License-Identifier: Apache-2.0
// An understood motion with our names and frames on the joints that were mapped. Its zero pose is our
// standing pose, whatever the file's is, so that rotations compare with those of an estimate. Nothing is
// taken from that estimate: constant errors of either stay visible.
#pragma once

#include "core/figure/joint_mapping.h"

namespace noctule::figure {

/// `target`: the skeleton to compare with, whose bones and hinges are met; the default actor's when it lacks
/// our main joints. Positions in the world stay as they are. Joints that are not mapped keep their place in
/// the tree; their names change where they could pass for one of ours.
MotionClip inOurFrames(const MotionClip& clip, const JointMapping& joints, const Skeleton& target);

}  // namespace noctule::figure
