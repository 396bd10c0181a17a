// SPDX-License-Identifier: Apache-2.0
// Menus, tabs, table headers, progress bars, dock titles.
#include "ui/style/paint.h"
#include "ui/style/style_parts.h"

namespace noctule::ui::parts {

namespace {

constexpr int kMnemonics = Qt::TextHideMnemonic;

QColor textColor(const QStyleOption& option, const Theme& theme, const QColor& enabled) {
    return is(option, QStyle::State_Enabled) ? enabled : theme.tokens().t3;
}

}  // namespace

QSize menuItemSize(const QStyleOptionMenuItem& option, const Theme& theme) {
    if (option.menuItemType == QStyleOptionMenuItem::Separator)
        return {theme.px(10), theme.px(9)};
    const QFontMetrics metrics(option.font);
    const QStringList texts = option.text.split('\t');
    int width = theme.px(36 + 16) + metrics.size(kMnemonics, texts[0]).width();
    if (texts.size() > 1 || option.tabWidth > 0)
        width += theme.px(24);
    if (texts.size() > 1)
        width += std::max(0, metrics.horizontalAdvance(texts[1]) - option.tabWidth);
    if (option.menuItemType == QStyleOptionMenuItem::SubMenu)
        width += theme.px(20);
    return {width, std::max(theme.px(28), metrics.height() + theme.px(8))};
}

void paintMenuItem(const QStyleOptionMenuItem& option, QPainter& painter, const Theme& theme) {
    const Tokens& tokens = theme.tokens();
    const QRect rect = option.rect;
    if (option.menuItemType == QStyleOptionMenuItem::Separator) {
        painter.fillRect(QRect(rect.left(), rect.center().y(), rect.width(), 1), tokens.line);
        return;
    }
    if (is(option, QStyle::State_Selected) && is(option, QStyle::State_Enabled))
        paintBox(painter, rect.adjusted(theme.px(4), 0, -theme.px(4), 0), theme.px(4), tokens.sel);
    const QRect mark(rect.left() + theme.px(12), rect.top(), theme.px(16), rect.height());
    if (option.checkType != QStyleOptionMenuItem::NotCheckable && option.checked)
        paintIcon(painter, mark, "check", theme.px(16), textColor(option, theme, tokens.acc));
    else if (!option.icon.isNull())
        option.icon.paint(&painter, mark, Qt::AlignCenter,
                          is(option, QStyle::State_Enabled) ? QIcon::Normal : QIcon::Disabled);
    const QStringList texts = option.text.split('\t');
    const QRect words = rect.adjusted(theme.px(36), 0, -theme.px(16), 0);
    painter.setFont(option.font);
    painter.setPen(textColor(option, theme, tokens.t1));
    painter.drawText(words, Qt::AlignVCenter | Qt::AlignLeft | kMnemonics, texts[0]);
    if (texts.size() > 1) {
        painter.setPen(tokens.t3);
        painter.drawText(words, Qt::AlignVCenter | Qt::AlignRight, texts[1]);
    }
    if (option.menuItemType == QStyleOptionMenuItem::SubMenu)
        paintIcon(painter, QRect(rect.right() - theme.px(24), rect.top(), theme.px(16), rect.height()),
                  "chevron", theme.px(12), tokens.t2);
}

void paintMenuBarItem(const QStyleOptionMenuItem& option, QPainter& painter, const Theme& theme) {
    const Tokens& tokens = theme.tokens();
    const bool lit = is(option, QStyle::State_Selected) || is(option, QStyle::State_Sunken);
    if (lit) {
        const int height = std::min(option.rect.height(), theme.px(30));
        QRect box(option.rect.left(), 0, option.rect.width(), height);
        box.moveTop(option.rect.top() + (option.rect.height() - height) / 2);
        paintBox(painter, box, theme.px(4), tokens.ctl);
    }
    painter.setPen(textColor(option, theme, lit ? tokens.t1 : tokens.t2));
    painter.drawText(option.rect, Qt::AlignCenter | kMnemonics | Qt::TextSingleLine, option.text);
}

void paintTab(const QStyleOptionTab& option, QPainter& painter, const Theme& theme) {
    const QRect box = option.rect.adjusted(0, theme.px(2), -theme.px(4), -theme.px(2));
    if (is(option, QStyle::State_Selected))
        paintBox(painter, box, theme.px(4), theme.tokens().sel);
    else if (is(option, QStyle::State_MouseOver))
        paintBox(painter, box, theme.px(4), theme.tokens().ctl);
}

void paintTabLabel(const QStyleOptionTab& option, QPainter& painter, const Theme& theme) {
    const Tokens& tokens = theme.tokens();
    const bool selected = is(option, QStyle::State_Selected);
    QRect words = option.rect.adjusted(theme.px(12), 0, -theme.px(16), 0);
    if (!option.icon.isNull()) {
        option.icon.paint(&painter, QRect(words.left(), words.top(), theme.px(16), words.height()));
        words.adjust(theme.px(24), 0, 0, 0);
    }
    words.setRight(words.right() - option.rightButtonSize.width());
    painter.setFont(theme.font(TextRole::kBody, selected));
    painter.setPen(textColor(option, theme, selected ? tokens.acc : tokens.t2));
    painter.drawText(words, Qt::AlignVCenter | Qt::AlignLeft | kMnemonics, option.text);
}

void paintHeaderSection(const QStyleOptionHeader& option, QPainter& painter, const Theme& theme) {
    const Tokens& tokens = theme.tokens();
    painter.fillRect(option.rect, is(option, QStyle::State_MouseOver) ? tokens.ctl : tokens.panel);
    painter.fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1), tokens.line);
}

void paintHeaderLabel(const QStyleOptionHeader& option, QPainter& painter, const Theme& theme) {
    const int arrow = option.sortIndicator == QStyleOptionHeader::None ? 0 : theme.px(14);
    const int words = QFontMetrics(theme.font(TextRole::kCaption)).horizontalAdvance(option.text);
    const bool right = option.textAlignment & Qt::AlignRight;
    // Qt has taken PM_HeaderMargin off; with these the words stand over those of the cells.
    QRect rect = option.rect.adjusted(theme.px(2), 0, -theme.px(2), 0);
    painter.setFont(theme.font(TextRole::kCaption));
    painter.setPen(theme.tokens().t3);
    if (arrow) {
        const int left =
            right ? rect.right() - words - arrow : std::min(rect.left() + words, rect.right() - arrow);
        paintIcon(painter, QRect(left, rect.top(), arrow, rect.height()),
                  option.sortIndicator == QStyleOptionHeader::SortDown ? "down" : "up", theme.px(10),
                  theme.tokens().t2);
        if (!right)
            rect.setRight(std::max(rect.left(), rect.right() - arrow));
    }
    const QString text = QFontMetrics(painter.font()).elidedText(option.text, Qt::ElideRight, rect.width());
    painter.drawText(rect, Qt::AlignVCenter | (right ? Qt::AlignRight : option.textAlignment), text);
}

void paintProgressGroove(const QStyleOptionProgressBar& option, QPainter& painter, const Theme& theme) {
    QRect bar(option.rect);
    bar.setHeight(std::min(bar.height(), theme.px(4)));
    bar.moveTop(option.rect.top() + (option.rect.height() - bar.height()) / 2);
    paintBox(painter, bar, bar.height() / 2.0, theme.tokens().ctlh);
}

void paintProgress(const QStyleOptionProgressBar& option, QPainter& painter, const Theme& theme) {
    QRectF bar(option.rect);
    bar.setHeight(std::min(option.rect.height(), theme.px(4)));
    bar.moveTop(option.rect.top() + (option.rect.height() - bar.height()) / 2);
    const double range = option.maximum - option.minimum;
    if (range > 0)
        bar.setWidth(bar.width() * (option.progress - option.minimum) / range);
    else  // how far cannot be told: a third of the bar, in the middle, at rest
        bar.adjust(bar.width() / 3, 0, -bar.width() / 3, 0);
    if (bar.width() >= 1)
        paintBox(painter, bar, bar.height() / 2, theme.tokens().acc);
}

void paintDockTitle(const QStyleOptionDockWidget& option, QPainter& painter, const Theme& theme) {
    const Tokens& tokens = theme.tokens();
    painter.fillRect(option.rect, tokens.panel);
    painter.fillRect(QRect(option.rect.left(), option.rect.bottom(), option.rect.width(), 1), tokens.line);
    painter.setFont(theme.font(TextRole::kBody, true));
    painter.setPen(tokens.t1);
    const int buttons = theme.px(28) * (option.closable + option.floatable);
    const QRect words = option.rect.adjusted(theme.px(12), 0, -buttons - theme.px(8), 0);
    painter.drawText(words, Qt::AlignVCenter | Qt::AlignLeft | kMnemonics,
                     painter.fontMetrics().elidedText(option.title, Qt::ElideRight, words.width()));
}

}  // namespace noctule::ui::parts
