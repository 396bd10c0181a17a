// SPDX-License-Identifier: Apache-2.0
// Joints by the shape of a figure, whatever they are called: two pairs of like chains are legs and arms, each
// limb's two long bones show its joints, and toes, knees and elbows show where the front and so the left is.
#pragma once

#include "core/figure/joint_mapping.h"

namespace noctule::figure {

/// Empty when the figure does not have the shape of a person, or when nothing shows its left side.
JointMapping jointsByShape(const MotionClip& clip, const SeenMotion& seen);

}  // namespace noctule::figure
