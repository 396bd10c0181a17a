// SPDX-License-Identifier: Apache-2.0
#include "core/guide/movement_guide.h"

#include <algorithm>

#include "core/guide/stand_guide.h"

namespace noctule {
namespace {

/// The take of a step that is not kept until then has lost its rest pose.
constexpr double kTooLate_s = MovementGuide::kMove_s + 1;
constexpr double kJudged_s = 0.2;  // before the end

}  // namespace

int MovementGuide::nextStep() const {
    for (int step = 0; step < stepCount(); ++step)
        if (!isDone(step))
            return step;
    return stepCount() - 1;
}

void MovementGuide::standAgain() {
    stood_from_.reset();
    moving_from_.reset();
    moved_.assign(moved_.size(), false);
}

void MovementGuide::learn(int, const HealthReport&) {
    standAgain();
    left_out_.clear();
}

void MovementGuide::unlearn(int) {
    standAgain();
}

Hindrance MovementGuide::seeStanding(const HealthReport& health, bool all_calm) {
    const bool stood_enough = stood_from_ && since_s(*stood_from_, health.sample) >= kStand_s;
    if (all_calm) {
        stood_from_ = std::min(stood_from_.value_or(health.sample), health.sample);
        return stood_enough ? Hindrance::kMove : Hindrance::kStand;
    }
    if (!stood_enough) {
        stood_from_.reset();
        return Hindrance::kNone;  // the boards say what moves
    }
    moving_from_ = health.sample;
    left_out_.clear();
    return Hindrance::kNone;
}

Hindrance MovementGuide::seeMoving(const HealthReport& health, const std::vector<int>& heard, bool all_calm,
                                   Guidance& guidance) {
    const double moving_s = since_s(*moving_from_, health.sample);
    const auto exercise = static_cast<Exercise>(*guidance.step);
    std::vector<bool> left_out(moved_.size());
    for (const int board : heard) {
        const auto& means = *health.boards[index(board)].means;
        if (means.gyro_deviation_rad_per_s > kIdle_rad_per_s)
            moved_[index(board)] = true;
        left_out[index(board)] =
            !moved_[index(board)] && asksFor(exercise, suit().boards[index(board)].segment);
        guidance.boards[index(board)] = GuidedBoard::kRight;
    }
    const bool in_vain =
        moving_s > kMove_s - kJudged_s && std::ranges::find(left_out, true) != left_out.end();
    if (!in_vain && !all_calm && moving_s >= 0 && moving_s < kTooLate_s)
        return Hindrance::kNone;
    standAgain();
    if (in_vain)
        left_out_ = left_out;
    return Hindrance::kStand;
}

Hindrance MovementGuide::see(const HealthReport& health, Guidance& guidance) {
    const std::vector<int> heard = heardBoards(health, guidance);
    if (heard.empty())
        return Hindrance::kNoReadings;
    guidance.step = nextStep();
    for (int board = 0; board < boardCount(); ++board)
        if (!isSkipped(board) && !isHeard(health, board)) {
            standAgain();
            return Hindrance::kNone;  // the boards say which
        }
    bool all_calm = true;
    for (const int board : heard) {
        const bool calm = StandGuide::isCalm(*health.boards[index(board)].means);
        guidance.boards[index(board)] = calm ? GuidedBoard::kRight : GuidedBoard::kMoves;
        all_calm &= calm;
    }
    const bool was_moving = isMoving();
    Hindrance hindrance =
        was_moving ? seeMoving(health, heard, all_calm, guidance) : seeStanding(health, all_calm);
    if (isMoving())
        for (const int board : heard)
            guidance.boards[index(board)] = GuidedBoard::kRight;
    if (hindrance != Hindrance::kStand)
        return hindrance;
    guidance.value = kStand_s - (stood_from_ ? since_s(*stood_from_, health.sample) : 0);
    for (size_t board = 0; board < left_out_.size(); ++board)
        if (left_out_[board]) {
            guidance.boards[board] = GuidedBoard::kIdle;
            guidance.board = static_cast<int>(board);
            ++guidance.hindering;
            hindrance = Hindrance::kIdle;
        }
    return hindrance;
}

}  // namespace noctule
