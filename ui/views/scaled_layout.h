// SPDX-License-Identifier: Apache-2.0
// Layouts in the sizes of the style guide (pixels at 100 percent) that follow the scale of the theme.
#pragma once

#include <QBoxLayout>
#include <QGridLayout>
#include <QMargins>
#include <QWidget>

namespace noctule::ui {

QVBoxLayout* makeColumn(QWidget* owner, const QMargins& margins = {}, int spacing = 0);
QHBoxLayout* makeRow(QWidget* owner, const QMargins& margins = {}, int spacing = 0);
QGridLayout* makeGrid(QWidget* owner, const QMargins& margins = {}, int spacing = 0);
/// A row within another layout; it lives in a widget of its own.
QHBoxLayout* addRow(QBoxLayout* into, int spacing = 8, const QMargins& margins = {});

/// Deletes the widgets from that one on.
void clearWidgets(QBoxLayout& layout, int from = 0);
/// Hides all its widgets and deletes them later: the button that was just pressed may be one of them.
void clearWidgetsLater(QBoxLayout& layout);

/// Fixed sizes; 0: free in that direction.
void keepSize(QWidget& widget, int width, int height);
void keepMinimumWidth(QWidget& widget, int width);
void keepMinimumHeight(QWidget& widget, int height);
void keepMaximumWidth(QWidget& widget, int width);
void keepMaximumHeight(QWidget& widget, int height);

}  // namespace noctule::ui
