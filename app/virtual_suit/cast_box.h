// SPDX-License-Identifier: Apache-2.0
// The box of one performer, or of the room, in a cast. Boxes that are started apart agree on the world by the
// cast, its seed and the instant at which it begins on the clock of the wall.
#pragma once

#include "app/virtual_suit/options.h"
#include "app/virtual_suit/sound_source.h"

namespace noctule::virtual_suit {

Result<SoundOfSuit> openCastBox(const Options& options);

}  // namespace noctule::virtual_suit
