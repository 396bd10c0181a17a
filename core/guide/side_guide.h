// SPDX-License-Identifier: Apache-2.0
// Guide of the accelerometers' calibration: six level sides (kBoardSides), in any order (Vlasic 2007, section
// 4.3). The side is what all boards say together, for a board that was never calibrated may lie 25 degrees
// off by its own zero. Whether a board sits askew is told by calibrated boards at once, by others from the
// second side on: what read 0 along an axis that was level then reads it again.
#pragma once

#include <map>

#include "core/calibration/board_side.h"
#include "core/guide/guide.h"

namespace noctule {

class SideGuide : public Guide {
public:
    /// A board that was pressed into its slot is within a tenth of it. One that was never calibrated reads
    /// its own axes' misalignment (0.6 degrees each) twice, once with either sign of gravity.
    static constexpr double kAskew_rad = radians(1.5), kUncalibratedAskew_rad = radians(5.5);

    SideGuide(const Suit& suit, const Calibration& calibration, int sample_rate_hz);

protected:
    Hindrance see(const HealthReport& health, Guidance& guidance) override;
    void learn(int step, const HealthReport& health) override;
    void unlearn(int step) override;

private:
    bool isCalibrated(int board) const { return wasCalibrated(board, "accelerometers"); }
    Vector3d accel_m_per_s2(const HealthReport& health, int board) const;
    std::optional<double> askew_rad(int board, const Vector3d& accel_m_per_s2, const BoardSide& side) const;

    std::optional<double> levelReading_m_per_s2(int board, int axis) const;
    std::optional<double> zeroAlong_m_per_s2(int board, const BoardSide& side) const;

    std::vector<std::map<int, Vector3d>> taken_;  ///< per board and side, m/s^2 with the calibration so far
};

/// Its place in kBoardSides.
int stepOf(const BoardSide& side);

/// The side that points up by all readings together; absent without one that stands out.
std::optional<BoardSide> sideUp(const std::vector<Vector3d>& accel_m_per_s2);

}  // namespace noctule
