// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/time_ruler.h"

#include <array>
#include <cmath>

#include "ui/style/theme.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

constexpr double kLabelSpace = 72, kTick = 6;  // pixels at 100 percent
constexpr std::array kLongSteps_s{1., 2., 4., 5., 10., 20., 30., 60., 120., 300., 600., 1200., 1800., 3600.};

double roundStep(double least_s) {
    if (least_s > 1) {
        for (const double step_s : kLongSteps_s)
            if (step_s >= least_s)
                return step_s;
        return std::ceil(least_s / 3600) * 3600;
    }
    const double decade = std::pow(10, std::floor(std::log10(least_s) + 1e-9));
    for (const double factor : {1., 2., 5.})
        if (factor * decade >= least_s * (1 - 1e-9))
            return factor * decade;
    return 10 * decade;
}

RulerScale scaleOf(const TimeWindow& window, const QRect& area) {
    return rulerScale(window.from(), window.to(), area.width(), Theme::get().px(kLabelSpace));
}

}  // namespace

RulerScale rulerScale(double from_s, double to_s, double width_px, double label_px) {
    RulerScale scale;
    scale.step_s = roundStep((to_s - from_s) * label_px / std::max(1.0, width_px));
    scale.decimals = scale.step_s >= 1 ? 0 : static_cast<int>(std::ceil(-std::log10(scale.step_s) - 1e-9));
    const auto first = static_cast<int64_t>(std::floor(from_s / scale.step_s));
    const auto last = static_cast<int64_t>(std::floor(to_s / scale.step_s + 1e-9));
    const auto keep = [&](std::vector<double>& list, double t_s) {
        if (t_s >= from_s - 1e-9 && t_s <= to_s + 1e-9)
            list.push_back(t_s);
    };
    for (int64_t i = first; i <= last; ++i) {
        keep(scale.t_s, static_cast<double>(i) * scale.step_s);
        keep(scale.between, (static_cast<double>(i) + 0.5) * scale.step_s);
    }
    return scale;
}

void paintRulerLabels(QPainter& painter, const QRect& area, const TimeWindow& window) {
    const Theme& theme = Theme::get();
    const RulerScale scale = scaleOf(window, area);
    painter.setFont(theme.font(TextRole::kCaption));
    painter.setPen(theme.tokens().t3);
    const int half = theme.px(kLabelSpace) / 2;
    for (const double t_s : scale.t_s) {
        const int x = area.left() + qRound(window.xOf(t_s, area.width()));
        painter.drawText(QRect(x - half, area.top(), 2 * half, area.height()), Qt::AlignCenter,
                         timeText(t_s, scale.decimals));
    }
}

void paintTimeRuler(QPainter& painter, const QRect& area, const TimeWindow& window) {
    const Theme& theme = Theme::get();
    const RulerScale scale = scaleOf(window, area);
    const int tick = theme.px(kTick);
    painter.fillRect(QRect(area.left(), area.top(), area.width(), 1), theme.tokens().line);
    for (const double t_s : scale.t_s)
        painter.fillRect(QRect(area.left() + qRound(window.xOf(t_s, area.width())), area.top(), 1, tick),
                         theme.tokens().edge);
    paintRulerLabels(painter, area.adjusted(0, tick, 0, 0), window);
}

}  // namespace noctule::ui
