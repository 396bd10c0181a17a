// SPDX-License-Identifier: Apache-2.0
// Plots as inline SVG without scripts. Colours come from the page's style sheet (classes), so that one
// drawing serves light, dark and paper. Curves are reduced to the smallest and largest value per pixel
// column: what is seen is the same, and an hour of data takes no more room than a minute.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace noctule {

inline constexpr double kPlotWidth_px = 1000, kPlotMargin_px = 12, kPlotLeft_px = 56;
inline constexpr double kPlotRight_px = kPlotWidth_px - kPlotMargin_px;

struct Interval {
    double min = 0, max = 1;
    double span() const { return max - min; }
};

struct PlotCurve {
    std::span<const double> time_s, values;  ///< equally long; NaN breaks the curve
    std::string css_class;                   ///< "estimate", "reference", "x", "y", "z", "run0", ...
    std::string name;                        ///< for the legend; empty: not listed
};

struct PlotBand {
    std::span<const double> time_s, middle, half_width;
};

struct PlotDots {
    std::span<const double> time_s, values;
    std::string css_class, name;
};

struct LinePlot {
    std::string title, description;  ///< description: what a listener should know
    Interval time_s, values;
    int value_decimals = 0;
    std::string unit;  ///< behind the labels of the value axis: "°", " m"
    double width_px = kPlotWidth_px, height_px = 120;
    bool time_labels = true;
    std::vector<PlotBand> bands;
    std::vector<PlotCurve> curves;
    std::vector<PlotDots> dots;
};

std::string svg(const LinePlot& plot);

/// Smallest interval with round ends that holds all finite values, at least `least_span` wide.
Interval niceInterval(const std::vector<std::span<const double>>& values, double least_span);

/// Round values within an interval, at most `most`.
std::vector<double> ticks(const Interval& interval, int most);

/// Marks of a time axis in steps that people count in, at most ten, and how they are written.
std::vector<double> timeTicks(const Interval& time_s);
std::string timeLabel(double time_s, const Interval& interval_s);

/// Extremes of the values per pixel column, in time order; holes longer than 0.25 s and a column, and
/// non-finite values, break the path. Coordinates are clipped to the plot's height.
std::string decimatedPath(std::span<const double> time_s, std::span<const double> values,
                          const Interval& time, const Interval& value, const Interval& x_px,
                          const Interval& y_px);

}  // namespace noctule
