// SPDX-License-Identifier: Apache-2.0
// What one lane of the plots shows, as values: made by lanes_*.cpp, drawn by PlotLane, written as CSV by
// PlotPanel. Values are SI; the unit turns them into what is read.
#pragma once

#include <QString>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/acoustics/range.h"
#include "core/review/series.h"

namespace noctule::ui {

/// How long a pose counts as "now": they come at 120 frames a second, of a slow reference at 24.
inline constexpr double kPoseHold_s = 0.1;

struct LaneUnit {
    double factor = 1;  ///< shown = value * factor
    QString suffix;     ///< with its space: " m"; degrees without: "°"
    int decimals = 2;   ///< of readouts
    bool on_ticks = false;
    std::optional<int> tick_decimals = {};  ///< absent: as many as the step between ticks needs
};

enum class LanePen { kFirst, kSecond, kThird, kFourth, kX, kY, kZ, kReference };

struct LaneCurve {
    QString legend;  ///< "source 5 (navel) to left shin"
    QString column;  ///< heading in CSV files, with the unit of `value`
    LanePen pen = LanePen::kFirst;
    std::shared_ptr<const SeriesPyramid> value;
    std::shared_ptr<const SeriesPyramid> low, high;  ///< -+ 2 sigma; may be absent
    /// Drawn as points, one shape and colour per decision; as long as the curve. Absent: a line.
    std::shared_ptr<const std::vector<RangeFate>> fate;
    /// Pattern of the value at the cursor: "ref %1"; empty: not read out.
    QString readout = QStringLiteral("%1");
    double hold_s = 0.05;  ///< values older than this are not read out
};

/// Instants that are marked within the lane.
struct LaneMarks {
    enum class Kind {
        kSent,     ///< a pulse leaves; tick at the bottom with its source's number
        kArrival,  ///< a pulse as detected; line with a triangle
        kLost,     ///< bar at the bottom
        kClipped,  ///< bar at the top
    };
    Kind kind = Kind::kSent;
    QString legend;
    std::vector<double> t_s;
    std::vector<QString> text;  ///< as long as t_s, or empty
};

struct LaneContent {
    QString title;  ///< "Left knee, flexion"
    QString empty;  ///< what is said when there is no curve
    LaneUnit unit;
    std::optional<std::pair<double, double>> range;  ///< of the axis; absent: what is seen
    double least_span = 0;                           ///< of the axis
    std::vector<LaneCurve> curves;
    std::vector<LaneMarks> marks;
};

}  // namespace noctule::ui
