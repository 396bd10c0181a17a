// SPDX-License-Identifier: Apache-2.0
// Removes what motion files carry besides motion: values that are no numbers are refused, single frames that
// jump away and back are bridged, and a calibration pose in front of the motion is dropped.
#pragma once

#include "core/motion/clip.h"

namespace noctule::simulation {

struct CleanedMotion {
    MotionClip clip;
    int repaired_frames = 0;
    bool dropped_first_frame = false;
};

/// Fails (kUnusable) and names frame and joint when a value is not finite, or when there is no frame.
Result<CleanedMotion> cleanMotion(MotionClip clip);

}  // namespace noctule::simulation
