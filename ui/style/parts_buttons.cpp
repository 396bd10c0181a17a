// SPDX-License-Identifier: Apache-2.0
// Check boxes, radio buttons, push buttons, tool buttons, edits, rows of lists.
#include "ui/style/paint.h"
#include "ui/style/style_parts.h"

namespace noctule::ui::parts {

Surface surfaceOf(const QStyleOption& option, const Theme& theme) {
    const Tokens& tokens = theme.tokens();
    if (!is(option, QStyle::State_Enabled))
        return {tokens.panel, tokens.line};
    if (is(option, QStyle::State_Sunken) || is(option, QStyle::State_On))
        return {tokens.ctl, tokens.edge};
    return {is(option, QStyle::State_MouseOver) ? tokens.ctl : tokens.raised, tokens.edge};
}

void paintCheckBox(const QStyleOption& option, QPainter& painter, const Theme& theme) {
    const Tokens& tokens = theme.tokens();
    const bool enabled = is(option, QStyle::State_Enabled);
    const bool filled = is(option, QStyle::State_On) || is(option, QStyle::State_NoChange);
    const int side = std::min({option.rect.width(), option.rect.height(), theme.px(16)});
    QRect box(0, 0, side, side);
    box.moveCenter(option.rect.center());
    if (!filled) {
        const Surface surface = surfaceOf(option, theme);
        return paintBox(painter, box, theme.px(3), surface.fill, surface.edge);
    }
    const QColor fill = enabled ? tokens.acc : tokens.t3;
    const QColor mark = enabled ? tokens.onacc : tokens.panel;
    paintBox(painter, box, theme.px(3), fill);
    paintIcon(painter, box, is(option, QStyle::State_On) ? "check" : "minus", side - 2, mark);
}

void paintRadioButton(const QStyleOption& option, QPainter& painter, const Theme& theme) {
    const Tokens& tokens = theme.tokens();
    const bool enabled = is(option, QStyle::State_Enabled);
    const bool on = is(option, QStyle::State_On);
    const int side = std::min({option.rect.width(), option.rect.height(), theme.px(16)});
    QRectF circle(0, 0, side, side);
    circle.moveCenter(QRectF(option.rect).center());
    const Surface surface = surfaceOf(option, theme);
    if (!on)
        return paintBox(painter, circle, side / 2.0, surface.fill, surface.edge);
    paintBox(painter, circle, side / 2.0, enabled ? tokens.acc : tokens.t3);
    const double inset = side * 0.31;
    paintBox(painter, circle.adjusted(inset, inset, -inset, -inset), side,
             enabled ? tokens.onacc : tokens.panel);
}

void paintEdit(const QStyleOption& option, QPainter& painter, const Theme& theme) {
    const Tokens& tokens = theme.tokens();
    const bool enabled = is(option, QStyle::State_Enabled);
    const bool read_only = is(option, QStyle::State_ReadOnly);
    const bool focus = enabled && is(option, QStyle::State_HasFocus);
    const QColor edge = focus ? tokens.acc : enabled ? tokens.edge : tokens.line;
    paintBox(painter, option.rect, theme.px(4), enabled && !read_only ? tokens.raised : tokens.panel, edge);
}

void paintPushButton(const QStyleOptionButton& option, QPainter& painter, const Theme& theme) {
    const Tokens& tokens = theme.tokens();
    const bool enabled = is(option, QStyle::State_Enabled);
    if (option.features & QStyleOptionButton::Flat) {
        if (enabled && (is(option, QStyle::State_MouseOver) || is(option, QStyle::State_Sunken)))
            paintBox(painter, option.rect, theme.px(4), tokens.ctl);
        return;
    }
    if (enabled && (option.features & QStyleOptionButton::DefaultButton)) {
        const bool lit = is(option, QStyle::State_MouseOver) || is(option, QStyle::State_Sunken);
        return paintBox(painter, option.rect, theme.px(4),
                        lit ? mixed(tokens.acc, tokens.t1, 0.15) : tokens.acc);
    }
    const Surface surface = surfaceOf(option, theme);
    paintBox(painter, option.rect, theme.px(4), surface.fill, surface.edge);
}

void paintToolButtonPanel(const QStyleOption& option, QPainter& painter, const Theme& theme) {
    const Tokens& tokens = theme.tokens();
    if (!is(option, QStyle::State_Enabled))
        return;
    if (is(option, QStyle::State_On))
        paintBox(painter, option.rect, theme.px(4), tokens.sel);
    else if (is(option, QStyle::State_Sunken))
        paintBox(painter, option.rect, theme.px(4), tokens.ctlh);
    else if (is(option, QStyle::State_MouseOver))
        paintBox(painter, option.rect, theme.px(4), tokens.ctl);
}

void paintItem(const QStyleOptionViewItem& option, QPainter& painter, const Theme& theme) {
    const Tokens& tokens = theme.tokens();
    if (is(option, QStyle::State_Selected))
        painter.fillRect(option.rect, tokens.sel);
    else if (option.backgroundBrush.style() != Qt::NoBrush)
        painter.fillRect(option.rect, option.backgroundBrush);
    else if (is(option, QStyle::State_MouseOver) && is(option, QStyle::State_Enabled))
        painter.fillRect(option.rect, mixed(tokens.panel, tokens.ctl, 0.7));
}

}  // namespace noctule::ui::parts
