// SPDX-License-Identifier: Apache-2.0
#include "core/review/plot_series.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace noctule {
namespace {

const std::vector<float>& valuesOf(const PairTrack& track, RangeQuantity quantity) {
    switch (quantity) {
        case RangeQuantity::kDistance_m:
            return track.distance_m;
        case RangeQuantity::kResidual_m:
            return track.innovation_m;
        case RangeQuantity::kConfidence:
            break;
    }
    return track.confidence;
}

/// Number of times before t.
size_t countBefore(const std::vector<double>& t_s, double t) {
    return static_cast<size_t>(std::lower_bound(t_s.begin(), t_s.end(), t) - t_s.begin());
}

}  // namespace

Series rangeSeries(const RangeTable& table, int source, int board, RangeQuantity quantity) {
    const PairTrack& track = table.pair(source, board);
    const std::vector<float>& heard = valuesOf(track, quantity);
    const std::vector<double>& pulses = table.pulse_t_s[static_cast<size_t>(source)];
    const float unheard = quantity == RangeQuantity::kConfidence ? 0 : kNoValue;
    Series series;
    series.t_s.reserve(pulses.size());
    series.value.reserve(pulses.size());
    size_t next = 0;
    for (const double t_s : pulses) {
        while (next < track.t_s.size() && track.t_s[next] < t_s)
            ++next;
        const bool is_heard = next < track.t_s.size() && track.t_s[next] == t_s;
        series.t_s.push_back(t_s);
        series.value.push_back(is_heard ? heard[next] : unheard);
    }
    return makeSeries(std::move(series.t_s), std::move(series.value));
}

PairNow pairAt(const RangeTable& table, int source, int board, double t_s) {
    const std::vector<double>& pulses = table.pulse_t_s[static_cast<size_t>(source)];
    const auto after = std::upper_bound(pulses.begin(), pulses.end(), t_s);
    if (after == pulses.begin() || t_s - *(after - 1) > kPairHold_s)
        return {};
    const double pulse_s = *(after - 1);
    const PairTrack& track = table.pair(source, board);
    const size_t at = countBefore(track.t_s, pulse_s);
    if (at == track.t_s.size() || track.t_s[at] != pulse_s)
        return {true, std::nullopt};
    return {true, track.confidence[at]};
}

Series readingSeries(const ReadingTable& table, int board, int axis) {
    const BoardTrack& track = table.boards[static_cast<size_t>(board)];
    return makeSeries(track.t_s, track.value[static_cast<size_t>(axis)]);
}

PairSummaries::PairSummaries(const RangeTable& table)
    : source_count_(table.source_count), board_count_(table.board_count), pulse_t_s_(table.pulse_t_s) {
    for (const PairTrack& track : table.pairs) {
        Pair pair{track.t_s, {Sums{}}};
        pair.before.reserve(track.t_s.size() + 1);
        for (size_t i = 0; i < track.t_s.size(); ++i) {
            Sums sums = pair.before.back();
            sums.confidence += track.confidence[i];
            const bool used = track.fate[i] == RangeFate::kUsed || track.fate[i] == RangeFate::kWeighted;
            sums.used += used;
            sums.gated += track.fate[i] == RangeFate::kGated;
            const double residual_m = track.innovation_m[i];
            if (used && std::isfinite(residual_m)) {
                sums.residual_squares_m2 += residual_m * residual_m;
                ++sums.residuals;
            }
            pair.before.push_back(sums);
        }
        pairs_.push_back(std::move(pair));
    }
}

PairWindow PairSummaries::window(int source, int board, double from_s, double to_s) const {
    const Pair& pair = pairs_[static_cast<size_t>(source * board_count_ + board)];
    const std::vector<double>& pulses = pulse_t_s_[static_cast<size_t>(source)];
    PairWindow window;
    if (!(to_s > from_s))
        return window;
    window.pulses = static_cast<int64_t>(countBefore(pulses, to_s) - countBefore(pulses, from_s));
    const size_t first = countBefore(pair.t_s, from_s), last = countBefore(pair.t_s, to_s);
    const Sums &a = pair.before[first], &b = pair.before[last];
    window.heard = static_cast<int64_t>(last - first);
    window.used = b.used - a.used;
    window.gated = b.gated - a.gated;
    if (window.pulses > 0)
        window.mean_confidence =
            std::clamp((b.confidence - a.confidence) / static_cast<double>(window.pulses), 0.0, 1.0);
    if (b.residuals > a.residuals)
        window.residual_rms_m = std::sqrt(std::max(0.0, b.residual_squares_m2 - a.residual_squares_m2) /
                                          static_cast<double>(b.residuals - a.residuals));
    return window;
}

}  // namespace noctule
