// SPDX-License-Identifier: Apache-2.0
// Boards and sources as an operator calls them: "board 7, left forearm". Numbers count from 1, places come
// from the segment's name ("LeftForeArm" -> "left forearm"), of a source from its id ("belly_l").
#pragma once

#include <string>

#include "core/suit/suit.h"

namespace noctule {

/// "left forearm"; the id of a board that is fixed in the room.
std::string boardPlace(const Suit& suit, int board);

/// "board 7, left forearm"
std::string boardWords(const Suit& suit, int board);
/// "Board 7, left forearm", at the beginning of a sentence.
std::string boardName(const Suit& suit, int board);

/// "7 (left forearm)", after "boards".
std::string boardInList(const Suit& suit, int board);

/// "Source 6, belly left", at the beginning of a sentence.
std::string sourceName(const Suit& suit, int source);

}  // namespace noctule
