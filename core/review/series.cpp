// SPDX-License-Identifier: Apache-2.0
#include "core/review/series.h"

#include <algorithm>
#include <cmath>

#include "core/job/contract.h"

namespace noctule {

Series makeSeries(std::vector<double> t_s, std::vector<float> value) {
    require(t_s.size() == value.size(), "every value of a curve has a time");
    size_t kept = 0;
    for (size_t i = 0; i < t_s.size(); ++i) {
        if (!std::isfinite(t_s[i]) || (kept > 0 && t_s[i] <= t_s[kept - 1]))
            continue;
        t_s[kept] = t_s[i];
        value[kept++] = value[i];
    }
    t_s.resize(kept);
    value.resize(kept);
    return {std::move(t_s), std::move(value)};
}

SeriesPyramid::SeriesPyramid(Series series) : series_(std::move(series)) {
    require(series_.t_s.size() == series_.value.size(), "every value of a curve has a time");
    const auto parent = [](size_t count) { return (count + kFanOut - 1) / kFanOut; };
    for (size_t count = size(); count > kFanOut; count = levels_.back().size()) {
        std::vector<Node> nodes(parent(count), kNothing);
        for (size_t i = 0; i < count; ++i)
            merge(nodes[i / kFanOut], levels_.empty() ? nodeOf(i) : levels_.back()[i]);
        levels_.push_back(std::move(nodes));
    }
}

void SeriesPyramid::merge(Node& into, const Node& other) {
    into.min = std::min(into.min, other.min);
    into.max = std::max(into.max, other.max);
    into.gap = into.gap || other.gap;
}

SeriesPyramid::Node SeriesPyramid::nodeOf(size_t index) const {
    const float value = series_.value[index];
    return std::isnan(value) ? Node{kNothing.min, kNothing.max, true} : Node{value, value, false};
}

std::pair<SeriesPyramid::Node, size_t> SeriesPyramid::largestAt(size_t first, size_t last) const {
    size_t span = 1;
    std::pair<Node, size_t> largest{nodeOf(first), 1};
    for (const auto& level : levels_) {
        span *= kFanOut;
        if (first % span != 0 || first + span > last)
            break;
        largest = {level[first / span], span};
    }
    return largest;
}

std::pair<SeriesPyramid::Node, size_t> SeriesPyramid::largestBefore(size_t first, size_t last) const {
    size_t span = 1;
    std::pair<Node, size_t> largest{nodeOf(last - 1), 1};
    for (const auto& level : levels_) {
        span *= kFanOut;
        if (last % span != 0 || first + span > last)
            break;
        largest = {level[last / span - 1], span};
    }
    return largest;
}

SeriesPyramid::Node SeriesPyramid::summary(size_t first, size_t last) const {
    Node all = kNothing;
    while (first < last) {
        const auto [node, span] = largestAt(first, last);
        merge(all, node);
        first += span;
    }
    return all;
}

size_t SeriesPyramid::firstValue(size_t first, size_t last) const {
    while (first < last && std::isnan(series_.value[first])) {
        const auto [node, span] = largestAt(first, last);
        first += node.min <= node.max ? 1 : span;  // a node that is all NaN is stepped over as a whole
    }
    return first;
}

size_t SeriesPyramid::lastValue(size_t first, size_t last) const {
    while (std::isnan(series_.value[last - 1])) {
        const auto [node, span] = largestBefore(first, last);
        last -= node.min <= node.max ? 1 : span;
    }
    return last - 1;
}

SeriesColumn SeriesPyramid::column(size_t first, size_t last) const {
    SeriesColumn column;
    const size_t begin = firstValue(first, last);
    if (begin == last) {
        column.breaks = last > first;
        return column;
    }
    const size_t end = lastValue(first, last);
    const Node all = summary(begin, end + 1);
    column = {all.min, all.max, series_.value[begin], series_.value[end], false, false};
    column.breaks = all.gap || (begin > 0 && std::isnan(series_.value[begin - 1]));
    return column;
}

size_t SeriesPyramid::indexAt(double t_s) const {
    const auto later = std::upper_bound(series_.t_s.begin(), series_.t_s.end(), t_s);
    return later == series_.t_s.begin() ? size() : static_cast<size_t>(later - series_.t_s.begin()) - 1;
}

std::vector<SeriesColumn> SeriesPyramid::columns(double from_s, double to_s, int columns) const {
    std::vector<SeriesColumn> result(static_cast<size_t>(std::max(0, columns)));
    if (!(to_s > from_s))
        return result;
    const double width_s = (to_s - from_s) / columns;
    const auto indexOf = [&](size_t column) {
        const double t_s = column == result.size() ? to_s : from_s + static_cast<double>(column) * width_s;
        return static_cast<size_t>(std::lower_bound(series_.t_s.begin(), series_.t_s.end(), t_s) -
                                   series_.t_s.begin());
    };
    size_t first = result.empty() ? 0 : indexOf(0);
    for (size_t i = 0; i < result.size(); ++i) {
        const size_t last = std::max(first, indexOf(i + 1));
        result[i] = column(first, last);
        first = last;
    }
    return result;
}

std::pair<float, float> SeriesPyramid::bounds(double from_s, double to_s) const {
    const auto first = std::lower_bound(series_.t_s.begin(), series_.t_s.end(), from_s);
    const auto last = std::upper_bound(series_.t_s.begin(), series_.t_s.end(), to_s);
    if (first >= last)
        return {kNothing.min, kNothing.max};
    const Node all = summary(static_cast<size_t>(first - series_.t_s.begin()),
                             static_cast<size_t>(last - series_.t_s.begin()));
    return {all.min, all.max};
}

}  // namespace noctule
