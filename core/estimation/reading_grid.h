// SPDX-License-Identifier: Apache-2.0
// Readings of boards that sample at instants of their own, brought to common instants.
//
// A filter that predicts a reading some milliseconds off its own time holds accelerations constant on the
// way. A swinging leg changes them by several hundred m/s^3, which is a multiple of an accelerometer's noise
// within a millisecond and turns up as tilt. Between two readings of the same board the motion is smooth
// instead: a cubic through the last three and the next one is true to 1e-3 at 15 Hz (Lagrange's remainder),
// and its noise at low frequencies is that of the readings, which count with their own sigma.
#pragma once

#include <array>
#include <vector>

#include "core/estimation/measurement.h"

namespace noctule {

class ReadingGrid {
public:
    explicit ReadingGrid(size_t boards) : boards_(boards) {}

    /// In order of time per board; a reading that is late is dropped.
    void add(const InertialMeasurement& measurement);

    /// Every board at `time_s`, which does not go back from call to call, from readings up to
    /// `time_s` + kReach_s. An axis is missing where no reading is near enough on both sides; next to one at
    /// the end of its range it says the same (AxisReading::beyond) or is missing.
    std::vector<InertialMeasurement> at(double time_s);

    /// Who has given all readings up to this much after an instant may ask for it: a frame, and rounding.
    static constexpr double kReach_s = 1.001 / 140;

private:
    struct Sample {
        double time_s;
        AxisReading reading;
    };
    /// The newest readings of one axis, oldest first.
    using Track = std::vector<Sample>;
    struct Board {
        std::array<Track, 6> axes;  ///< gyroscope, accelerometer
    };
    static void addTo(Track& track, double time_s, const AxisReading& reading);
    static bool readAt(Track& track, double time_s, AxisReading& reading);

    std::vector<Board> boards_;
};

}  // namespace noctule
