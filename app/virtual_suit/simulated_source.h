// SPDX-License-Identifier: Apache-2.0
// A performer who wears the suit, simulated as the sound is asked for.
#pragma once

#include "app/virtual_suit/sound_source.h"
#include "core/simulation/simulate.h"

namespace noctule::virtual_suit {

/// As long as the stage's performance lasts.
SoundOfSuit makeSimulatedSource(simulation::Stage stage);

}  // namespace noctule::virtual_suit
