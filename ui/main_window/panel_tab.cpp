// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/panel_tab.h"

#include <QPainter>

#include "ui/style/paint.h"
#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

constexpr int kTabHeight = 24, kTabIcon = 14, kTabGap = 6;

}  // namespace

PanelTab::PanelTab(Side side, QWidget* parent) : QAbstractButton(parent), side_(side) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    hide();
    connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(), update(); });
}

void PanelTab::setTitle(const QString& title) {
    setText(title);
    setShortcut({});  // "R&D" asks for no key
    updateGeometry();
    setAccessibleName(tr("Show the panel %1").arg(title));
    setToolTip(tr("%1: folded away because large text or a small window leaves it no room. A click shows it.")
                   .arg(title));
    update();
}

QSize PanelTab::sizeHint() const {
    const Theme& theme = Theme::get();
    const int words = QFontMetrics(theme.font(TextRole::kSecondary)).horizontalAdvance(text());
    return {words + theme.px(kTabIcon + 3 * kTabGap), theme.px(kTabHeight)};
}

void PanelTab::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const bool left = side_ == Side::kLeft;
    const int icon = theme.px(kTabIcon), gap = theme.px(kTabGap);
    QPainter painter(this);
    painter.fillRect(rect(), underMouse() ? tokens.ctlh : tokens.panel);
    painter.save();
    if (!left) {  // points to where the panel will be
        painter.translate(width(), 0);
        painter.scale(-1, 1);
    }
    paintIcon(painter, QRect(gap, 0, icon, height()), "chevron", icon, tokens.t1);
    painter.restore();
    painter.setFont(theme.font(TextRole::kSecondary));
    painter.setPen(tokens.t1);
    const QRect words =
        left ? rect().adjusted(icon + 2 * gap, 0, 0, 0) : rect().adjusted(gap, 0, -icon - gap, 0);
    painter.drawText(words, Qt::AlignVCenter | Qt::AlignLeft,
                     painter.fontMetrics().elidedText(text(), Qt::ElideRight, words.width()));
}

void PanelTab::enterEvent(QEvent*) {
    update();
}

void PanelTab::leaveEvent(QEvent*) {
    update();
}

}  // namespace noctule::ui
