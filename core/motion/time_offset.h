// SPDX-License-Identifier: Apache-2.0
// When two systems record one motion on clocks of their own: the shift between the clocks, found from how
// fast the joints turn. Angular speed needs neither the same skeleton nor the same axes.
#pragma once

#include <cstdint>
#include <optional>

#include "core/motion/timed_poses.h"

namespace noctule {

struct TimeOffset {
    int64_t add_to_reference_ns = 0;  ///< reference time + this = estimate's time
    double correlation = 0;           ///< of the two speed curves at that shift, -1..1
    bool trusted() const { return correlation >= kLeastCorrelation; }
    static constexpr double kLeastCorrelation = 0.5;
};

/// The shift within +-`max_shift_s` at which the summed angular speeds of the common joints correlate best:
/// normalised cross-correlation on a 10 ms grid, then a parabola through three values (well under 1 ms on
/// human motion). At least two seconds must overlap. Nothing when the motions share no moving joint, are
/// shorter than that or do not move.
std::optional<TimeOffset> findTimeOffset(const TimedMotion& estimate, const TimedMotion& reference,
                                         double max_shift_s = 30);

}  // namespace noctule
