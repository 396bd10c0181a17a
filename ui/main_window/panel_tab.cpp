// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/panel_tab.h"

#include <QPainter>

#include "ui/style/paint.h"
#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

constexpr int kTabWidth = 28, kTabHead = 36, kTabLeast = 120, kTabIcon = 16, kTabEnd = 8;

}  // namespace

PanelTab::PanelTab(Edge edge, QWidget* parent) : QAbstractButton(parent), edge_(edge) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
    hide();
    connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(), update(); });
}

void PanelTab::setTitle(const QString& title) {
    setText(title);
    setAccessibleName(tr("Show the panel %1").arg(title));
    setToolTip(tr("%1: folded away because large text or a small window leaves it no room. A click shows it.")
                   .arg(title));
    update();
}

QSize PanelTab::sizeHint() const {
    return {Theme::get().px(kTabWidth), Theme::get().px(kTabLeast)};
}

void PanelTab::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const bool left = edge_ == Edge::kLeft;
    QPainter painter(this);
    painter.fillRect(rect(), underMouse() ? tokens.ctlh : tokens.panel);
    painter.fillRect(QRect(left ? width() - 1 : 0, 0, 1, height()), tokens.line);
    const int head = theme.px(kTabHead);
    painter.save();
    if (!left) {  // points to where the panel will be
        painter.translate(width(), 0);
        painter.scale(-1, 1);
    }
    paintIcon(painter, QRect(0, 0, width(), head), "chevron", theme.px(kTabIcon), tokens.t1);
    painter.restore();
    painter.translate(width(), head);
    painter.rotate(90);
    painter.setFont(theme.font(TextRole::kBody, true));
    painter.setPen(tokens.t1);
    const QRect room(0, 0, height() - head - theme.px(kTabEnd), width());
    painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft,
                     painter.fontMetrics().elidedText(text(), Qt::ElideRight, room.width()));
}

void PanelTab::enterEvent(QEvent*) {
    update();
}

void PanelTab::leaveEvent(QEvent*) {
    update();
}

}  // namespace noctule::ui
