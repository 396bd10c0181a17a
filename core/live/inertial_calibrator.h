// SPDX-License-Identifier: Apache-2.0
// Counts -> SI by the calibration in force, with the standard deviation each reading deserves.
#pragma once

#include <optional>
#include <vector>

#include "core/estimation/measurement.h"
#include "core/inertial/reading.h"
#include "core/suit/calibration.h"

namespace noctule {

struct SensorNoise {
    double gyro_rad_per_s = 0.002;  ///< Vlasic 2007, section 5.2
    double accel_m_per_s2 = 0.02;
};

class InertialCalibrator {
public:
    InertialCalibrator(const Suit& suit, const Calibration& calibration, double sample_rate_hz,
                       const SensorNoise& noise = {});

    /// Readings of one board in order of time. A triad that is not of counts holds SI
    /// values of another maker's sensor, without rounding and limits. An axis that is absent or clipped is
    /// left out; its sigma holds the sensor's noise and what is slow of the rounding of the step by which the
    /// stream reached the reading.
    InertialMeasurement convert(const InertialReading& reading);

    int64_t clippedReadings(int board) const { return boards_[static_cast<size_t>(board)].clipped; }

private:
    struct Axis {
        Vector3d sensitive_axis;        ///< board frame
        double zero_counts, per_count;  ///< value = (counts - zero) * per_count
        double noise;
        std::optional<double> last_counts;
        double last_rounding;  ///< counts
        bool counts;  ///< else SI already, as in takes imported from other sensors: neither clipped nor coded
        bool coded;   ///< by the stream of our boards, whose rate is 140 Hz
    };
    struct BoardAxes {
        Axis axes[6];
        int64_t clipped = 0;
    };
    std::vector<BoardAxes> boards_;
    double sample_rate_hz_;
};

}  // namespace noctule
