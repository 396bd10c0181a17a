// SPDX-License-Identifier: Apache-2.0
// Health of a suit on a rig, made up: where each board's axes point, how it turns, what its zeros are.
#pragma once

#include <random>

#include "core/calibration/board_side.h"
#include "core/live/health.h"
#include "core/suit/calibration.h"

namespace noctule::test {

inline constexpr int kRigRate_hz = 150000;

inline Suit rigSuit(int boards) {
    Suit suit;
    for (int board = 0; board < boards; ++board) {
        Board one;
        one.id = "b" + std::to_string(board);
        suit.boards.push_back(one);
    }
    return suit;
}

/// Boards on a plate; zeros as those of boards that were never calibrated (40 and 60 counts).
class RigHealth {
public:
    explicit RigHealth(const Suit& suit, double zero_share = 1) : suit_(suit) {
        std::mt19937 random(5);
        std::normal_distribution<double> gyro(0, 40 * zero_share), accel(0, 60 * zero_share);
        for (size_t board = 0; board < suit.boards.size(); ++board)
            zeros_.push_back(
                {{gyro(random), gyro(random), gyro(random)}, {accel(random), accel(random), accel(random)}});
        report_.boards.resize(suit.boards.size());
        lay({2, +1});
    }
    void lay(BoardSide side) {
        for (size_t board = 0; board < zeros_.size(); ++board)
            set(board, kStandardGravity_m_per_s2 * side.up(), Vector3d::Zero());
    }
    void spin(BoardSide up, BoardSide about, double rate_rad_per_s) {
        for (size_t board = 0; board < zeros_.size(); ++board)
            set(board, kStandardGravity_m_per_s2 * up.up(), rate_rad_per_s * about.up());
    }
    void set(size_t board, const Vector3d& accel_m_per_s2, const Vector3d& rate_rad_per_s) {
        BoardHealth& health = report_.boards[board];
        health.silent = false;
        health.still = true;
        const Board& described = suit_.boards[board];
        health.means = BoardHealth::Means{Vector3d::Constant(2048) + zeros_[board].first +
                                              rate_rad_per_s * 2048 / described.gyro_full_scale_rad_per_s,
                                          Vector3d::Constant(2048) + zeros_[board].second +
                                              accel_m_per_s2 * 2048 / described.accel_full_scale_m_per_s2,
                                          0.002, 0.03};
    }
    BoardHealth& board(size_t board) { return report_.boards[board]; }
    HealthReport& report() { return report_; }
    /// The report that much later.
    const HealthReport& after(double seconds) {
        report_.sample += static_cast<int64_t>(seconds * kRigRate_hz);
        return report_;
    }

private:
    Suit suit_;
    std::vector<std::pair<Vector3d, Vector3d>> zeros_;
    HealthReport report_;
};

}  // namespace noctule::test
