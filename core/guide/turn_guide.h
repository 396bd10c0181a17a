// SPDX-License-Identifier: Apache-2.0
// Guide of the gyroscopes' calibration: even turns about each axis, both ways (kBoardSides: the axis about
// which the boards turn right-handed), at one of a turntable's speeds (Vlasic 2007, section 4.3). While the
// table stands it learns the gyroscopes' zeros, which would be a tenth of its speed.
#pragma once

#include "core/calibration/board_side.h"
#include "core/guide/guide.h"

namespace noctule {

class TurnGuide : public Guide {
public:
    /// `rpm` 0: any of the usual speeds.
    TurnGuide(const Suit& suit, const Calibration& calibration, int sample_rate_hz, double rpm);

    /// A table that turns with the clock, as seen from above, wants the opposite sides.
    int sideUpIn(int step) const override;
    /// As it turned last.
    bool turnsCounterClockwise() const { return counter_clockwise_; }

protected:
    Hindrance see(const HealthReport& health, Guidance& guidance) override;

private:
    Vector3d rate_rad_per_s(const HealthReport& health, int board) const;
    Hindrance judgeSpeed(double turn_rad_per_s, const std::vector<int>& heard, Guidance& guidance) const;
    void rest(const HealthReport& health, const std::vector<int>& heard);

    double rpm_;
    bool counter_clockwise_ = true;
    std::vector<std::optional<Vector3d>> zeros_rad_per_s_;
};

}  // namespace noctule
