// SPDX-License-Identifier: Apache-2.0
// One board's readings in SI units as functions of time, straight between readings, and their integrals on
// the way of the board's own rotation. Board frame; seconds of the take.
#pragma once

#include <vector>

#include "core/calibration/observations.h"

namespace noctule {

class BoardSignal {
public:
    BoardSignal(const std::vector<CountReading>& readings, const BoardCalibration& calibration);

    /// Readings without gaps, none at the end of its range.
    bool covers(double begin_s, double end_s) const;
    /// q_begin_end: the rotation between two times; covered ones.
    Quaterniond turn(double begin_s, double end_s) const;
    /// Of the specific force in the frame at `middle_s`, weighted by a triangle that falls to 0 within
    /// +-half_s.
    Vector3d meanForce(double middle_s, double half_s) const;

private:
    struct Sample {
        double time_s = 0;
        Vector3d gyro_rad_per_s = Vector3d::Zero(), accel_m_per_s2 = Vector3d::Zero();
        bool clipped = false;
    };
    Sample at(double time_s) const;
    size_t firstAfter(double time_s) const;
    /// Times of readings between the two, with both ends.
    std::vector<Sample> between(double begin_s, double end_s) const;

    std::vector<Sample> samples_;
};

}  // namespace noctule
