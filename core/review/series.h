// SPDX-License-Identifier: Apache-2.0
// A curve over time for plots, and its reduction to what a screen can show: the lowest and highest value of
// every pixel column, in time proportional to the columns whatever the length (a pyramid of minima and
// maxima).
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace noctule {

/// Times strictly increasing, seconds of the take's clock. NaN values break the curve.
struct Series {
    std::vector<double> t_s;
    std::vector<float> value;
};

/// One pixel column; empty when no value falls into it.
struct SeriesColumn {
    float min = 0, max = 0, first = 0, last = 0;
    bool empty = true;
    bool breaks = false;  ///< the curve is interrupted within or before this column
};

class SeriesPyramid {
public:
    SeriesPyramid() = default;
    explicit SeriesPyramid(Series series);

    const Series& series() const { return series_; }
    size_t size() const { return series_.t_s.size(); }
    bool empty() const { return size() == 0; }
    /// Index of the last value at or before t; size() when there is none.
    size_t indexAt(double t_s) const;
    /// `columns` equal columns of [from_s, to_s).
    std::vector<SeriesColumn> columns(double from_s, double to_s, int columns) const;
    /// Lowest and highest value within the time; first > second when there is none.
    std::pair<float, float> bounds(double from_s, double to_s) const;

private:
    struct Node {
        float min, max;
        bool gap;
    };
    Series series_;
    std::vector<std::vector<Node>> levels_;
};

}  // namespace noctule
