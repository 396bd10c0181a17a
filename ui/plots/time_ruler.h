// SPDX-License-Identifier: Apache-2.0
// Ticks and times of a time axis.
#pragma once

#include <QPainter>
#include <QRect>
#include <vector>

#include "ui/plots/time_window.h"

namespace noctule::ui {

struct RulerScale {
    double step_s = 1;        ///< between labels; half way stands a tick without
    int decimals = 0;         ///< of the labels
    std::vector<double> t_s;  ///< of labels
    std::vector<double> between;
};

/// Round steps, no nearer to each other than labels need.
RulerScale rulerScale(double from_s, double to_s, double width_px, double label_px);

inline constexpr double kRulerHeight = 30;  ///< pixels at 100 percent, ticks and labels

/// Ticks at the top of `area`, labels below; times beyond the window are left out.
void paintTimeRuler(QPainter& painter, const QRect& area, const TimeWindow& window);
/// Only the labels, centred under their times.
void paintRulerLabels(QPainter& painter, const QRect& area, const TimeWindow& window);

}  // namespace noctule::ui
