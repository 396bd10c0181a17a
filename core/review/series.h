// SPDX-License-Identifier: Apache-2.0
// A curve over time for plots, and its reduction to what a screen can show: the lowest and highest value of
// every pixel column, in time proportional to the columns whatever the length (a pyramid of minima and
// maxima).
#pragma once

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace noctule {

/// Where a curve breaks.
inline constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();

/// Times strictly increasing, seconds of the take's clock. NaN values break the curve.
struct Series {
    std::vector<double> t_s;
    std::vector<float> value;
};

/// Arrays of equal length as a curve. Values whose time is not finite or not later than the one before are
/// left out: tables of damaged takes hold such.
Series makeSeries(std::vector<double> t_s, std::vector<float> value);

/// One pixel column; empty when no value falls into it.
struct SeriesColumn {
    float min = 0, max = 0, first = 0, last = 0;
    bool empty = true;
    /// A NaN lies between the value before this column and its last value: no line from there to here. Of an
    /// empty column: it holds a NaN.
    bool breaks = false;
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
    /// `columns` equal columns of [from_s, to_s); all empty when that is no time.
    std::vector<SeriesColumn> columns(double from_s, double to_s, int columns) const;
    /// Lowest and highest value from from_s to to_s, both included; first > second when there is none.
    std::pair<float, float> bounds(double from_s, double to_s) const;

private:
    /// What kFanOut nodes below it, or values, hold. min > max: nothing but NaN.
    struct Node {
        float min, max;
        bool gap;  ///< a NaN is among them
    };
    static constexpr size_t kFanOut = 8;
    static constexpr Node kNothing{std::numeric_limits<float>::infinity(),
                                   -std::numeric_limits<float>::infinity(), false};
    static void merge(Node& into, const Node& other);
    Node nodeOf(size_t index) const;
    /// Of the values [first, last).
    Node summary(size_t first, size_t last) const;
    /// The largest node that starts at `first` and ends by `last`, and how many values it holds.
    std::pair<Node, size_t> largestAt(size_t first, size_t last) const;
    /// The largest node that ends at `last` and starts at `first` or later.
    std::pair<Node, size_t> largestBefore(size_t first, size_t last) const;
    size_t firstValue(size_t first, size_t last) const;  ///< `last` when there is none
    size_t lastValue(size_t first, size_t last) const;   ///< there must be one
    SeriesColumn column(size_t first, size_t last) const;

    Series series_;
    std::vector<std::vector<Node>> levels_;  ///< a node of level n holds kFanOut^(n+1) values, the last fewer
};

}  // namespace noctule
