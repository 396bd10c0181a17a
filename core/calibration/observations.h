// SPDX-License-Identifier: Apache-2.0
// What solvers of calibration read: raw readings and flight times of one take, before any calibration. Times
// in seconds since the take's first sample.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/body/actor.h"
#include "core/suit/calibration.h"
#include "core/suit/suit.h"

namespace noctule {

/// A frame that arrived whole.
struct CountReading {
    double time_s = 0;
    Vector3d gyro_counts = Vector3d::Zero(), accel_counts = Vector3d::Zero();  ///< 0..4095
    bool clipped = false;  ///< an axis is at the end of its range: known to lie beyond
};

/// A pulse that a board heard.
struct FlightTime {
    double time_s = 0;  ///< of the pulse's emission
    int source = 0, board = 0;
    /// As the detector reports it: distance / c + the source's offset + the microphone's delay.
    double flight_s = 0;
    double confidence = 1;   ///< w_s * w_t, which need no calibration
    double c_m_per_s = 340;  ///< of the take's air at that time
};

/// Between two markers of a take, or to its end.
struct Stretch {
    double begin_s = 0, end_s = 0;
    std::string label;

    bool contains(double time_s) const { return time_s >= begin_s && time_s <= end_s; }
};

struct Observations {
    std::string take;        ///< file name, for messages
    std::string box_serial;  ///< empty: not stated
    std::string kind;        ///< motion, jig, level, turntable
    double duration_s = 0;
    std::optional<double> began_s;  ///< UTC since 1970, to the second; absent: unknown
    double g_m_per_s2 = kStandardGravity_m_per_s2;
    double turntable_rpm = 0;  ///< nominal; 0: not stated
    Suit suit;
    Calibration calibration;  ///< in force in the take; nominal where it has none
    Actor actor;
    std::string detector = "inflection";

    std::vector<std::vector<CountReading>> boards;  ///< in order of time, about 140 a second
    std::vector<FlightTime> flights;                ///< in order of emission
    std::vector<Stretch> placements;                ///< of a jig, labelled
    std::optional<Stretch> rest;                    ///< the first rest pose that is marked
};

}  // namespace noctule
