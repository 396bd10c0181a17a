// SPDX-License-Identifier: Apache-2.0
// A performer who wears the suit, simulated as the sound is asked for.
#pragma once

#include <functional>

#include "app/virtual_suit/sound_source.h"
#include "core/simulation/cast.h"

namespace noctule::virtual_suit {

/// As long as the stage's performance lasts.
SoundOfSuit makeSimulatedSource(simulation::Stage stage);

/// One box of a cast. Its clock has been running since the cast began, and so have those of the others:
/// `since_start_s` tells how long ago that was (negative: it is still to come).
SoundOfSuit makeCastSource(simulation::Cast cast, size_t suit, std::function<double()> since_start_s);

}  // namespace noctule::virtual_suit
