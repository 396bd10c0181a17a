// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/motion/motion_evidence.h"

#include <algorithm>
#include <cmath>

#include "core/calibration/motion/board_signal.h"
#include "core/calibration/still_stretch.h"
#include "core/suit/calibration_entries.h"

namespace noctule {
namespace {

constexpr double kRestKept_s = 1.5;
constexpr double kLeastMotionConfidence = 0.1;
constexpr double kFarthest_m = 3;
/// Steps: nearer to a node the parabola between nodes is truer, and neighbours tell little new.
constexpr double kFarthestFromNode = 0.25;

void readBoard(const BoardSignal& signal, MotionEvidence& evidence) {
    std::vector<BoardTurn> turns;
    std::vector<BoardForce> forces(static_cast<size_t>(evidence.nodes));
    const double h = evidence.step_s;
    int heard = 0;
    for (int k = 0; k < evidence.nodes; ++k) {
        const double t_s = evidence.begin_s + k * h;
        if (k + 1 < evidence.nodes) {
            BoardTurn turn;
            turn.heard = signal.covers(t_s, t_s + h);
            if (turn.heard)
                turn.q_begin_end = signal.turn(t_s, t_s + h);
            heard += turn.heard;
            turns.push_back(turn);
        }
        if (k > 0 && k + 1 < evidence.nodes && signal.covers(t_s - h, t_s + h))
            forces[static_cast<size_t>(k)] = {true, signal.meanForce(t_s, h)};
    }
    evidence.heard_share.push_back(heard / std::max(1.0, static_cast<double>(turns.size())));
    evidence.turns.push_back(std::move(turns));
    evidence.forces.push_back(std::move(forces));
}

void readDistances(const Observations& take, const Calibration& calibration, MotionEvidence& evidence) {
    for (const FlightTime& flight : take.flights) {
        const SourceCalibration* known =
            calibration.findSource(take.suit.sources[static_cast<size_t>(flight.source)].id);
        if (!known || !known->offsets_s.contains(take.detector) || flight.confidence < kLeastMotionConfidence)
            continue;
        const BoardCalibration* board =
            calibration.findBoard(take.suit.boards[static_cast<size_t>(flight.board)].id);
        const double flown_s =
            flight.flight_s - known->offsets_s.at(take.detector) - (board ? board->mic_delay_s : 0);
        const double at = (flight.time_s - evidence.begin_s) / evidence.step_s;
        const int node = static_cast<int>(std::lround(at));
        const double distance_m = flight.c_m_per_s * flown_s;
        if (node < 1 || node + 1 >= evidence.nodes || std::abs(at - node) > kFarthestFromNode ||
            !(distance_m > 0 && distance_m < kFarthest_m))
            continue;
        evidence.distances.push_back({node, at - node, at - node + flown_s / evidence.step_s, flight.source,
                                      flight.board, distance_m, std::min(1.0, flight.confidence)});
    }
}

}  // namespace

int MotionEvidence::restNodes() const {
    int sum = 0;
    for (const NodeSpan& rest : rests)
        sum += rest.count;
    return sum;
}

bool MotionEvidence::isStillStep(int node) const {
    return std::ranges::any_of(rests, [node](const NodeSpan& rest) { return rest.holdsStep(node); });
}

MotionEvidence readMotion(const Observations& take, const StillStretch& still, double step_s,
                          double longest_s) {
    MotionEvidence evidence;
    evidence.step_s = step_s;
    const double rest_s = std::min(kRestKept_s, still.stretch.end_s - still.stretch.begin_s);
    evidence.begin_s = still.stretch.end_s - rest_s;
    const double lasts_s = std::min(longest_s, take.duration_s - evidence.begin_s);
    evidence.nodes = std::max(0, static_cast<int>(std::floor(lasts_s / step_s)));
    evidence.rests = {{0, std::min(evidence.nodes, static_cast<int>(std::floor(rest_s / step_s)))}};
    for (const Stretch& again : returnsTo(still, take)) {
        const int first = static_cast<int>(std::ceil((again.begin_s - evidence.begin_s) / step_s));
        const int last = static_cast<int>(std::floor((again.end_s - evidence.begin_s) / step_s));
        if (first > evidence.rests.back().first + evidence.rests.back().count && last < evidence.nodes)
            evidence.rests.push_back({first, last - first + 1});
    }
    Calibration calibration = take.calibration;
    for (size_t b = 0; b < take.suit.boards.size(); ++b) {
        BoardCalibration& known = entryOf(calibration, take.suit.boards[b]);
        if (still.boards[b].heard())
            known.gyro.zero_counts = still.boards[b].gyro_counts;
        readBoard(BoardSignal(take.boards[b], known), evidence);
    }
    readDistances(take, calibration, evidence);
    return evidence;
}

}  // namespace noctule
