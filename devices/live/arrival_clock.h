// SPDX-License-Identifier: Apache-2.0
// When a box took its sample 0, guessed from when its first blocks came. No block comes before its last
// sample was taken, and some come at once: the least delay counts. What all blocks have in common stays in
// the guess; it is some milliseconds, and much the same for boxes of one kind.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "devices/live/live_item.h"

namespace noctule {

class ArrivalClock {
public:
    /// Of sound that is looked at. Longer: less delay, but the drift of the box's clock counts (20 ppm).
    static constexpr double kLooksAt_s = 2;

    explicit ArrivalClock(int sample_rate_hz) : sample_rate_hz_(sample_rate_hz) {}

    void note(const ArrivedBlock& block) {
        const double end_s = static_cast<double>(block.endSample()) / sample_rate_hz_;
        if (end_s > kLooksAt_s || block.arrived_ns == 0)
            return;
        const int64_t start_ns = block.arrived_ns - std::llround(end_s * 1e9);
        start_ns_ = std::min(start_ns_.value_or(start_ns), start_ns);
    }
    /// Nanoseconds of std::chrono::steady_clock; nothing before the first block.
    std::optional<int64_t> start_ns() const { return start_ns_; }

private:
    int sample_rate_hz_;
    std::optional<int64_t> start_ns_;
};

}  // namespace noctule
