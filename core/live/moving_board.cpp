// SPDX-License-Identifier: Apache-2.0
#include "core/live/moving_board.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/conventions.h"
#include "core/suit/calibration.h"

namespace noctule {
namespace {

constexpr int kLeastReadings = 10;

}  // namespace

MovingBoard::MovingBoard(const Suit& suit, int sample_rate_hz, const MovingBoardSettings& settings)
    : window_samples_(settings.window_s * sample_rate_hz), settings_(settings) {
    for (const Board& board : suit.boards)
        windows_.push_back({-1, 0, board.gyro_full_scale_rad_per_s, 0});
}

void MovingBoard::add(const InertialReading& reading) {
    Window& window = windows_.at(static_cast<size_t>(reading.board));
    const auto& counts = reading.counts;
    if (reading.sample <= window.at_sample || !counts[0] || !counts[1] || !counts[2])
        return;
    const AxisCalibration nominal = AxisCalibration::nominal(window.full_scale_rad_per_s);
    const double turning = nominal.apply(Vector3d(*counts[0], *counts[1], *counts[2])).norm();
    const double passed = window.at_sample < 0 ? 0 : reading.sample - window.at_sample;
    const double kept = std::exp(-passed / window_samples_);
    window.turning_rad_per_s = kept * window.turning_rad_per_s + (1 - kept) * turning;
    window.at_sample = reading.sample;
    ++window.count;
}

std::optional<int> MovingBoard::found() const {
    int best = -1;
    double most = 0, second = 0;
    for (size_t i = 0; i < windows_.size(); ++i) {
        const double turning = windows_[i].count < kLeastReadings ? 0 : windows_[i].turning_rad_per_s;
        if (turning > most) {
            second = std::exchange(most, turning);
            best = static_cast<int>(i);
        } else {
            second = std::max(second, turning);
        }
    }
    const bool sure = best >= 0 && most >= settings_.least_rad_per_s && most >= settings_.least_lead * second;
    return sure ? std::optional(best) : std::nullopt;
}

}  // namespace noctule
