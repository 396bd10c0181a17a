// SPDX-License-Identifier: Apache-2.0
// The columns of a heat map of a suit: its boards, in groups by part of the body.
#pragma once

#include "core/suit/suit.h"
#include "ui/plots/pair_grid.h"

namespace noctule::ui {

/// Neighbours of one group stand under one name.
std::vector<PairColumnGroup> columnGroups(const Suit& suit);

}  // namespace noctule::ui
