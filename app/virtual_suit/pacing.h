// SPDX-License-Identifier: Apache-2.0
// Which samples a converter has made by now. Nanoseconds of any clock that does not go back.
#pragma once

#include <cmath>
#include <cstdint>

namespace noctule::virtual_suit {

class Pacer {
public:
    /// `speed`: seconds of the suit in one second of the clock.
    Pacer(int sample_rate_hz, double speed) : samples_per_ns_(sample_rate_hz * speed * 1e-9) {}

    /// The first sample is being converted from now on.
    void start(int64_t now_ns) {
        start_ns_ = now_ns;
        lost_ns_ = 0;
    }
    /// Samples whose conversion is over.
    int64_t due(int64_t now_ns) const {
        return static_cast<int64_t>(std::floor(static_cast<double>(now_ns - start_ns_) * samples_per_ns_));
    }
    /// Only `made` samples are there: what is missing beyond `patience_ns` is not caught up, the suit's clock
    /// has stood still meanwhile.
    void holdTo(int64_t made, int64_t now_ns, int64_t patience_ns) {
        const auto behind_ns =
            static_cast<int64_t>(static_cast<double>(due(now_ns) - made) / samples_per_ns_);
        if (behind_ns <= patience_ns)
            return;
        start_ns_ += behind_ns - patience_ns;
        lost_ns_ += behind_ns - patience_ns;
    }
    /// How long the suit's clock has stood still since start().
    int64_t lost_ns() const { return lost_ns_; }

private:
    double samples_per_ns_;
    int64_t start_ns_ = 0, lost_ns_ = 0;
};

}  // namespace noctule::virtual_suit
