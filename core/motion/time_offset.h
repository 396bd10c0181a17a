// SPDX-License-Identifier: Apache-2.0
// Two systems record one motion on clocks of their own: finds the shift between the clocks. It compares, for
// each joint apart, how fast it turns, distances between hands, feet and head, and how the root turns about
// the vertical. None of these depends on joint axes or rest poses, and left and right stay apart, so that a
// gait's half step does not pass for a whole one.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/timed_poses.h"

namespace noctule {

struct TimeOffset {
    /// Another shift that fits about as well.
    struct Rival {
        int64_t add_to_reference_ns = 0;
        double correlation = 0;
    };

    int64_t add_to_reference_ns = 0;  ///< reference time + this = estimate's time
    double correlation = 0;           ///< mean over the curves at that shift, -1..1
    int64_t sigma_ns = 0;             ///< standard deviation of the shift; 0 when it was given
    std::vector<Rival> rivals;        ///< the motion repeats itself, and the shift cannot be told; by time

    bool trusted() const {
        return correlation >= kLeastCorrelation && rivals.empty() && sigma_ns <= kLargestSigma_ns;
    }
    static constexpr double kLeastCorrelation = 0.5;
    static constexpr int64_t kLargestSigma_ns = 20'000'000;
};

/// The shift within +-`max_shift_s` at which the curves of the common joints correlate best: a search on a
/// 50 ms grid, then 10 ms, then a parabola. At least two seconds must overlap. Nothing when the motions share
/// no moving joint, are shorter than that or do not move.
std::optional<TimeOffset> findTimeOffset(const TimedMotion& estimate, const TimedMotion& reference,
                                         double max_shift_s = 120);

/// Why an offset is not trusted, as the end of a sentence that begins with "the motion": "repeats itself:
/// 4110 ms fits about as well as 3000 ms".
std::string distrust(const TimeOffset& offset);

}  // namespace noctule
