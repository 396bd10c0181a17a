// SPDX-License-Identifier: Apache-2.0
#include "core/cooperative/clock_estimator.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "core/cooperative/offset_line.h"
#include "core/job/contract.h"
#include "core/math/linear_solvers.h"

namespace noctule::cooperative {
namespace {

constexpr int kPasses = 3;                       ///< the first guess is 5 ms off, in which people move
constexpr int kHuberRounds = 3;                  ///< of a window
constexpr double kHuber = 2.5;                   ///< sigmas
constexpr int kWayTerms = 4;                     ///< a cubic of time
constexpr int kDriftTerms = 2;                   ///< a line of time: a constant leaves 5 us where people sway
constexpr size_t kLeastFlights = kWayTerms + 2;  ///< of a pair of housings in a window
constexpr double kJoined_s = 1e-4;               ///< an offset that stays less certain was never measured
/// A window's clock further off the line of most windows near it tells of echoes. Within four minutes
/// crystals keep to a line to 0.02 ms, in an hour to a millisecond.
constexpr double kOffLine_s = 5e-4, kJudged_s = 120, kNear_s = 60;

using Pair = std::tuple<int, int, int, int>;  // suit, housing; the smaller suit first

struct PairFlights {
    Eigen::MatrixXd way;    ///< kWayTerms columns, then the drift of this pair of housings, kDriftTerms
    double drift_weight;    ///< 1 / sigma of that drift; 0: there is none
    Eigen::MatrixXd clock;  ///< offset and rate of each suit but the first, then drifts of pairs of suits
    Eigen::VectorXd flight_s, sigma_s;
};

/// What a window tells of all clocks: information matrix and vector on (offset, rate) of each suit.
struct WindowInformation {
    double centre_s = 0;
    Eigen::MatrixXd matrix;
    Eigen::VectorXd vector;
};

class ClockProblem {
public:
    ClockProblem(const std::vector<TimedFlight>& flights, const std::vector<ClockGuess>& guesses,
                 const ClockSettings& settings)
        : flights_(flights), guesses_(guesses), settings_(settings), tracks_(guesses.size()) {
        for (const TimedFlight& flight : flights)
            pairs_of_suits_.insert(std::minmax(flight.from_suit, flight.to_suit));
    }

    /// About the tracks of the pass before.
    void pass() {
        const auto windows = gather();
        std::vector<WindowInformation> told;
        for (const auto& [index, of_window] : windows) {
            centre_s_ = (static_cast<double>(index) + 0.5) * settings_.window_s;
            lines_.clear();
            for (size_t suit = 0; suit < guesses_.size(); ++suit)
                lines_.push_back(lineAt(suit, centre_s_));
            told.push_back(solveWindow(of_window));
            // About the first guess, which the random walk begins with.
            told.back().vector += told.back().matrix * fromGuess();
        }
        forgetEchoes(told);
        smooth(told);
    }

    std::vector<ClockTrack> result() const {
        std::vector<ClockTrack> tracks = tracks_;
        for (size_t suit = 1; suit < tracks.size(); ++suit) {
            tracks[suit].joined = !tracks[suit].points.empty() &&
                                  std::ranges::any_of(tracks[suit].points, [](const ClockPoint& point) {
                                      return point.sigma_s < kJoined_s;
                                  });
            if (!tracks[suit].joined)
                tracks[suit].points.clear();
        }
        tracks.front() = {true, {{0, 0, 1, 0}}};
        return tracks;
    }

private:
    int clockUnknowns() const { return 2 * static_cast<int>(guesses_.size() - 1); }
    /// Offset and rate of each suit but the first, then the drifts of pairs of suits.
    int unknowns() const { return clockUnknowns() + kDriftTerms * static_cast<int>(pairs_of_suits_.size()); }
    int driftColumn(int a, int b) const {
        const auto found = pairs_of_suits_.find(std::minmax(a, b));
        return clockUnknowns() +
               kDriftTerms * static_cast<int>(std::distance(pairs_of_suits_.begin(), found));
    }

    double guessed(size_t suit, double suit_s) const {
        return guesses_[suit].offset_s + guesses_[suit].rate * suit_s;
    }
    /// A suit's clock about the middle of a window, as a line.
    struct Line {
        double suit_s = 0, take_s = 0, rate = 1;
        double toTake(double at_suit_s) const { return take_s + rate * (at_suit_s - suit_s); }
    };
    Line lineAt(size_t suit, double take_s) const {
        const ClockGuess& guess = guesses_[suit];
        const double suit_s = (take_s - guess.offset_s) / guess.rate;
        const auto& points = tracks_[suit].points;
        if (points.empty())
            return {suit_s, take_s, guess.rate};
        const auto next =
            std::ranges::upper_bound(points, suit_s - 0.5 * settings_.window_s, {}, &ClockPoint::suit_s);
        const ClockPoint& point = next == points.end() ? points.back() : *next;
        return {point.suit_s, point.suit_s + point.offset_s, point.rate};
    }
    /// The lines of this window less the guesses, as a state.
    Eigen::VectorXd fromGuess() const {
        Eigen::VectorXd state(clockUnknowns());
        for (size_t suit = 1; suit < guesses_.size(); ++suit) {
            const double suit_s = (centre_s_ - guesses_[suit].offset_s) / guesses_[suit].rate;
            const auto i = static_cast<Eigen::Index>(2 * (suit - 1));
            state[i] = lines_[suit].toTake(suit_s) - guessed(suit, suit_s);
            state[i + 1] = lines_[suit].rate - guesses_[suit].rate;
        }
        return state;
    }

    using Window = std::map<Pair, std::vector<const TimedFlight*>>;
    std::map<int64_t, Window> gather() const {
        std::map<int64_t, Window> windows;
        for (const TimedFlight& flight : flights_) {
            const auto from = static_cast<size_t>(flight.from_suit);
            const double at = lineAt(from, guessed(from, flight.emission_s)).toTake(flight.emission_s);
            if (!std::isfinite(at))
                continue;
            Pair pair{flight.from_suit, flight.from_housing, flight.to_suit, flight.to_housing};
            if (flight.from_suit > flight.to_suit)
                pair = {flight.to_suit, flight.to_housing, flight.from_suit, flight.from_housing};
            windows[std::llround(std::floor(at / settings_.window_s))][pair].push_back(&flight);
        }
        return windows;
    }

    /// The instant of a flight to which its way belongs: that of the end that moves, else the middle.
    double instantOf(const TimedFlight& flight, double emission_s, double arrival_s) const {
        if (guesses_[static_cast<size_t>(flight.from_suit)].stands_still)
            return arrival_s;
        if (guesses_[static_cast<size_t>(flight.to_suit)].stands_still)
            return emission_s;
        return 0.5 * (emission_s + arrival_s);
    }

    PairFlights linearise(const std::vector<const TimedFlight*>& flights) const {
        const auto n = static_cast<Eigen::Index>(flights.size());
        PairFlights pair{Eigen::MatrixXd::Zero(n, kWayTerms + kDriftTerms), 1 / settings_.drift_of_housings,
                         Eigen::MatrixXd::Zero(n, unknowns()), Eigen::VectorXd(n), Eigen::VectorXd(n)};
        for (Eigen::Index k = 0; k < n; ++k) {
            const TimedFlight& flight = *flights[static_cast<size_t>(k)];
            const double emission_s = lines_[static_cast<size_t>(flight.from_suit)].toTake(flight.emission_s);
            const double arrival_s = lines_[static_cast<size_t>(flight.to_suit)].toTake(flight.arrival_s);
            const double u = (instantOf(flight, emission_s, arrival_s) - centre_s_) / settings_.window_s;
            for (int power = 0; power < kWayTerms; ++power)
                pair.way(k, power) = std::pow(u, power);
            // flight = way - (offset of the arrival's clock) + (offset of the emission's)
            const auto addClock = [&](int suit, double at_s, double sign) {
                if (suit == 0)
                    return;
                pair.clock(k, 2 * (suit - 1)) += sign;
                pair.clock(k, 2 * (suit - 1) + 1) += sign * (at_s - centre_s_);
            };
            addClock(flight.to_suit, arrival_s, -1);
            addClock(flight.from_suit, emission_s, 1);
            if (!guesses_[static_cast<size_t>(flight.from_suit)].stands_still &&
                !guesses_[static_cast<size_t>(flight.to_suit)].stands_still)
                for (int term = 0; term < kDriftTerms; ++term)
                    pair.way(k, kWayTerms + term) =
                        pair.clock(k, driftColumn(flight.from_suit, flight.to_suit) + term) =
                            0.5 * (arrival_s - emission_s) * (flight.from_suit < flight.to_suit ? 1 : -1) *
                            std::pow(2 * u, term);
            pair.flight_s[k] = arrival_s - emission_s;
            pair.sigma_s[k] = flight.sigma_s;
        }
        return pair;
    }

    WindowInformation solveWindow(const Window& window) const {
        std::vector<PairFlights> pairs;
        for (const auto& [pair, flights] : window)
            if (flights.size() >= kLeastFlights)
                pairs.push_back(linearise(flights));
        std::vector<Eigen::VectorXd> weights;
        for (const PairFlights& pair : pairs)
            weights.push_back(pair.sigma_s.cwiseInverse());
        Eigen::MatrixXd N;
        Eigen::VectorXd g;
        for (int round = 0; round < kHuberRounds; ++round) {
            N = Eigen::MatrixXd::Zero(unknowns(), unknowns());
            g = Eigen::VectorXd::Zero(unknowns());
            for (int k = clockUnknowns(); k < unknowns(); ++k)
                N(k, k) = 1 / (settings_.drift_of_pair * settings_.drift_of_pair);
            for (size_t p = 0; p < pairs.size(); ++p)
                addWithoutWay(pairs[p], weights[p], N, g);
            reweigh(pairs, solved(N, g), weights);
        }
        return withoutDrifts(N, g);
    }

    /// Normal equations of the clocks after the way's terms are eliminated.
    static void addWithoutWay(const PairFlights& pair, const Eigen::VectorXd& weight, Eigen::MatrixXd& N,
                              Eigen::VectorXd& g) {
        const Eigen::MatrixXd A = wayEquations(pair, weight);
        Eigen::MatrixXd B = Eigen::MatrixXd::Zero(A.rows(), pair.clock.cols());
        B.topRows(weight.size()) = weight.asDiagonal() * pair.clock;
        Eigen::VectorXd y = Eigen::VectorXd::Zero(A.rows());
        y.head(weight.size()) = weight.cwiseProduct(pair.flight_s);
        Eigen::MatrixXd all(A.rows(), B.cols() + 1);
        all << B, y;
        const Eigen::MatrixXd left = all - A * solveLeastSquares(A, all);
        const auto B_left = left.leftCols(B.cols());
        N += B_left.transpose() * B_left;
        g += B_left.transpose() * left.rightCols<1>();
    }

    /// With last rows that keep the drift small.
    static Eigen::MatrixXd wayEquations(const PairFlights& pair, const Eigen::VectorXd& weight) {
        Eigen::MatrixXd A = Eigen::MatrixXd::Zero(weight.size() + kDriftTerms, pair.way.cols());
        A.topRows(weight.size()) = weight.asDiagonal() * pair.way;
        for (int term = 0; term < kDriftTerms; ++term)
            A(weight.size() + term, kWayTerms + term) = pair.drift_weight;
        return A;
    }

    static Eigen::VectorXd solved(const Eigen::MatrixXd& N, const Eigen::VectorXd& g) {
        return solveLeastSquares(N, g);
    }

    static void reweigh(const std::vector<PairFlights>& pairs, const Eigen::VectorXd& clocks,
                        std::vector<Eigen::VectorXd>& weights) {
        for (size_t p = 0; p < pairs.size(); ++p) {
            const Eigen::VectorXd y = pairs[p].flight_s - pairs[p].clock * clocks;
            Eigen::VectorXd target = Eigen::VectorXd::Zero(y.size() + kDriftTerms);
            target.head(y.size()) = weights[p].cwiseProduct(y);
            const Eigen::VectorXd way = solveLeastSquares(wayEquations(pairs[p], weights[p]), target);
            const Eigen::VectorXd residual = y - pairs[p].way * way;
            for (Eigen::Index k = 0; k < residual.size(); ++k) {
                const double sigmas = std::abs(residual[k]) / pairs[p].sigma_s[k];
                weights[p][k] =
                    std::sqrt(std::min(1.0, kHuber / std::max(sigmas, 1e-9))) / pairs[p].sigma_s[k];
            }
        }
    }

    WindowInformation withoutDrifts(const Eigen::MatrixXd& N, const Eigen::VectorXd& g) const {
        const int n = clockUnknowns();
        const Eigen::Index d = N.rows() - n;
        const Eigen::MatrixXd to_drift = N.topRightCorner(n, d);
        const Eigen::MatrixXd by_drift =
            solveSymmetric(N.bottomRightCorner(d, d), to_drift.transpose()).transpose();
        return {centre_s_, N.topLeftCorner(n, n) - by_drift * to_drift.transpose(),
                g.head(n) - by_drift * g.tail(d)};
    }

    /// Where somebody is heard by way of walls alone, all pairs of housings agree on a wrong clock. Such a
    /// window tells nothing of that suit; where no half of the windows agree, none does.
    void forgetEchoes(std::vector<WindowInformation>& windows) const {
        for (Eigen::Index i = 0; i < clockUnknowns(); i += 2) {
            std::vector<ClockOffset> told;
            std::vector<WindowInformation*> of;
            for (WindowInformation& window : windows)
                if (const auto offset_s = toldAlone(window, i)) {
                    told.push_back({window.centre_s, *offset_s});
                    of.push_back(&window);
                }
            const auto from = [&](double time_s) {
                return std::ranges::lower_bound(told, time_s, {}, &ClockOffset::time_s);
            };
            for (auto next = told.begin(); next != told.end();) {
                const double begin_s = next->time_s, end_s = begin_s + kJudged_s;
                const std::vector<ClockOffset> near(from(begin_s - kNear_s), from(end_s + kNear_s));
                const OffsetLine line = lineThroughMost(near, kOffLine_s);
                const auto fits = [&line](const ClockOffset& one) {
                    return std::abs(one.offset_s - line.at(one.time_s)) < kOffLine_s;
                };
                const bool agree = 2 * std::ranges::count_if(near, fits) >= std::ssize(near);
                for (; next != told.end() && next->time_s < end_s; ++next)
                    if (!agree || !fits(*next))
                        forget(*of[static_cast<size_t>(next - told.begin())], i);
            }
        }
    }

    /// The offset of a suit from its guess by one window alone, where that makes it certain.
    std::optional<double> toldAlone(const WindowInformation& window, Eigen::Index i) const {
        const Eigen::MatrixXd P = inverseOf(window.matrix + inverseOf(guessCovariance()));
        if (!(P(i, i) < kJoined_s * kJoined_s))
            return std::nullopt;
        return P.row(i).dot(window.vector);
    }

    static void forget(WindowInformation& window, Eigen::Index i) {
        const Eigen::MatrixXd to_suit = window.matrix.middleCols(i, 2);
        const Eigen::MatrixXd left = solveLeastSquares(to_suit.middleRows(i, 2), to_suit.transpose());
        window.vector -= left.transpose() * window.vector.segment(i, 2).eval();
        window.matrix -= to_suit * left;
    }

    Eigen::MatrixXd guessCovariance() const {
        Eigen::VectorXd sigmas(clockUnknowns());
        for (Eigen::Index i = 0; i < sigmas.size(); i += 2)
            sigmas.segment<2>(i) << settings_.guess_sigma_s, settings_.guess_rate_sigma;
        return sigmas.cwiseAbs2().asDiagonal();
    }

    struct ClockState {
        double centre_s = 0;
        Eigen::VectorXd x, x_predicted;
        Eigen::MatrixXd P, P_predicted, F;
    };

    /// A random walk of offset and rate over the windows, forwards and then backwards (Rauch, Tung and
    /// Striebel). The states are corrections of the first guess.
    void smooth(const std::vector<WindowInformation>& windows) {
        const int n = clockUnknowns();
        std::vector<ClockState> states;
        for (const WindowInformation& window : windows) {
            ClockState state{
                window.centre_s, Eigen::VectorXd::Zero(n), {}, Eigen::MatrixXd::Zero(n, n), {}, {}};
            if (states.empty()) {
                state.P = guessCovariance();
                state.F = Eigen::MatrixXd::Identity(n, n);
            } else {
                predict(states.back(), state);
            }
            state.x_predicted = state.x;
            state.P_predicted = state.P;
            const Eigen::MatrixXd gain =
                solveSquare(Eigen::MatrixXd::Identity(n, n) + state.P * window.matrix, state.P);
            state.x += gain * (window.vector - window.matrix * state.x);
            state.P = 0.5 * (gain + gain.transpose());
            states.push_back(std::move(state));
        }
        for (size_t k = states.size(); k-- > 1;) {
            ClockState& before = states[k - 1];
            const ClockState& after = states[k];
            const Eigen::MatrixXd C = solveSymmetric(after.P_predicted, after.F * before.P).transpose();
            before.x += C * (after.x - after.x_predicted);
            before.P += C * (after.P - after.P_predicted) * C.transpose();
        }
        keep(states);
    }

    void predict(const ClockState& before, ClockState& state) const {
        const auto n = before.x.size();
        const double dt = state.centre_s - before.centre_s;
        state.F = Eigen::MatrixXd::Identity(n, n);
        for (Eigen::Index i = 0; i < n; i += 2)
            state.F(i, i + 1) = dt;
        state.x = state.F * before.x;
        state.P = state.F * before.P * state.F.transpose();
        const double q = std::pow(settings_.offset_wander_s, 2), r = std::pow(settings_.rate_wander, 2);
        for (Eigen::Index i = 0; i < n; i += 2) {
            state.P(i, i) += q * dt + r * dt * dt * dt / 3;
            state.P(i, i + 1) += r * dt * dt / 2;
            state.P(i + 1, i) += r * dt * dt / 2;
            state.P(i + 1, i + 1) += r * dt;
        }
    }

    void keep(const std::vector<ClockState>& states) {
        std::vector<ClockTrack> tracks(guesses_.size());
        for (size_t suit = 1; suit < guesses_.size(); ++suit) {
            const auto i = static_cast<Eigen::Index>(2 * (suit - 1));
            const ClockGuess& guess = guesses_[suit];
            for (const ClockState& state : states) {
                const double suit_s = (state.centre_s - guess.offset_s) / guess.rate;
                tracks[suit].points.push_back(
                    {suit_s, guessed(suit, suit_s) + state.x[i] - suit_s, guess.rate + state.x[i + 1],
                     std::hypot(std::sqrt(std::max(state.P(i, i), 0.0)), settings_.housing_s)});
            }
        }
        tracks_ = std::move(tracks);
    }

    const std::vector<TimedFlight>& flights_;
    const std::vector<ClockGuess>& guesses_;
    ClockSettings settings_;
    std::vector<ClockTrack> tracks_;
    std::set<std::pair<int, int>> pairs_of_suits_;
    double centre_s_ = 0;      ///< of the window in work, take time
    std::vector<Line> lines_;  ///< of each suit in it
};

}  // namespace

std::vector<ClockTrack> estimateClocks(const std::vector<TimedFlight>& flights,
                                       const std::vector<ClockGuess>& guesses,
                                       const ClockSettings& settings) {
    require(!guesses.empty(), "estimateClocks: no suit");
    ClockProblem problem(flights, guesses, settings);
    if (guesses.size() > 1)
        for (int pass = 0; pass < kPasses; ++pass)
            problem.pass();
    return problem.result();
}

double takeTime_s(const ClockTrack& track, double suit_s) {
    require(!track.points.empty(), "takeTime_s: a clock that was not joined");
    const auto& points = track.points;
    auto next = std::ranges::upper_bound(points, suit_s, {}, &ClockPoint::suit_s);
    if (next == points.begin())
        return suit_s + next->offset_s + (next->rate - 1) * (suit_s - next->suit_s);
    const ClockPoint& before = *std::prev(next);
    if (next == points.end())
        return suit_s + before.offset_s + (before.rate - 1) * (suit_s - before.suit_s);
    const double u = (suit_s - before.suit_s) / (next->suit_s - before.suit_s);
    return suit_s + (1 - u) * before.offset_s + u * next->offset_s;
}

}  // namespace noctule::cooperative
