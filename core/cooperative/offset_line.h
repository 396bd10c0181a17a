// SPDX-License-Identifier: Apache-2.0
// The line that most offsets of a clock lie on. Crystals keep to it within microseconds for some minutes;
// echoes and pulses that were taken for their neighbours lie off it, together by milliseconds.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace noctule::cooperative {

struct ClockOffset {
    double time_s = 0, offset_s = 0;  ///< on one clock, as its user says
};

struct OffsetLine {
    double at_0_s = 0, slope = 0;  ///< over the same time
    double at(double time_s) const { return at_0_s + slope * time_s; }
};

/// Least squares; none where all lie at one instant.
std::optional<OffsetLine> lineThrough(const std::vector<ClockOffset>& offsets);

/// Through all that lie within `outlier_s` of the line through most of them. No steeper than two crystals
/// allow, 60 parts per million; where no two offsets agree, level through the first. Needs one.
OffsetLine lineThroughMost(std::vector<ClockOffset> offsets, double outlier_s);

}  // namespace noctule::cooperative
