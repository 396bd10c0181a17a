// SPDX-License-Identifier: Apache-2.0
// Scroll bars, sliders, combo boxes, spin boxes.
#include "ui/style/paint.h"
#include "ui/style/style_parts.h"

namespace noctule::ui::parts {

namespace {

bool isPressed(const QStyleOptionComplex& option, QStyle::SubControl part) {
    return (option.state & QStyle::State_Sunken) && (option.activeSubControls & part);
}

}  // namespace

void paintScrollBar(const QStyleOptionSlider& option, const QRect& slider, QPainter& painter,
                    const Theme& theme) {
    const Tokens& tokens = theme.tokens();
    if (option.maximum <= option.minimum)
        return;
    const bool lit = is(option, QStyle::State_MouseOver) || isPressed(option, QStyle::SC_ScrollBarSlider);
    const int margin = theme.px(lit ? 2 : 3);
    const QRect bar = option.orientation == Qt::Vertical ? slider.adjusted(margin, 2, -margin, -2)
                                                         : slider.adjusted(2, margin, -2, -margin);
    paintBox(painter, bar, std::min(bar.width(), bar.height()) / 2.0, lit ? tokens.t3 : tokens.edge);
}

void paintSlider(const QStyleOptionSlider& option, const QRect& groove, const QRect& handle,
                 QPainter& painter, const Theme& theme) {
    const Tokens& tokens = theme.tokens();
    const bool enabled = is(option, QStyle::State_Enabled);
    const bool horizontal = option.orientation == Qt::Horizontal;
    QRect line = groove;
    if (horizontal) {
        line.setHeight(theme.px(4));
        line.moveTop(groove.center().y() - theme.px(4) / 2);
    } else {
        line.setWidth(theme.px(4));
        line.moveLeft(groove.center().x() - theme.px(4) / 2);
    }
    paintBox(painter, line, theme.px(2), tokens.ctlh);
    QRect done = line;
    const bool at_right = option.upsideDown;
    if (horizontal)
        at_right ? done.setLeft(handle.center().x()) : done.setRight(handle.center().x());
    else
        at_right ? done.setTop(handle.center().y()) : done.setBottom(handle.center().y());
    paintBox(painter, done, theme.px(2), enabled ? tokens.acc : tokens.t3);
    const int side = theme.px(14);
    QRect knob(0, 0, side, side);
    knob.moveCenter(handle.center());
    paintBox(painter, knob, side / 2.0, enabled ? tokens.acc : tokens.t3);
    paintBox(painter, knob.adjusted(4, 4, -4, -4), side / 2.0,
             isPressed(option, QStyle::SC_SliderHandle) ? tokens.acc : tokens.onacc);
}

void paintComboBox(const QStyleOptionComboBox& option, QPainter& painter, const Theme& theme) {
    const Tokens& tokens = theme.tokens();
    const Surface surface = surfaceOf(option, theme);
    const bool focus = is(option, QStyle::State_HasFocus) && is(option, QStyle::State_Enabled);
    if (option.frame)
        paintBox(painter, option.rect, theme.px(4), surface.fill, focus ? tokens.acc : surface.edge);
    const QRect arrow(option.rect.right() - theme.px(26), option.rect.top(), theme.px(22),
                      option.rect.height());
    paintIcon(painter, arrow, "down", theme.px(14),
              is(option, QStyle::State_Enabled) ? tokens.t2 : tokens.t3);
}

void paintSpinBox(const QStyleOptionSpinBox& option, const QRect& up, const QRect& down, QPainter& painter,
                  const Theme& theme) {
    const Tokens& tokens = theme.tokens();
    if (option.frame)
        paintEdit(option, painter, theme);
    if (option.buttonSymbols == QAbstractSpinBox::NoButtons)
        return;
    const auto arrow = [&](const QRect& rect, const QString& name, QStyle::SubControl part,
                           QAbstractSpinBox::StepEnabledFlag step) {
        const bool enabled = is(option, QStyle::State_Enabled) && (option.stepEnabled & step);
        const bool hovered = (option.activeSubControls & part) && is(option, QStyle::State_MouseOver);
        if (enabled && hovered)
            paintBox(painter, rect.adjusted(1, 1, -1, -1), theme.px(3), tokens.ctlh);
        paintIcon(painter, rect, name, theme.px(10),
                  enabled ? tokens.t2 : mixed(tokens.panel, tokens.t3, 0.5));
    };
    arrow(up, "up", QStyle::SC_SpinBoxUp, QAbstractSpinBox::StepUpEnabled);
    arrow(down, "down", QStyle::SC_SpinBoxDown, QAbstractSpinBox::StepDownEnabled);
}

}  // namespace noctule::ui::parts
