// SPDX-License-Identifier: Apache-2.0
// The title row and the tick labels of a lane.
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/plots/lane_legend.h"
#include "ui/plots/plot_lane.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

constexpr double kBeforeTicks = 8, kTitleLeft = 16;  // pixels at 100 percent

int decimalsOf(double step) {
    return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
}

}  // namespace

QString PlotLane::tickText(double value) const {
    const QList<double> major = ticks_.ticks(QwtScaleDiv::MajorTick);
    const double step = major.size() > 1 ? major[1] - major[0] : 1;
    const int decimals = content_.unit.tick_decimals.value_or(decimalsOf(std::abs(step)));
    const QString text = numberText(std::abs(value) < step * 1e-9 ? 0 : value, decimals);
    return content_.unit.on_ticks ? text + content_.unit.suffix : text;
}

void PlotLane::paintTicks(QPainter& painter) const {
    const Theme& theme = Theme::get();
    const QRect area = canvas();
    painter.setFont(theme.font(TextRole::kCaption));
    painter.setPen(theme.tokens().t3);
    const int half = painter.fontMetrics().height() / 2 + 1;
    const double low = ticks_.lowerBound(), high = ticks_.upperBound();
    for (const double tick : ticks_.ticks(QwtScaleDiv::MajorTick)) {
        const int y = area.top() + qRound((high - tick) / (high - low) * area.height());
        painter.drawText(QRect(0, y - half, area.left() - theme.px(kBeforeTicks), 2 * half),
                         Qt::AlignRight | Qt::AlignVCenter, tickText(tick));
    }
}

/// Several values wear the colours of their curves.
int PlotLane::paintReadout(QPainter& painter, QRect row) const {
    const Theme& theme = Theme::get();
    painter.setFont(theme.font(TextRole::kCaption));
    const bool several = content_.curves.size() > 1;
    for (const Part& part : readout_) {
        painter.setPen(several ? penColor(part.pen) : theme.tokens().t1);
        painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, part.text);
        row.setLeft(row.left() + painter.fontMetrics().horizontalAdvance(part.text) + theme.px(10));
    }
    return row.left();
}

void PlotLane::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    QPainter painter(this);
    const QRect area = canvas();
    QRect row(theme.px(kTitleLeft), 0, area.right() + 1 - theme.px(kTitleLeft), theme.px(kTitleRow));
    painter.setFont(theme.font(TextRole::kSecondary, true));
    painter.setPen(theme.tokens().t1);
    const int title_width = painter.fontMetrics().horizontalAdvance(content_.title) + theme.px(12);
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(content_.title, Qt::ElideRight, row.width()));
    row.setLeft(row.left() + std::min(row.width(), title_width));
    if (content_.curves.empty()) {
        painter.setFont(theme.font(TextRole::kSecondary));
        painter.setPen(theme.tokens().t3);
        painter.drawText(area, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, content_.empty);
        return;
    }
    row.setLeft(std::min(row.right(), paintReadout(painter, row) + theme.px(12)));
    paintLaneLegend(painter, row, content_);
    paintTicks(painter);
}

}  // namespace noctule::ui
