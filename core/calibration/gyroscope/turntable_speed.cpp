// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/gyroscope/turntable_speed.h"

#include <algorithm>
#include <complex>
#include <map>
#include <optional>

#include "core/math/rotation.h"

namespace noctule {
namespace {

using Complex = std::complex<double>;

constexpr double kHeadingGap_s = 0.1;       ///< of silence: the heading is lost
constexpr double kPhaseWindow_s = 2;        ///< at least a turn at 33 1/3 rpm
constexpr double kHeadingDrift_rad = 0.01;  ///< of a zero that wanders, per window
constexpr double kWorstPhase_rad = 0.3;     ///< beyond it a phase might be wrapped

/// A reading in the frame in which the board's first reading of a run stood.
struct Attitude {
    double time_s = 0;
    Quaterniond q_run_board = Quaterniond::Identity();
    Vector3d rate_rad_per_s = Vector3d::Zero(), accel_m_per_s2 = Vector3d::Zero();
    double turned_rad = 0;  ///< about the table's axis, since the run began
};
using Run = std::vector<Attitude>;  ///< without a gap

Vector3d zeroAt(const std::vector<std::pair<double, Vector3d>>& zeros, double time_s) {
    const auto after =
        std::ranges::upper_bound(zeros, time_s, {}, [](const auto& zero) { return zero.first; });
    if (after == zeros.begin())
        return zeros.front().second;
    const auto before = after - 1;
    if (after == zeros.end())
        return before->second;
    const double share = (time_s - before->first) / (after->first - before->first);
    return before->second + share * (after->second - before->second);
}

std::vector<Run> follow(const HeadingBoard& board, const BoardRecord::Part& part) {
    const auto& zeros = board.zeros[static_cast<size_t>(part.take)];
    const AxisCalibration accel = AxisCalibration::nominal(board.record->board.accel_full_scale_m_per_s2);
    std::vector<Run> runs;
    for (const CountReading& reading : *part.readings) {
        Attitude next;
        next.time_s = reading.time_s;
        next.rate_rad_per_s = board.matrix * (reading.gyro_counts - zeroAt(zeros, reading.time_s));
        next.accel_m_per_s2 = accel.apply(reading.accel_counts);
        if (runs.empty() || reading.time_s - runs.back().back().time_s > kHeadingGap_s) {
            runs.emplace_back();
        } else {
            const Attitude& last = runs.back().back();
            const Vector3d turn =
                (last.rate_rad_per_s + next.rate_rad_per_s) / 2 * (next.time_s - last.time_s);
            next.q_run_board = (last.q_run_board * expQuaternion(turn)).normalized();
        }
        runs.back().push_back(next);
    }
    return runs;
}

std::span<const Attitude> during(const Run& run, const SteadyStretch& turn) {
    const auto begin = std::ranges::lower_bound(run, turn.begin_s, {}, &Attitude::time_s);
    const auto end = std::ranges::upper_bound(run, turn.end_s, {}, &Attitude::time_s);
    return {begin, end};
}

Vector3d meanAxis(std::span<const Attitude> turn) {
    Vector3d sum = Vector3d::Zero();
    for (const Attitude& at : turn)
        sum += at.rate_rad_per_s;
    return sum.normalized();
}

void countTurning(Run& run, const Vector3d& up_run) {
    for (size_t i = 1; i < run.size(); ++i) {
        const auto upward = [&](const Attitude& at) {
            return (at.q_run_board * at.rate_rad_per_s).dot(up_run);
        };
        run[i].turned_rad = run[i - 1].turned_rad +
                            (upward(run[i - 1]) + upward(run[i])) / 2 * (run[i].time_s - run[i - 1].time_s);
    }
}

/// Where gravity's ripple stood in a window of a turn; if the table's speed is right, always at one place.
struct RipplePhase {
    int group = 0;  ///< one run of one board: its headings have one origin
    int board = 0;
    double turned_rad = 0, phase_rad = 0, sigma_rad = 0, swing_m_per_s2 = 0;
};

/// A window of a turn: sums over its readings of the horizontal acceleration, which is constant + ripple *
/// towards.
struct RippleWindow {
    double members = 0, turned_rad = 0;
    Complex reading, towards;
    Complex along;  ///< of conj(towards) * reading
    Complex rippleWith(const Complex& constant) const {
        return (along - std::conj(towards) * constant) / members;
    }
};

/// The constant of all windows in least squares, their ripples eliminated. Nothing where the turns do not
/// tell the two apart: too little of a turn in each window.
std::optional<Complex> constantOf(const std::vector<RippleWindow>& windows) {
    constexpr double kLeastTold = 1e-6;  ///< variance of the azimuth within windows, rad^2
    Complex right;
    double told = 0, members = 0;
    for (const RippleWindow& window : windows) {
        right += window.reading - window.towards * window.along / window.members;
        told += window.members - std::norm(window.towards) / window.members;
        members += window.members;
    }
    return told > kLeastTold * members ? std::optional(right / told) : std::nullopt;
}

/// Horizontal acceleration in the board's frame = constant + ripple exp(-i azimuth), the azimuth that of a
/// horizontal direction of the board, by the gyroscope; one ripple for each window of the turn.
std::vector<RipplePhase> phasesOf(std::span<const Attitude> turn, const Vector3d& up_run) {
    const double begin_s = turn.front().time_s, length_s = turn.back().time_s - begin_s;
    if (!(length_s > 0))
        return {};
    Vector3d up_board = meanAxis(turn);
    if ((turn.front().q_run_board * up_board).dot(up_run) < 0)
        up_board = -up_board;
    const Vector3d first = up_board.unitOrthogonal(), second = up_board.cross(first);
    const Vector3d east = up_run.unitOrthogonal(), north = up_run.cross(east);
    const auto readingAt = [&](const Attitude& at) {
        return Complex(at.accel_m_per_s2.dot(first), at.accel_m_per_s2.dot(second));
    };
    std::vector<RippleWindow> windows(std::max<size_t>(1, static_cast<size_t>(length_s / kPhaseWindow_s)));
    for (const Attitude& at : turn) {
        const double place = (at.time_s - begin_s) / length_s * static_cast<double>(windows.size());
        RippleWindow& window = windows[std::min(windows.size() - 1, static_cast<size_t>(place))];
        const Vector3d forward = at.q_run_board * first;
        const Complex towards = std::polar(1.0, -std::atan2(forward.dot(north), forward.dot(east)));
        ++window.members;
        window.turned_rad += at.turned_rad;
        window.reading += readingAt(at);
        window.towards += towards;
        window.along += std::conj(towards) * readingAt(at);
    }
    std::erase_if(windows, [](const RippleWindow& window) { return window.members == 0; });
    const std::optional<Complex> constant = constantOf(windows);
    if (!constant)
        return {};
    double unexplained = 0;
    for (const Attitude& at : turn)
        unexplained += std::norm(readingAt(at) - *constant);
    for (const RippleWindow& window : windows)
        unexplained -= window.members * std::norm(window.rippleWith(*constant));
    const double variance = std::max(0.0, unexplained) / (2.0 * static_cast<double>(turn.size()));
    std::vector<RipplePhase> phases;
    for (const RippleWindow& window : windows) {
        const Complex ripple = window.rippleWith(*constant);
        phases.push_back({0, 0, window.turned_rad / window.members, std::arg(ripple),
                          std::sqrt(variance / window.members) / std::abs(ripple), std::abs(ripple)});
    }
    return phases;
}

/// Of all turns in one run, unwrapped; those that noise hides are left out.
std::vector<RipplePhase> phasesOfRun(Run& run, const std::vector<const SteadyStretch*>& turns) {
    const std::span<const Attitude> opening = during(run, *turns.front());
    const Vector3d up_run = (opening[opening.size() / 2].q_run_board * meanAxis(opening)).normalized();
    countTurning(run, up_run);
    std::vector<RipplePhase> phases;
    for (const SteadyStretch* turn : turns)
        for (RipplePhase& phase : phasesOf(during(run, *turn), up_run)) {
            if (!(phase.sigma_rad < kWorstPhase_rad))
                continue;
            if (!phases.empty())
                phase.phase_rad =
                    phases.back().phase_rad +
                    std::remainder(phase.phase_rad - phases.back().phase_rad, 2 * std::numbers::pi);
            phases.push_back(phase);
        }
    return phases;
}

std::vector<RipplePhase> allPhases(const std::vector<HeadingBoard>& boards) {
    std::vector<RipplePhase> all;
    int group = 0;
    for (size_t b = 0; b < boards.size(); ++b)
        for (const BoardRecord::Part& part : boards[b].record->parts)
            if (!boards[b].zeros[static_cast<size_t>(part.take)].empty())
                for (Run& run : follow(boards[b], part)) {
                    std::vector<const SteadyStretch*> turns;
                    for (const SteadyStretch& turn : boards[b].turns)
                        if (turn.take == part.take && turn.begin_s >= run.front().time_s &&
                            turn.end_s <= run.back().time_s)
                            turns.push_back(&turn);
                    if (turns.empty())
                        continue;
                    for (RipplePhase phase : phasesOfRun(run, turns)) {
                        phase.group = group;
                        phase.board = static_cast<int>(b);
                        all.push_back(phase);
                    }
                    ++group;
                }
    return all;
}

double weightOf(const RipplePhase& phase) {
    return 1 / (phase.sigma_rad * phase.sigma_rad + kHeadingDrift_rad * kHeadingDrift_rad);
}

/// Takes the weighted mean of phase and turning off each group. Groups follow one another.
void center(std::vector<RipplePhase>& phases) {
    for (size_t first = 0, end = 0; first < phases.size(); first = end) {
        double mass = 0, turned = 0, phase = 0;
        for (end = first; end < phases.size() && phases[end].group == phases[first].group; ++end) {
            mass += weightOf(phases[end]);
            turned += weightOf(phases[end]) * phases[end].turned_rad;
            phase += weightOf(phases[end]) * phases[end].phase_rad;
        }
        for (size_t i = first; i < end; ++i) {
            phases[i].turned_rad -= turned / mass;
            phases[i].phase_rad -= phase / mass;
        }
    }
}

}  // namespace

std::optional<SpeedRatio> turntableSpeed(const std::vector<HeadingBoard>& boards) {
    std::vector<RipplePhase> phases = allPhases(boards);
    center(phases);
    double information = 0, moment = 0;
    for (const RipplePhase& phase : phases) {
        information += weightOf(phase) * phase.turned_rad * phase.turned_rad;
        moment += weightOf(phase) * phase.turned_rad * phase.phase_rad;
    }
    if (!(information > 0))
        return std::nullopt;
    // A board's phases err together, by the wandering of its gyroscope: each board counts as one witness.
    SpeedRatio ratio;
    ratio.excess = -moment / information;
    std::map<int, double> pull;
    for (const RipplePhase& phase : phases) {
        const double residual_rad = phase.phase_rad + ratio.excess * phase.turned_rad;
        pull[phase.board] += weightOf(phase) * phase.turned_rad * residual_rad;
        ratio.swing_m_per_s2 += phase.swing_m_per_s2 / static_cast<double>(phases.size());
    }
    double scatter = 0;
    for (const auto& [board, off] : pull)
        scatter += off * off;
    ratio.boards = static_cast<int>(pull.size());
    const double witnesses = ratio.boards;
    const double by_scatter =
        witnesses > 1 ? std::sqrt(scatter * witnesses / (witnesses - 1)) / information : 0;
    ratio.sigma = std::max(by_scatter, 1 / std::sqrt(information));
    return ratio;
}

}  // namespace noctule
