// SPDX-License-Identifier: Apache-2.0
// The exercises of the calibration from movement, as the studio draws them: together they turn every joint
// that carries boards about each of its axes. People do them in their own way; nothing measures against this.
#pragma once

#include <string>

#include "core/body/actor.h"

namespace noctule {

enum class Exercise {
    kSquats,      ///< squats, elbows bending, wrists turning
    kArmCircles,  ///< both arms
    kLegSwings,   ///< one leg after the other, knees and feet too
    kTrunk,       ///< bends and turns
    kHead,        ///< nods and turns of the head, shrugs, hands
    kMarch,       ///< on the spot, arms swinging
};
inline constexpr int kExerciseCount = 6;

/// The exercise is there to move this segment. Of other bodies than the default actor's: none.
bool asksFor(Exercise exercise, const std::string& segment);

/// From and to the rest pose within its first and last second.
Pose exercisePose(const Actor& actor, Exercise exercise, double t_s, double lasts_s);

}  // namespace noctule
