// SPDX-License-Identifier: Apache-2.0
// The menu of "add channel": pairs by source, joints with their angles, boards; each can be added beside what
// is chosen, or taken away again.
#pragma once

#include <QMenu>

#include "ui/plots/plot_channels.h"

namespace noctule::ui {

/// Fills the menu anew for the take that is open.
void fillChannelMenu(QMenu& menu, ReviewContext& review, PlotChannels& channels);

}  // namespace noctule::ui
