// SPDX-License-Identifier: Apache-2.0
#include "ui/views/map_legend.h"

#include <QPainter>

#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

constexpr int kMark = 20, kGap = 8, kBetween = 24;

}  // namespace

MapLegend::MapLegend(QWidget* parent)
    : QWidget(parent),
      board_(tr("board: gyroscope, accelerometer and microphone")),
      source_(tr("source: sends a pulse every 64 ms")) {
    setAccessibleName(tr("Legend"));
    setAccessibleDescription(board_ + QStringLiteral(". ") + source_);
    connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(), update(); });
}

QSize MapLegend::sizeHint() const {
    const Theme& theme = Theme::get();
    const QFontMetrics metrics(theme.font(TextRole::kSecondary));
    return {metrics.horizontalAdvance(board_) + metrics.horizontalAdvance(source_) +
                theme.px(2 * (kMark + kGap) + kBetween) + 2,
            std::max(metrics.height(), theme.px(20))};
}

void MapLegend::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(theme.font(TextRole::kSecondary));
    const int words = QFontMetrics(painter.font()).horizontalAdvance(board_);
    QRectF mark(1, 0, theme.px(kMark), theme.px(14));
    mark.moveTop((height() - mark.height()) / 2);
    painter.setPen(QPen(tokens.t2, 1.5));
    painter.drawRoundedRect(mark, theme.px(4), theme.px(4));
    const int first = theme.px(kMark + kGap);
    painter.drawText(QRect(first, 0, words + 2, height()), Qt::AlignVCenter, board_);
    const int second = first + words + theme.px(kBetween);
    painter.setPen(QPen(tokens.acc, 1.5));
    painter.drawEllipse(QPointF(second + theme.px(8), height() / 2.0), theme.px(7), theme.px(7));
    painter.setPen(tokens.t2);
    painter.drawText(QRect(second + theme.px(kMark + kGap), 0, width(), height()), Qt::AlignVCenter, source_);
}

}  // namespace noctule::ui
