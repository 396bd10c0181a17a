// SPDX-License-Identifier: Apache-2.0
// Boards side by side in the order of the suit, with the parts of the body below them.
#pragma once

#include <vector>

#include "core/suit/suit.h"
#include "ui/plots/pair_grid.h"

namespace noctule::ui {

std::vector<PairColumnGroup> columnGroups(const Suit& suit);

}  // namespace noctule::ui
