// SPDX-License-Identifier: Apache-2.0
#include "core/guide/turn_guide.h"

#include <algorithm>
#include <cmath>

#include "core/calibration/gyroscope/gyroscope_calibration.h"
#include "core/calibration/gyroscope/gyroscope_turns.h"
#include "core/guide/side_guide.h"
#include "core/math/order_statistics.h"

namespace noctule {
namespace {

constexpr double kSlowest_rad_per_s = radians(30);
/// Of one gyroscope's slope before it is calibrated; the median of some is better.
constexpr double kOffSpeed = 0.03;
/// The same before the table has been seen to stand: zeros are a tenth of its speed.
constexpr double kOffSpeedUnrested = 0.15;

}  // namespace

int TurnGuide::sideUpIn(int step) const {
    const BoardSide about = kBoardSides[index(step)];
    return counter_clockwise_ ? step : stepOf(about.opposite());
}

TurnGuide::TurnGuide(const Suit& suit, const Calibration& calibration, int sample_rate_hz, double rpm)
    : Guide(suit, calibration, sample_rate_hz, static_cast<int>(kBoardSides.size())),
      rpm_(rpm),
      zeros_rad_per_s_(suit.boards.size()) {}

Vector3d TurnGuide::rate_rad_per_s(const HealthReport& health, int board) const {
    const Vector3d rate = calibrationOf(board).gyro.apply(health.boards[index(board)].means->gyro_counts);
    return rate - zeros_rad_per_s_[index(board)].value_or(Vector3d::Zero());
}

void TurnGuide::rest(const HealthReport& health, const std::vector<int>& heard) {
    for (const int board : heard)
        if (health.boards[index(board)].still)
            zeros_rad_per_s_[index(board)] =
                calibrationOf(board).gyro.apply(health.boards[index(board)].means->gyro_counts);
}

Hindrance TurnGuide::judgeSpeed(double turn_rad_per_s, const std::vector<int>& heard,
                                Guidance& guidance) const {
    const double rpm = turn_rad_per_s / turningRate_rad_per_s(1);
    guidance.rpm = counter_clockwise_ ? rpm : -rpm;
    guidance.value = rpm;
    for (const int board : heard)
        if (turn_rad_per_s >
            GyroscopeLimits::kFastest * suit().boards[index(board)].gyro_full_scale_rad_per_s) {
            guidance.board = board;
            return Hindrance::kTooFast;
        }
    const double wanted = rpm_ > 0 ? rpm_ : nearestTableSpeed_rpm(rpm);
    const bool rested =
        std::ranges::all_of(heard, [this](int board) { return zeros_rad_per_s_[index(board)].has_value(); });
    const double limit = rested ? kOffSpeed : kOffSpeedUnrested;
    return std::abs(rpm / wanted - 1) > limit ? Hindrance::kOffSpeed : Hindrance::kNone;
}

Hindrance TurnGuide::see(const HealthReport& health, Guidance& guidance) {
    const std::vector<int> heard = heardBoards(health, guidance);
    std::vector<double> speeds;
    std::vector<Vector3d> accels;
    Vector3d sum = Vector3d::Zero();
    int even = 0;
    for (const int board : heard) {
        even += health.boards[index(board)].still;
        const Vector3d rate = rate_rad_per_s(health, board);
        sum += rate;
        speeds.push_back(rate.norm());
        accels.push_back(calibrationOf(board).accel.apply(health.boards[index(board)].means->accel_counts));
    }
    if (heard.empty())
        return Hindrance::kNoReadings;
    const std::optional<BoardSide> up = sideUp(accels);
    const double turn_rad_per_s = medianOf(speeds);
    const Vector3d mean = sum / static_cast<double>(heard.size());
    // Boards that turn each about another axis are carried about, not turned on a table.
    if (turn_rad_per_s < kSlowest_rad_per_s || mean.norm() < kSlowest_rad_per_s) {
        guidance.rpm = 0;
        if (even == static_cast<int>(heard.size()) && mean.norm() < kSlowest_rad_per_s)
            rest(health, heard);
        if (up)
            guidance.step = stepOf(counter_clockwise_ ? *up : up->opposite());
        return Hindrance::kNotTurning;
    }
    const BoardSide about = BoardSide::nearest(mean);
    if (up)
        counter_clockwise_ = about == *up;
    guidance.step = stepOf(about);
    if (even * 2 < static_cast<int>(heard.size())) {
        guidance.rpm = (counter_clockwise_ ? 1 : -1) * turn_rad_per_s / turningRate_rad_per_s(1);
        guidance.value = std::abs(*guidance.rpm);
        return Hindrance::kUnevenTurn;
    }
    return judgeSpeed(turn_rad_per_s, heard, guidance);
}

}  // namespace noctule
