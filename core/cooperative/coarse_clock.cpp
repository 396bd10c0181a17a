// SPDX-License-Identifier: Apache-2.0
#include "core/cooperative/coarse_clock.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/cooperative/clock_of_room.h"
#include "core/math/linear_solvers.h"
#include "core/math/order_statistics.h"

namespace noctule::cooperative {
namespace {

constexpr double kMostAhead_s = 0.012;
constexpr double kNearest_s = 0.0003, kFarthest_s = 0.018;  ///< of sound: 0.1 to 6 m
constexpr double kMostSpread_s = 0.001;
/// Median deviation of one pair's ways: 1 m/s during 1.5 s is 1.1 ms, arrivals at any time are 2 ms.
constexpr double kMostMoved_s = 0.0013;
constexpr size_t kLeastPairs = 3, kLeastHeard = 3;
constexpr size_t kLeastSources = 6,
                 kLeastBoards = 3;  ///< that a count rests on: a place and a clock are four unknowns
constexpr double kMostMisfit_s = 0.0003, kClearly = 1.5;
constexpr double kMostDrift_s = 0.0015;  ///< of a clock between two stretches
constexpr double kStart_m = 1.5;
constexpr int kSteps = 12;
constexpr int kMostPulses = 3;  ///< that a delay may be counted wrong by

using Delays = std::map<std::pair<int, int>, double>;  ///< median by source and board

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
        const double median_s = medianOf(delays);
        for (double& delay_s : delays)
            delay_s = std::abs(delay_s - median_s);
        if (medianOf(delays) < kMostMoved_s)
            medians[pair] = median_s;
    }
    return medians;
}

struct Agreement {
    double ahead_s, spread_s;
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
    const double way_s = medianOf(way), ahead_s = medianOf(ahead);
    for (double& one : ahead)
        one = std::abs(one - ahead_s);
    if (way_s < kNearest_s || way_s > kFarthest_s || std::abs(ahead_s) > kMostAhead_s)
        return std::nullopt;
    return Agreement{ahead_s, medianOf(ahead)};
}

/// Root mean square by which delays from known places miss the best place of a board; its own clock is free.
/// Seconds.
double misfitOf(const std::vector<Vector3d>& places_m, const std::vector<double>& delays_s) {
    const auto n = static_cast<Eigen::Index>(places_m.size());
    Vector3d middle_m = Vector3d::Zero();
    double mean_s = 0;
    for (size_t i = 0; i < places_m.size(); ++i)
        middle_m += places_m[i] / static_cast<double>(n), mean_s += delays_s[i] / static_cast<double>(n);
    double best_s = 1;
    for (int start = 0; start < 8; ++start) {
        const double turn = start * std::numbers::pi / 4;
        Eigen::Vector4d at;  // place, clock times the speed of sound
        at << middle_m + kStart_m * Vector3d(std::sin(turn), 0.1, std::cos(turn)),
            mean_s * kSupposedSound_m_per_s - kStart_m;
        double damping = 1e-3, error = 1e18;
        for (int step = 0; step < kSteps; ++step) {
            Eigen::Matrix<double, Eigen::Dynamic, 4> slope(n, 4);
            Eigen::VectorXd residual(n);
            for (Eigen::Index i = 0; i < n; ++i) {
                const Vector3d way_m = at.head<3>() - places_m[static_cast<size_t>(i)];
                const double length_m = std::max(way_m.norm(), 1e-6);
                residual[i] = length_m + at[3] - delays_s[static_cast<size_t>(i)] * kSupposedSound_m_per_s;
                slope.row(i) << way_m.transpose() / length_m, 1;
            }
            damping = residual.squaredNorm() < error ? damping / 3 : damping * 10;
            error = std::min(error, residual.squaredNorm());
            const Eigen::Matrix4d normal = slope.transpose() * slope;
            at -=
                solveSymmetric(normal + damping * Eigen::Matrix4d::Identity(), slope.transpose() * residual);
        }
        best_s = std::min(best_s, std::sqrt(error / static_cast<double>(n - 4)) / kSupposedSound_m_per_s);
    }
    return best_s;
}

/// Median misfit of the boards; nothing when too few boards hear enough sources.
std::optional<double> misfitOf(const Delays& delays, const Direction& direction) {
    std::map<int, std::pair<std::vector<Vector3d>, std::vector<double>>> boards;
    for (const auto& [pair, delay_s] : delays) {
        auto& [places_m, delays_s] = boards[pair.second];
        places_m.push_back(direction.places_m[static_cast<size_t>(pair.first)]);
        delays_s.push_back(delay_s);
    }
    std::vector<double> misfits;
    for (const auto& [board, heard] : boards)
        if (heard.first.size() >= kLeastSources)
            misfits.push_back(misfitOf(heard.first, heard.second));
    if (misfits.size() < kLeastBoards)
        return std::nullopt;
    return medianOf(misfits);
}

/// How many pulses arrivals of this direction were counted wrong by; nothing when that cannot be told.
std::optional<int> countOf(const Direction& direction, double pause_end_s) {
    std::optional<int> best;
    double least_s = 1, second_s = 1;
    for (int pulses = -kMostPulses; pulses <= kMostPulses; ++pulses) {
        const auto misfit_s = misfitOf(delaysOf(direction, pause_end_s, pulses), direction);
        if (!misfit_s)
            continue;
        if (*misfit_s < least_s)
            second_s = std::exchange(least_s, *misfit_s), best = pulses;
        else
            second_s = std::min(second_s, *misfit_s);
    }
    return least_s < kMostMisfit_s && second_s > kClearly * least_s ? best : std::nullopt;
}

/// How long sound takes, source by board; a pair that is not heard is taken as far as those of its source, or
/// as all.
Eigen::MatrixXd waysOf(const Delays& delays, double ahead_s, const Direction& direction) {
    const auto sources = std::ssize(direction.places_m), boards = std::ssize(direction.boards_m);
    std::vector<double> all;
    std::map<int, std::vector<double>> by_source;
    for (const auto& [pair, delay_s] : delays) {
        all.push_back(delay_s - ahead_s);
        by_source[pair.first].push_back(delay_s - ahead_s);
    }
    Eigen::MatrixXd ways_s = Eigen::MatrixXd::Constant(sources, boards, medianOf(std::move(all)));
    for (const auto& [source, ways] : by_source)
        ways_s.row(source).setConstant(medianOf(ways));
    for (const auto& [pair, delay_s] : delays)
        ways_s(pair.first, pair.second) = delay_s - ahead_s;
    return ways_s;
}

/// The room's places are known, and so are those of a body that stands.
std::optional<CoarseClock> clockWithRoom(const Direction& there, const Direction& back,
                                         const std::optional<CoarseClock>& before) {
    const auto found =
        standInRoom(there, back, before ? std::optional(before->ahead_s) : std::nullopt, kMostDrift_s);
    if (!found)
        return std::nullopt;
    return CoarseClock{found->ahead_s, found->ways_s[0], found->ways_s[1], found->misfit_s};
}

}  // namespace

std::optional<CoarseClock> coarseClock(const Direction& there, const Direction& back,
                                       const std::optional<CoarseClock>& before) {
    if (there.from_room || back.from_room)
        return clockWithRoom(there, back, before);
    if (there.arrivals.empty() || back.arrivals.empty())
        return std::nullopt;
    const double there_end = endOfPause(there), back_end = endOfPause(back);
    std::optional<int> there_count, back_count;
    if (!before) {
        there_count = countOf(there, there_end);
        back_count = countOf(back, back_end);
        if (!there_count || !back_count)
            return std::nullopt;
    }
    std::optional<CoarseClock> best;
    for (int t = -kMostPulses; t <= kMostPulses; ++t)
        for (int b = -kMostPulses; b <= kMostPulses; ++b) {
            if (!before && (t != *there_count || b != *back_count))
                continue;
            const Delays there_delays = delaysOf(there, there_end, t),
                         back_delays = delaysOf(back, back_end, b);
            const auto found = agreementOf(there_delays, back_delays, there, back);
            if (found && found->spread_s < (best ? best->spread_s : kMostSpread_s) &&
                (!before || std::abs(found->ahead_s - before->ahead_s) < kMostDrift_s))
                best = CoarseClock{found->ahead_s, waysOf(there_delays, found->ahead_s, there),
                                   waysOf(back_delays, -found->ahead_s, back), found->spread_s};
        }
    return best;
}

}  // namespace noctule::cooperative
