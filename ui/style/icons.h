// SPDX-License-Identifier: Apache-2.0
// Draws the icons of resources/icons in any colour: the drawings hold one colour, which is replaced in their
// text.
#pragma once

#include <QColor>
#include <QIcon>
#include <QPixmap>
#include <QString>

namespace noctule::ui {

/// `size_px` logical pixels at `ratio` physical ones each. Cached. An unknown name gives a crossed box
/// and a warning in the category noctule.icons, which fails every test of the studio.
QPixmap drawIcon(const QString& name, int size_px, const QColor& color, double ratio);

/// Drawn anew for each size and screen that asks.
struct IconColors {
    QColor normal, active, checked, disabled;
};
QIcon makeIcon(const QString& name, const IconColors& colors);

}  // namespace noctule::ui
