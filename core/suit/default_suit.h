// SPDX-License-Identifier: Apache-2.0
// The suit that Noctule comes with: 18 boards and 8 sources, placed for the default actor of 1.75 m. In the
// rest pose about a third of the 144 pairs see each other, in motion about a quarter; the clavicles hear
// mainly the hat. resources/suits/*.json hold the same values for people; a test keeps them equal.
#pragma once

#include "core/suit/suit.h"

namespace noctule {

/// Full scales 17.5 rad/s and 16 g, which kicks and jumps need.
Suit defaultSuit();

/// The same layout with the ranges of the paper's sensors (Vlasic et al. 2007): 6.5 rad/s and 4 g.
Suit paperSuit();

}  // namespace noctule
