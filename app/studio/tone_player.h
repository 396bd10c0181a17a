// SPDX-License-Identifier: Apache-2.0
// Plays the studio's tone on a chosen sound device, with the sound server's own programs pactl and paplay.
#pragma once

#include "ui/models/tones.h"

namespace noctule::studio {

/// Empty where the programs are missing.
ui::Tones::Player tonePlayer();

}  // namespace noctule::studio
