// SPDX-License-Identifier: Apache-2.0
// Legend of a lane: what each line and symbol is, in words, right-aligned in the title row.
#pragma once

#include <QPainter>
#include <QRect>

#include "ui/plots/lane_content.h"

namespace noctule::ui {

/// Draws as many entries as fit, the first ones first; returns where the leftmost begins.
int paintLaneLegend(QPainter& painter, const QRect& row, const LaneContent& content);

}  // namespace noctule::ui
