// SPDX-License-Identifier: Apache-2.0
// What would show that a motion was misunderstood: sizes and proportions that no person has, sides that
// differ, bones that change their length.
#pragma once

#include "core/figure/understood_motion.h"

namespace noctule::figure {

/// One sentence per doubt, with the option that helps.
std::vector<std::string> figureWarnings(const UnderstoodMotion& motion, const MotionHints& hints);

/// "T pose", "A pose", "arms down", "sitting", "bones along one axis", "bent trunk", "not a standing pose".
std::string restPoseInWords(const MotionClip& clip, const SeenMotion& seen, const JointMapping& joints);

/// Mean speed of wrists and ankles, m/s.
double extremitySpeed(const MotionClip& clip, const JointMapping& joints);

}  // namespace noctule::figure
