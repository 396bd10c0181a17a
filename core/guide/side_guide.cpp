// SPDX-License-Identifier: Apache-2.0
#include "core/guide/side_guide.h"

#include <algorithm>
#include <cmath>

namespace noctule {
namespace {

/// 20 degrees: between two sides the plate is in somebody's hands.
constexpr double kStandsOut = 0.94;
/// A zero may shift a board's reading by that much, three standard deviations of the usual.
constexpr double kUncalibrated_m_per_s2 = 14;

}  // namespace

int stepOf(const BoardSide& side) {
    return static_cast<int>(std::ranges::find(kBoardSides, side) - kBoardSides.begin());
}

std::optional<BoardSide> sideUp(const std::vector<Vector3d>& accel_m_per_s2) {
    Vector3d sum = Vector3d::Zero();
    for (const Vector3d& accel : accel_m_per_s2)
        sum += accel;
    if (sum.norm() == 0)
        return std::nullopt;
    const BoardSide side = BoardSide::nearest(sum);
    const double along = sum.dot(side.up()) / sum.norm();
    // The zeros of many boards cancel each other, those of a few do not.
    const double needed = kStandsOut - 0.35 / std::sqrt(static_cast<double>(accel_m_per_s2.size()));
    return along > needed ? std::optional(side) : std::nullopt;
}

SideGuide::SideGuide(const Suit& suit, const Calibration& calibration, int sample_rate_hz)
    : Guide(suit, calibration, sample_rate_hz, static_cast<int>(kBoardSides.size())),
      taken_(suit.boards.size()) {}

Vector3d SideGuide::accel_m_per_s2(const HealthReport& health, int board) const {
    return calibrationOf(board).accel.apply(health.boards[index(board)].means->accel_counts);
}

std::optional<double> SideGuide::askew_rad(int board, const Vector3d& accel_m_per_s2,
                                           const BoardSide& side) const {
    Vector3d level = accel_m_per_s2;
    if (!isCalibrated(board)) {
        for (int axis = 0; axis < 3; ++axis) {
            if (axis == side.axis)
                continue;
            const auto zero_m_per_s2 = levelReading_m_per_s2(board, axis);
            if (!zero_m_per_s2)
                return std::nullopt;
            level[axis] -= *zero_m_per_s2;
        }
    }
    level[side.axis] = 0;
    return std::asin(std::min(1.0, level.norm() / kStandardGravity_m_per_s2));
}

Hindrance SideGuide::see(const HealthReport& health, Guidance& guidance) {
    const std::vector<int> heard = heardBoards(health, guidance);
    std::vector<Vector3d> accels;
    for (const int board : heard)
        accels.push_back(accel_m_per_s2(health, board));
    if (heard.empty())
        return Hindrance::kNoReadings;
    const std::optional<BoardSide> side = sideUp(accels);
    if (!side)
        return Hindrance::kBetweenSteps;
    guidance.step = stepOf(*side);
    for (size_t i = 0; i < heard.size(); ++i) {
        const int board = heard[i];
        const bool is_known = isCalibrated(board);
        const double limit_rad = is_known ? kAskew_rad : kUncalibratedAskew_rad;
        guidance.askew_limit_rad = std::max(guidance.askew_limit_rad, limit_rad);
        const std::optional<double> zero_m_per_s2 = is_known ? 0 : zeroAlong_m_per_s2(board, *side);
        const double upright_m_per_s2 = accels[i].dot(side->up()) - side->sign * zero_m_per_s2.value_or(0);
        const double least = zero_m_per_s2 ? kStandardGravity_m_per_s2 / 2
                                           : kStandardGravity_m_per_s2 - kUncalibrated_m_per_s2;
        if (guidance.boards[index(board)] != GuidedBoard::kRight)
            continue;
        guidance.askew_rad[index(board)] = askew_rad(board, accels[i], *side);
        if (upright_m_per_s2 < least)
            guidance.boards[index(board)] = GuidedBoard::kElsewhere;
        else if (guidance.askew_rad[index(board)].value_or(0) > limit_rad)
            guidance.boards[index(board)] = GuidedBoard::kAskew;
    }
    return Hindrance::kNone;
}

/// The mean over the sides in which the axis was level.
std::optional<double> SideGuide::levelReading_m_per_s2(int board, int axis) const {
    double sum_m_per_s2 = 0;
    int sides = 0;
    for (const auto& [step, accel] : taken_[index(board)])
        if (kBoardSides[index(step)].axis != axis) {
            sum_m_per_s2 += accel[axis];
            ++sides;
        }
    return sides > 0 ? std::optional(sum_m_per_s2 / sides) : std::nullopt;
}

/// From sides in which the axis was level, else from the opposite one.
std::optional<double> SideGuide::zeroAlong_m_per_s2(int board, const BoardSide& side) const {
    if (const auto level_m_per_s2 = levelReading_m_per_s2(board, side.axis))
        return level_m_per_s2;
    const auto opposite = taken_[index(board)].find(stepOf(side.opposite()));
    return opposite == taken_[index(board)].end()
               ? std::nullopt
               : std::optional(opposite->second[side.axis] + side.sign * kStandardGravity_m_per_s2);
}

void SideGuide::learn(int step, const HealthReport& health) {
    for (int board = 0; board < boardCount(); ++board)
        if (isHeard(health, board) && isDone(step, board))
            taken_[index(board)][step] = accel_m_per_s2(health, board);
}

void SideGuide::unlearn(int step) {
    for (auto& taken : taken_)
        taken.erase(step);
}

}  // namespace noctule
