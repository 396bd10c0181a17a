// SPDX-License-Identifier: Apache-2.0
// The largest of what came within the last so many samples.
#pragma once

#include <cstdint>
#include <deque>

namespace noctule {

class SlidingMaximum {
public:
    explicit SlidingMaximum(int64_t window_samples) : window_samples_(window_samples) {}

    /// In order of samples.
    void add(double sample, double value) {
        while (!falling_.empty() && falling_.back().value <= value)
            falling_.pop_back();  // will never be the largest again
        falling_.push_back({sample, value});
    }
    /// Forgets what is older than the window that ends at `now_sample`.
    void advanceTo(int64_t now_sample) {
        while (!falling_.empty() &&
               falling_.front().sample < static_cast<double>(now_sample - window_samples_))
            falling_.pop_front();
    }
    /// 0 when nothing is there.
    double value() const { return falling_.empty() ? 0 : falling_.front().value; }

private:
    struct Entry {
        double sample, value;
    };
    int64_t window_samples_;
    std::deque<Entry> falling_;
};

}  // namespace noctule
