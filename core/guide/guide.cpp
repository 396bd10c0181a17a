// SPDX-License-Identifier: Apache-2.0
#include "core/guide/guide.h"

#include <algorithm>

#include "core/suit/calibration_entries.h"

namespace noctule {

Guide::Guide(const Suit& suit, const Calibration& calibration, int sample_rate_hz, int steps)
    : suit_(suit),
      sample_rate_hz_(sample_rate_hz),
      done_(static_cast<size_t>(steps), std::vector<bool>(suit.boards.size())) {
    Calibration known = calibration;
    for (const Board& board : suit.boards)
        calibrations_.push_back(entryOf(known, board));
}

bool Guide::wasCalibrated(int board, const char* procedure) const {
    return calibrationOf(board).made.contains(procedure);
}

bool Guide::isHeard(const HealthReport& health, int board) const {
    const BoardHealth& now = health.boards[index(board)];
    return !isSkipped(board) && !now.silent && now.means;
}

const Guidance& Guide::look(const HealthReport& health) {
    if (health.boards.size() != suit_.boards.size())
        return now_;
    health_ = health;
    Guidance guidance;
    guidance.boards.assign(suit_.boards.size(), GuidedBoard::kAbsent);
    guidance.askew_rad.resize(suit_.boards.size());
    const Hindrance of_all = see(health, guidance);
    guidance.hindrance = of_all == Hindrance::kNone ? hindranceOf(guidance) : of_all;
    for (int board = 0; board < boardCount(); ++board) {
        if (isSkipped(board))
            continue;
        ++guidance.asked_boards;
        guidance.right_boards += guidance.boards[index(board)] == GuidedBoard::kRight;
        if (const auto& means = health.boards[index(board)].means)
            guidance.worst_accel_deviation_m_per_s2 =
                std::max(guidance.worst_accel_deviation_m_per_s2, means->accel_deviation_m_per_s2);
        if (guidance.boards[index(board)] == GuidedBoard::kRight && guidance.askew_rad[index(board)])
            guidance.worst_askew_rad =
                std::max(guidance.worst_askew_rad.value_or(0), *guidance.askew_rad[index(board)]);
    }
    if (!guidance.isRight() || guidance.step != held_step_ || health.sample < held_from_)
        held_from_ = health.sample;
    held_step_ = guidance.isRight() ? guidance.step : std::nullopt;
    guidance.held_s = static_cast<double>(health.sample - held_from_) / sample_rate_hz_;
    now_ = std::move(guidance);
    return now_;
}

/// Of the boards; what is plainest to mend comes first.
Hindrance Guide::hindranceOf(Guidance& guidance) const {
    constexpr std::pair<GuidedBoard, Hindrance> kOrder[] = {{GuidedBoard::kAbsent, Hindrance::kAbsent},
                                                            {GuidedBoard::kMoves, Hindrance::kMoves},
                                                            {GuidedBoard::kElsewhere, Hindrance::kElsewhere},
                                                            {GuidedBoard::kAskew, Hindrance::kAskew}};
    for (const auto& [state, hindrance] : kOrder) {
        double worst = -1;
        for (int board = 0; board < boardCount(); ++board) {
            if (isSkipped(board) || guidance.boards[index(board)] != state)
                continue;
            ++guidance.hindering;
            const double askew_rad = guidance.askew_rad[index(board)].value_or(0);
            if (askew_rad > worst) {
                worst = askew_rad;
                guidance.board = board;
            }
        }
        guidance.value = std::max(0.0, worst);
        if (guidance.hindering > 0)
            return hindrance;
    }
    if (!guidance.step)
        return Hindrance::kBetweenSteps;
    return isDone(*guidance.step) ? Hindrance::kDone : Hindrance::kNone;
}

bool Guide::isDone(int step) const {
    for (int board = 0; board < boardCount(); ++board)
        if (!isSkipped(board) && !isDone(step, board))
            return false;
    return true;
}

bool Guide::isFinished() const {
    const bool somebody = static_cast<int>(skipped_.size()) < boardCount();
    for (int step = 0; step < stepCount(); ++step)
        if (!isDone(step))
            return false;
    return somebody;
}

void Guide::skip(int board, bool skipped) {
    if (skipped)
        skipped_.insert(board);
    else
        skipped_.erase(board);
}

void Guide::take() {
    if (!now_.step)
        return;
    for (int board = 0; board < boardCount(); ++board)
        if (now_.boards[index(board)] == GuidedBoard::kRight && !isSkipped(board))
            setDone(*now_.step, board);
    learn(*now_.step, health_);
}

void Guide::repeat(int step) {
    done_[index(step)].assign(suit_.boards.size(), false);
    unlearn(step);
}

void Guide::restart() {
    held_step_.reset();
    held_from_ = health_.sample;
    now_.held_s = 0;
}

std::string Guide::labelOf(int) const {
    return {};
}

void Guide::learn(int, const HealthReport&) {}

void Guide::unlearn(int) {}

std::vector<int> Guide::heardBoards(const HealthReport& health, Guidance& guidance) const {
    std::vector<int> heard;
    for (int board = 0; board < boardCount(); ++board)
        if (isHeard(health, board)) {
            heard.push_back(board);
            guidance.boards[index(board)] =
                health.boards[index(board)].still ? GuidedBoard::kRight : GuidedBoard::kMoves;
        }
    return heard;
}

void Guide::lose() {
    now_ = {};
    restart();
}

}  // namespace noctule
