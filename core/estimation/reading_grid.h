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
#include "core/inertial/reading.h"

namespace noctule {

class ReadingGrid {
public:
    /// Boards of 140 readings a second on the suit's clock.
    explicit ReadingGrid(size_t boards)
        : ReadingGrid(std::vector<double>(boards, kInertialFramesPerSecond)) {}
    /// `rates_hz`: nominal, per board. Readings of another rate than 140 need not be regular.
    explicit ReadingGrid(const std::vector<double>& rates_hz);

    /// In order of time per board; a reading that is late is dropped.
    void add(const InertialMeasurement& measurement);

    /// Every board at `time_s`, which does not go back from call to call, from readings up to
    /// `time_s` + reach_s(). An axis is missing where no reading is near enough on both sides; next to one at
    /// the end of its range it says the same (AxisReading::beyond) or is missing.
    std::vector<InertialMeasurement> at(double time_s);

    /// at(t) needs every reading up to t + reach_s(): of a board on the suit's clock one interval plus
    /// rounding, of another the longest gap.
    double reach_s() const { return reach_s_; }

private:
    struct Sample {
        double time_s;
        AxisReading reading;
    };
    /// The newest readings of one axis, oldest first.
    using Track = std::vector<Sample>;
    struct Board {
        std::array<Track, 6> axes;  ///< gyroscope, accelerometer
        double reach_s, longest_gap_s;
        /// A board that reads less often is asked more often than it reads: each answer then counts with more
        /// noise, so that all of them tell as much as the readings do.
        double noise_factor;
    };
    static void addTo(Track& track, double time_s, const AxisReading& reading);
    static bool readAt(const Board& board, Track& track, double time_s, AxisReading& reading);

    std::vector<Board> boards_;
    double reach_s_;
};

}  // namespace noctule
