// SPDX-License-Identifier: Apache-2.0
#include "core/cooperative/clock_of_room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <random>

#include "core/math/linear_solvers.h"
#include "core/math/order_statistics.h"

namespace noctule::cooperative {
namespace {

constexpr double kGuess_s = 0.006;        ///< recorders guess by their network's time, 5 ms wrong at most
constexpr double kWidestClock_s = 0.012;  ///< by which they may guess wrong all the same
constexpr double kLongestWay_s = 0.024;   ///< of sound: 8 m
constexpr size_t kMostArrivals = 200, kLeastArrivals = 30;
constexpr double kCell_m = 0.2, kBeyond_m = 1;  ///< places are sought so far outside of the anchors
constexpr int kMostCells = 40, kTurns = 24;     ///< per axis; about the vertical
constexpr double kBin_s = 0.0005;               ///< of the clocks that are voted for: 17 cm
constexpr size_t kRefined = 8;                  ///< clocks, those with the most votes
constexpr int kRefinements = 24;
constexpr double kEcho_m = 0.1;      ///< what misses by more came around the body or from a wall
constexpr double kFits_m = 0.2;      ///< what misses by so much counts half: anchors may be known by eye only
constexpr double kLeastShare = 0.4;  ///< of all arrivals, and of those of a direction with more than a few
constexpr size_t kFewArrivals = 8;
constexpr double kClearlyMore = 1.25, kMoreArrivals = 4;  ///< by which another clock fits less
constexpr double kFitsMisfits = 4, kTight_m = 0.04;  ///< beside other places, so much of the median miss fits
constexpr double kClose_s = 0.00006, kMuchCloser = 2;  ///< 2 cm, by which standing people are off
/// Where nothing else tells the clock: people do not always stand as believed.
constexpr double kSureShare = 0.85;
constexpr size_t kPlaces = 4;  ///< of each clock, those with the most votes
constexpr double kOtherPlace_m = 0.7, kOtherTurn_rad = 0.7;
constexpr double kOtherClock_s = 0.001;  ///< clocks that differ by more are different answers

struct PossiblePulse {
    int source;
    double delay_s;
};
struct Arrival {
    int way;  ///< 0: there, 1: back
    int board;
    std::vector<PossiblePulse> pulses;
};

/// Place and turn of a body on the floor, and the clock in metres of sound.
using Placement = Eigen::Vector4d;  // x, z, turn, clock

/// By which the clock lengthens the delays.
double signOf(int way) {
    return way == 0 ? 1 : -1;
}

class RoomSearch {
public:
    RoomSearch(const Direction& there, const Direction& back, double expected_s, double within_s,
               double least_share)
        : ways_{&there, &back}, expected_s_(expected_s), within_s_(within_s), least_share_(least_share) {
        addArrivals(0);
        addArrivals(1);
    }

    std::optional<StandingInRoom> find() {
        if (arrivals_.size() < kLeastArrivals || hung().empty())
            return std::nullopt;
        vote();
        std::vector<Candidate> found;
        for (const Vote& vote : mostVoted())
            found.push_back(refined(vote.placement));
        std::ranges::sort(found, std::ranges::greater{},
                          [](const Candidate& one) { return one.standing.share; });
        auto best =
            std::ranges::find_if(found, [&](const Candidate& one) { return isGuessed(one) && isGood(one); });
        if (best == found.end() || !isCertain(*best, found))
            best = found.begin();
        return isGood(*best) && isCertain(*best, found) ? std::optional(best->standing) : std::nullopt;
    }

private:
    struct Vote {
        int count = 0;
        Placement placement = Placement::Zero();
    };

    struct Candidate {
        Placement at;
        StandingInRoom standing;
    };

    void addArrivals(int way) {
        const Direction& direction = *ways_[static_cast<size_t>(way)];
        const double clock_s = signOf(way) * expected_s_;
        const auto first = static_cast<int>(std::floor((clock_s - within_s_) / direction.interval_s));
        const auto last =
            static_cast<int>(std::ceil((clock_s + within_s_ + kLongestWay_s) / direction.interval_s));
        // Every n-th would be of the same few boards.
        std::vector<LooseArrival> some;
        std::mt19937 random;
        std::ranges::sample(direction.arrivals, std::back_inserter(some), kMostArrivals, random);
        for (const LooseArrival& heard : some) {
            Arrival arrival{way, heard.board, {}};
            for (int back = first; back <= last; ++back)
                if (const int pulse = heard.pulse - back;
                    pulse >= 0 && pulse < static_cast<int>(direction.sources.size()))
                    arrival.pulses.push_back({direction.sources[static_cast<size_t>(pulse)],
                                              heard.delay_s + back * direction.interval_s});
            if (!arrival.pulses.empty())
                ++count_[static_cast<size_t>(way)], arrivals_.push_back(std::move(arrival));
        }
    }

    double guessedWrong_s(const Candidate& one) const { return std::abs(one.standing.ahead_s - expected_s_); }
    bool isGuessed(const Candidate& one) const { return guessedWrong_s(one) < kGuess_s; }
    /// All in all, and in either direction in which something is heard.
    bool isGood(const Candidate& one) const {
        const auto fits = [&](int way) {
            return count_[static_cast<size_t>(way)] < kFewArrivals ||
                   shareOf(one.at, way, kFits_m) >= kLeastShare;
        };
        return one.standing.share >= least_share_ && guessedWrong_s(one) <= within_s_ && fits(0) && fits(1);
    }
    /// No other clock fits about as well. Equal anchors that hang in a square look alike from four sides,
    /// each a pulse interval from the next: then it counts which of them the recorder can have meant.
    bool isCertain(const Candidate& best, const std::vector<Candidate>& found) const {
        return std::ranges::all_of(found, [&](const Candidate& other) {
            if (std::abs(other.standing.ahead_s - best.standing.ahead_s) < kOtherClock_s ||
                isClearlyWorse(other, best))
                return true;
            return isGuessed(best) && !isGuessed(other) && !isClearlyWorse(best, other);
        });
    }

    /// In either direction, by what the better one misses; or it misses by more than shapes and places of
    /// bodies are off, and the better one does not.
    bool isClearlyWorse(const Candidate& other, const Candidate& best) const {
        const double misses_s = best.standing.misfit_s;
        const double fits_m = std::clamp(kFitsMisfits * misses_s * kSupposedSound_m_per_s, kTight_m, kFits_m);
        for (const int way : {0, 1}) {
            const double of_best = shareOf(best.at, way, fits_m), of_other = shareOf(other.at, way, fits_m);
            const double more = (of_best - of_other) * static_cast<double>(count_[static_cast<size_t>(way)]);
            if (more >= kMoreArrivals && of_other * kClearlyMore <= of_best)
                return true;
        }
        return misses_s < kClose_s && other.standing.misfit_s > std::max(kClose_s, kMuchCloser * misses_s);
    }

    const std::vector<Vector3d>& hung() const {
        const std::vector<Vector3d>& there = ways_[0]->from_room ? ways_[0]->places_m : ways_[0]->boards_m;
        return there.empty() ? (ways_[1]->from_room ? ways_[1]->places_m : ways_[1]->boards_m) : there;
    }
    double wayOf(const Placement& at, int way, int source, int board) const {
        const Direction& direction = *ways_[static_cast<size_t>(way)];
        const Vector3d& sounds = direction.places_m[static_cast<size_t>(source)];
        const Vector3d& hears = direction.boards_m[static_cast<size_t>(board)];
        const Vector3d& worn = direction.from_room ? hears : sounds;
        const double sine = std::sin(at[2]), cosine = std::cos(at[2]);
        const Vector3d turned(cosine * worn.x() + sine * worn.z(), worn.y(),
                              -sine * worn.x() + cosine * worn.z());
        return (turned + Vector3d(at[0], 0, at[1]) - (direction.from_room ? sounds : hears)).norm();
    }

    /// Source x board, seconds.
    Eigen::MatrixXd allWays(const Placement& at, int way) const {
        const Direction& direction = *ways_[static_cast<size_t>(way)];
        Eigen::MatrixXd ways_s(std::ssize(direction.places_m), std::ssize(direction.boards_m));
        for (int source = 0; source < ways_s.rows(); ++source)
            for (int board = 0; board < ways_s.cols(); ++board)
                ways_s(source, board) = wayOf(at, way, source, board) / kSupposedSound_m_per_s;
        return ways_s;
    }

    /// Every placement of a grid votes for the clock that most arrivals agree on.
    void vote() {
        const auto bins = static_cast<size_t>(2 * within_s_ / kBin_s) + 1;
        votes_.assign(bins, {});
        Vector3d low = hung().front(), high = low;
        for (const Vector3d& place : hung())
            low = low.cwiseMin(place), high = high.cwiseMax(place);
        const double from_x = low.x() - kBeyond_m, from_z = low.z() - kBeyond_m;
        const double wide_x = high.x() + kBeyond_m - from_x, wide_z = high.z() + kBeyond_m - from_z;
        const double cell_m = std::max(kCell_m, std::max(wide_x, wide_z) / kMostCells);
        for (int turn = 0; turn < kTurns; ++turn)
            for (double x = from_x; x <= from_x + wide_x; x += cell_m)
                for (double z = from_z; z <= from_z + wide_z; z += cell_m)
                    voteAt({x, z, 2 * std::numbers::pi * turn / kTurns, 0});
    }

    void voteAt(Placement at) {
        const std::array<Eigen::MatrixXd, 2> ways_s{allWays(at, 0), allWays(at, 1)};
        std::vector<int> counts(votes_.size());
        std::vector<const Arrival*> counted(votes_.size());  // once, whichever of its pulses fits
        for (const Arrival& arrival : arrivals_) {
            const auto way = static_cast<size_t>(arrival.way);
            for (const PossiblePulse& pulse : arrival.pulses) {
                const double way_s = ways_s[way](pulse.source, arrival.board);
                const double clock_s = signOf(arrival.way) * (pulse.delay_s - way_s);
                const auto bin = static_cast<int>(std::floor((clock_s - expected_s_ + within_s_) / kBin_s));
                for (int near = std::max(bin - 1, 0);
                     near < std::min(bin + 2, static_cast<int>(counts.size())); ++near)
                    if (auto& last = counted[static_cast<size_t>(near)]; last != &arrival)
                        last = &arrival, ++counts[static_cast<size_t>(near)];
            }
        }
        for (size_t bin = 0; bin < counts.size(); ++bin) {
            const double clock_s = expected_s_ - within_s_ + (static_cast<double>(bin) + 0.5) * kBin_s;
            at[3] = clock_s * kSupposedSound_m_per_s;
            keep({counts[bin], at}, votes_[bin]);
        }
    }

    static bool isElsewhere(const Placement& a, const Placement& b) {
        return (a - b).head<2>().norm() > kOtherPlace_m ||
               std::abs(std::remainder(a[2] - b[2], 2 * std::numbers::pi)) > kOtherTurn_rad;
    }

    /// The most voted places of a clock, one of each neighbourhood: the cell next to the true place need not
    /// be the one with the most votes.
    static void keep(const Vote& vote, std::vector<Vote>& places) {
        const auto near = std::ranges::find_if(
            places, [&](const Vote& other) { return !isElsewhere(other.placement, vote.placement); });
        if (near != places.end()) {
            if (near->count < vote.count)
                *near = vote;
        } else if (places.size() < kPlaces) {
            places.push_back(vote);
        } else if (const auto least = std::ranges::min_element(places, {}, &Vote::count);
                   least->count < vote.count) {
            *least = vote;
        }
    }

    std::vector<Vote> mostVoted() const {
        const auto most = [](const std::vector<Vote>& places) {
            return places.empty() ? 0 : std::ranges::max_element(places, {}, &Vote::count)->count;
        };
        std::vector<std::vector<Vote>> best = votes_;
        std::ranges::sort(best, std::ranges::greater{}, most);
        std::vector<std::vector<Vote>> apart;
        for (const std::vector<Vote>& places : best) {
            const bool is_new = !places.empty() && std::ranges::none_of(apart, [&](const auto& other) {
                return std::abs(other.front().placement[3] - places.front().placement[3]) <
                       kOtherClock_s * kSupposedSound_m_per_s;
            });
            if (is_new && apart.size() < kRefined)
                apart.push_back(places);
        }
        std::vector<Vote> all;
        for (const std::vector<Vote>& places : apart)
            all.insert(all.end(), places.begin(), places.end());
        return all;
    }

    /// By how much an arrival misses, metres, with the source of the pulse that it fits best.
    std::pair<double, int> missOf(const Arrival& arrival, const Placement& at) const {
        std::pair<double, int> least{std::numeric_limits<double>::max(), 0};
        for (const PossiblePulse& pulse : arrival.pulses) {
            const double miss = wayOf(at, arrival.way, pulse.source, arrival.board) +
                                signOf(arrival.way) * at[3] - pulse.delay_s * kSupposedSound_m_per_s;
            if (std::abs(miss) < std::abs(least.first))
                least = {miss, pulse.source};
        }
        return least;
    }

    Candidate refined(Placement at) const {
        constexpr double kStep = 1e-5;
        double damping = 1e-3, error = std::numeric_limits<double>::max();
        Placement best = at;
        for (int step = 0; step < kRefinements; ++step) {
            Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
            Eigen::Vector4d gradient = Eigen::Vector4d::Zero();
            double cost = 0;
            for (const Arrival& arrival : arrivals_) {
                const auto [miss, source] = missOf(arrival, at);
                const double square = miss * miss / (kEcho_m * kEcho_m);
                cost += std::log1p(square);
                Eigen::Vector4d slope;
                for (int axis = 0; axis < 3; ++axis) {
                    Placement moved = at;
                    moved[axis] += kStep;
                    slope[axis] = (wayOf(moved, arrival.way, source, arrival.board) -
                                   wayOf(at, arrival.way, source, arrival.board)) /
                                  kStep;
                }
                slope[3] = signOf(arrival.way);
                normal += slope * slope.transpose() / (1 + square);
                gradient += slope * (miss / (1 + square));
            }
            damping = cost < error ? damping / 3 : damping * 10;
            if (cost < error)
                error = cost, best = at;
            at -= solveSymmetric(normal + damping * Eigen::Matrix4d::Identity(), gradient);
        }
        return {best, described(best)};
    }

    /// Of the arrivals of a way; one that misses by `fits_m` counts half.
    double shareOf(const Placement& at, int way, double fits_m) const {
        double share = 0;
        for (const Arrival& arrival : arrivals_)
            if (arrival.way == way)
                share += 1 / (1 + std::pow(missOf(arrival, at).first / fits_m, 2)) /
                         static_cast<double>(count_[static_cast<size_t>(way)]);
        return share;
    }

    StandingInRoom described(const Placement& at) const {
        StandingInRoom standing;
        standing.ahead_s = at[3] / kSupposedSound_m_per_s;
        std::vector<double> misses;
        for (const Arrival& arrival : arrivals_)
            misses.push_back(std::abs(missOf(arrival, at).first) / kSupposedSound_m_per_s);
        standing.misfit_s = medianOf(std::move(misses));
        for (const int way : {0, 1}) {
            const auto w = static_cast<size_t>(way);
            standing.share += shareOf(at, way, kFits_m) * static_cast<double>(count_[w]) /
                              static_cast<double>(arrivals_.size());
            standing.ways_s[w] = allWays(at, way);
        }
        return standing;
    }

    std::array<const Direction*, 2> ways_;
    double expected_s_, within_s_, least_share_;
    std::vector<Arrival> arrivals_;
    std::array<size_t, 2> count_{};         ///< of the arrivals there and back
    std::vector<std::vector<Vote>> votes_;  // by clock, of several places
};

}  // namespace

std::optional<StandingInRoom> standInRoom(const Direction& there, const Direction& back,
                                          std::optional<double> expected_s, double within_s) {
    return expected_s ? RoomSearch(there, back, *expected_s, within_s, kLeastShare).find()
                      : RoomSearch(there, back, 0, kWidestClock_s, kSureShare).find();
}

}  // namespace noctule::cooperative
