// SPDX-License-Identifier: Apache-2.0
// What the meters of a board show, in dB below its full scale: its wire, and how fast it turns; and how a
// meter's needle moves. No clocks: times are given, in seconds.
#pragma once

#include <optional>

#include "core/inertial/reading.h"

namespace noctule {

/// What nothing at all is shown as.
inline constexpr double kSilence_db = -96;
/// Of a sample of the wire.
inline constexpr double kWireFullScale_counts = 32767;

/// 20 log10(amplitude / full_scale), never below kSilence_db.
double level_db(double amplitude, double full_scale);

/// How fast the board turns against the full scale of its gyroscope; absent where an axis is missing.
std::optional<double> motionLevel_db(const InertialReading& reading);

/// Rises at once, falls 20 dB/s; its peak stays for 1.5 s before it falls likewise.
class MeterNeedle {
public:
    static constexpr double kFall_db_per_s = 20, kHold_s = 1.5;

    void show(double level_db, double t_s);
    double level() const { return level_; }
    double peak() const { return peak_; }

private:
    double level_ = kSilence_db, peak_ = kSilence_db;
    double t_s_ = 0, peak_since_s_ = 0;
};

}  // namespace noctule
