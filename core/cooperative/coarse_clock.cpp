// SPDX-License-Identifier: Apache-2.0
#include "core/cooperative/coarse_clock.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace noctule::cooperative {
namespace {

constexpr double kMostAhead_s = 0.012;
constexpr double kNearest_s = 0.0003, kFarthest_s = 0.018;  ///< of sound: 0.1 to 6 m
constexpr double kMostSpread_s = 0.001;
/// Median deviation of one pair's ways: 1 m/s during 1.5 s is 1.1 ms, arrivals at any time are 2 ms.
constexpr double kMostMoved_s = 0.0013;
constexpr size_t kLeastPairs = 3, kLeastHeard = 3;
constexpr int kMostPulses = 3;  ///< that a delay may be counted wrong by

using Delays = std::map<std::pair<int, int>, double>;  ///< median by source and board

double medianIn(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Where in the interval the longest pause between arrivals ends.
double endOfPause(const Direction& direction) {
    std::vector<double> delays;
    for (const LooseArrival& arrival : direction.arrivals)
        delays.push_back(arrival.delay_s);
    std::ranges::sort(delays);
    double longest = delays.front() + direction.interval_s - delays.back(), end = delays.front();
    for (size_t i = 1; i < delays.size(); ++i)
        if (delays[i] - delays[i - 1] > longest)
            longest = delays[i] - delays[i - 1], end = delays[i];
    return end;
}

/// Arrivals before the pause belong to the pulse before; then each is given to a pulse `back` earlier.
Delays delaysOf(const Direction& direction, double pause_end_s, int back) {
    std::map<std::pair<int, int>, std::vector<double>> heard;
    for (const LooseArrival& arrival : direction.arrivals) {
        const int pulses = back + (arrival.delay_s < pause_end_s ? 1 : 0);
        const int pulse = arrival.pulse - pulses;
        if (pulse < 0 || pulse >= static_cast<int>(direction.sources.size()))
            continue;
        heard[{direction.sources[static_cast<size_t>(pulse)], arrival.board}].push_back(
            arrival.delay_s + pulses * direction.interval_s);
    }
    Delays medians;
    for (auto& [pair, delays] : heard) {
        if (delays.size() < kLeastHeard)
            continue;
        const double median_s = medianIn(delays);
        for (double& delay_s : delays)
            delay_s = std::abs(delay_s - median_s);
        if (medianIn(delays) < kMostMoved_s)
            medians[pair] = median_s;
    }
    return medians;
}

struct Agreement {
    double ahead_s, way_s, spread_s;
};

std::optional<Agreement> agreementOf(const Delays& there, const Delays& back, const Direction& first,
                                     const Direction& second) {
    std::vector<double> ahead, way;
    for (const auto& [pair, delay_s] : there) {
        const int board_of_first = first.board_near[static_cast<size_t>(pair.first)];
        for (size_t source = 0; source < second.board_near.size(); ++source) {
            if (board_of_first < 0 || second.board_near[source] != pair.second)
                continue;
            const auto other = back.find({static_cast<int>(source), board_of_first});
            if (other == back.end())
                continue;
            ahead.push_back((delay_s - other->second) / 2);
            way.push_back((delay_s + other->second) / 2);
        }
    }
    if (ahead.size() < kLeastPairs)
        return std::nullopt;
    const double way_s = medianIn(way), ahead_s = medianIn(ahead);
    for (double& one : ahead)
        one = std::abs(one - ahead_s);
    if (way_s < kNearest_s || way_s > kFarthest_s || std::abs(ahead_s) > kMostAhead_s)
        return std::nullopt;
    return Agreement{ahead_s, way_s, medianIn(ahead)};
}

}  // namespace

std::optional<CoarseClock> coarseClock(const Direction& there, const Direction& back) {
    if (there.arrivals.empty() || back.arrivals.empty())
        return std::nullopt;
    const double there_end = endOfPause(there), back_end = endOfPause(back);
    std::optional<CoarseClock> best;
    for (int t = -kMostPulses; t <= kMostPulses; ++t) {
        const Delays delays = delaysOf(there, there_end, t);
        for (int b = -kMostPulses; b <= kMostPulses; ++b) {
            const auto found = agreementOf(delays, delaysOf(back, back_end, b), there, back);
            if (found && found->spread_s < (best ? best->spread_s : kMostSpread_s))
                best = CoarseClock{found->ahead_s, t, b, found->way_s, found->spread_s};
        }
    }
    return best;
}

}  // namespace noctule::cooperative
