// SPDX-License-Identifier: Apache-2.0
// Lengths of the figure in a motion file, from where its joints are in the frames.
#pragma once

#include "core/body/actor.h"
#include "core/figure/alignment.h"

namespace noctule::figure {

/// The figure as it would stand upright: bones by their medians over the motion. Metres; hand 0 without
/// fingers or tip, foot 0 without toes.
BodyMeasures measure(const MotionClip& clip, const SeenMotion& seen, const JointMapping& mapping);

/// Stature in the file's unit from legs and trunk alone, whatever the zero pose and the up axis are: a person
/// of 1.75 m has legs of 0.86 m and 0.45 m from hip joints to shoulder joints.
double statureOf(const SeenMotion& seen, const JointMapping& mapping);

}  // namespace noctule::figure
