// SPDX-License-Identifier: Apache-2.0
// Performers are a letter on a disc in their colour, A for the first of a take; the colour alone never says
// who.
#pragma once

#include <QPainter>
#include <QPixmap>
#include <QString>

namespace noctule::ui {

/// "A", "B" ... "Z", then "27".
QString performerLetter(int index);
QColor performerColor(int index);
void paintPerformerDisc(QPainter& painter, const QRectF& disc, int index);
QPixmap performerPixmap(int index, int size_px, double pixel_ratio);

}  // namespace noctule::ui
