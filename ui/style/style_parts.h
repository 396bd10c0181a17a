// SPDX-License-Identifier: Apache-2.0
// What StudioStyle draws, one function a control; inside ui/style only.
#pragma once

#include <QPainter>
#include <QStyleOption>

#include "ui/style/theme.h"

namespace noctule::ui::parts {

inline bool is(const QStyleOption& option, QStyle::StateFlag state) {
    return option.state & state;
}

/// Surface and edge of a control that stands on a panel, in the state of `option`.
struct Surface {
    QColor fill, edge;
};
Surface surfaceOf(const QStyleOption& option, const Theme& theme);

void paintCheckBox(const QStyleOption& option, QPainter& painter, const Theme& theme);
void paintRadioButton(const QStyleOption& option, QPainter& painter, const Theme& theme);
void paintEdit(const QStyleOption& option, QPainter& painter, const Theme& theme);
void paintPushButton(const QStyleOptionButton& option, QPainter& painter, const Theme& theme);
void paintToolButtonPanel(const QStyleOption& option, QPainter& painter, const Theme& theme);
void paintItem(const QStyleOptionViewItem& option, QPainter& painter, const Theme& theme);

void paintMenuItem(const QStyleOptionMenuItem& option, QPainter& painter, const Theme& theme);
QSize menuItemSize(const QStyleOptionMenuItem& option, const Theme& theme);
void paintMenuBarItem(const QStyleOptionMenuItem& option, QPainter& painter, const Theme& theme);
void paintTab(const QStyleOptionTab& option, QPainter& painter, const Theme& theme);
void paintTabLabel(const QStyleOptionTab& option, QPainter& painter, const Theme& theme);
void paintHeaderSection(const QStyleOptionHeader& option, QPainter& painter, const Theme& theme);
void paintHeaderLabel(const QStyleOptionHeader& option, QPainter& painter, const Theme& theme);
void paintProgressGroove(const QStyleOptionProgressBar& option, QPainter& painter, const Theme& theme);
void paintProgress(const QStyleOptionProgressBar& option, QPainter& painter, const Theme& theme);
void paintDockTitle(const QStyleOptionDockWidget& option, QPainter& painter, const Theme& theme);

void paintScrollBar(const QStyleOptionSlider& option, const QRect& slider, QPainter& painter,
                    const Theme& theme);
void paintSlider(const QStyleOptionSlider& option, const QRect& groove, const QRect& handle,
                 QPainter& painter, const Theme& theme);
void paintComboBox(const QStyleOptionComboBox& option, QPainter& painter, const Theme& theme);
void paintSpinBox(const QStyleOptionSpinBox& option, const QRect& up, const QRect& down, QPainter& painter,
                  const Theme& theme);

}  // namespace noctule::ui::parts
