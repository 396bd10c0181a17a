// SPDX-License-Identifier: Apache-2.0
// At most four pulses in a millisecond: suits send one in eight, a flood of them would set the work.
#pragma once

#include <array>
#include <cstdint>

namespace noctule {

class PulseRate {
public:
    explicit PulseRate(int64_t sample_rate_hz) : window_(sample_rate_hz / 1000) { before_.fill(kLongAgo); }

    /// In the order of time.
    bool allows(int64_t sample) {
        int64_t& fourth = before_[next_];
        if (fourth != kLongAgo && sample - fourth < window_)
            return false;
        fourth = sample;
        next_ = (next_ + 1) % before_.size();
        return true;
    }

private:
    static constexpr int64_t kLongAgo = INT64_MIN;
    int64_t window_;
    std::array<int64_t, 4> before_;
    size_t next_ = 0;
};

}  // namespace noctule
