// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/map_legend.h"

#include <QPainter>
#include <algorithm>

#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

constexpr int kMark = 20, kLegendGap = 8, kBetween = 24;

}  // namespace

MapLegend::MapLegend(Shows shows, QWidget* parent) : QWidget(parent) {
    if (shows == Shows::kPlaces)
        entries_ = {{Mark::kBoard, tr("board: gyroscope, accelerometer and microphone")},
                    {Mark::kSource, tr("source: sends a pulse every 64 ms")}};
    else
        entries_ = {{Mark::kWorking, tr("board, sound and motion arrive")},
                    {Mark::kSilent, tr("board, nothing arrives")},
                    {Mark::kSource, tr("source, sends a pulse every 64 ms")}};
    QStringList words;
    for (const Entry& entry : entries_)
        words << entry.words;
    setAccessibleName(tr("Legend"));
    setAccessibleDescription(words.join(QStringLiteral(". ")));
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(), update(); });
}

QColor MapLegend::colorOf(Mark mark) {
    const Tokens& tokens = Theme::get().tokens();
    switch (mark) {
        case Mark::kBoard:
            return tokens.t2;
        case Mark::kWorking:
            return tokens.ok;
        case Mark::kSilent:
            return tokens.err;
        case Mark::kSource:
            break;
    }
    return tokens.acc;
}

int MapLegend::widthOf(const Entry& entry) const {
    const QFontMetrics metrics(Theme::get().font(TextRole::kSecondary));
    return Theme::get().px(kMark + kLegendGap) + metrics.horizontalAdvance(entry.words) + 2;
}

int MapLegend::rowHeight() const {
    const QFontMetrics metrics(Theme::get().font(TextRole::kSecondary));
    return std::max(metrics.height(), Theme::get().px(20));
}

QSize MapLegend::sizeHint() const {
    int width = -Theme::get().px(kBetween);
    for (const Entry& entry : entries_)
        width += widthOf(entry) + Theme::get().px(kBetween);
    return {width, rowHeight()};
}

QSize MapLegend::minimumSizeHint() const {
    int widest = 0;
    for (const Entry& entry : entries_)
        widest = std::max(widest, widthOf(entry));
    return {widest, rowHeight()};
}

int MapLegend::heightForWidth(int width) const {
    return width >= sizeHint().width() ? rowHeight() : static_cast<int>(entries_.size()) * rowHeight();
}

void MapLegend::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(theme.font(TextRole::kSecondary));
    const bool in_a_row = width() >= sizeHint().width();
    QPoint at(0, 0);
    for (const Entry& entry : entries_) {
        QRectF mark(at.x() + 1, 0, theme.px(kMark) - 2, theme.px(14));
        mark.moveTop(at.y() + (rowHeight() - mark.height()) / 2);
        painter.setPen(
            QPen(colorOf(entry.mark), 1.5, entry.mark == Mark::kSilent ? Qt::DashLine : Qt::SolidLine));
        if (entry.mark == Mark::kSource)
            painter.drawEllipse(mark.center(), theme.px(7), theme.px(7));
        else
            painter.drawRoundedRect(mark, theme.px(4), theme.px(4));
        painter.setPen(tokens.t2);
        painter.drawText(QRect(at.x() + theme.px(kMark + kLegendGap), at.y(), width(), rowHeight()),
                         Qt::AlignVCenter | Qt::AlignLeft, entry.words);
        at += in_a_row ? QPoint(widthOf(entry) + theme.px(kBetween), 0) : QPoint(0, rowHeight());
    }
}

}  // namespace noctule::ui
