// SPDX-License-Identifier: Apache-2.0
// A performer who wears the suit, simulated as the sound is asked for.
#pragma once

#include "app/virtual_suit/sound_source.h"
#include "core/simulation/cast.h"

namespace noctule::virtual_suit {

/// As long as the stage's performance lasts.
SoundOfSuit makeSimulatedSource(simulation::Stage stage);

/// One box of a cast that begins at that instant (nowNs()). Its clock runs from then on, and so do those of
/// the others.
SoundOfSuit makeCastSource(simulation::Cast cast, size_t suit, int64_t start_ns);

}  // namespace noctule::virtual_suit
