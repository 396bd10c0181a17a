// SPDX-License-Identifier: Apache-2.0
// Sum and spread of what came within the last so many samples.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>

namespace noctule {

class SlidingSum {
public:
    explicit SlidingSum(int64_t window_samples) : window_samples_(window_samples) {}

    /// Samples may come slightly out of order.
    void add(double sample, double value) {
        entries_.push_back({sample, value});
        sum_ += value;
        sum_of_squares_ += value * value;
    }
    /// Forgets what is older than the window that ends at `now_sample`.
    void advanceTo(int64_t now_sample) {
        while (!entries_.empty() &&
               entries_.front().sample < static_cast<double>(now_sample - window_samples_)) {
            sum_ -= entries_.front().value;
            sum_of_squares_ -= entries_.front().value * entries_.front().value;
            entries_.pop_front();
        }
        if (entries_.empty())
            sum_ = sum_of_squares_ = 0;  // no rounding stays behind
    }

    int64_t count() const { return static_cast<int64_t>(entries_.size()); }
    double sum() const { return sum_; }
    /// 0 when there is nothing to spread.
    double deviation() const {
        if (entries_.size() < 2)
            return 0;
        const auto n = static_cast<double>(entries_.size());
        return std::sqrt(std::max(0.0, sum_of_squares_ / n - sum_ * sum_ / n / n));
    }

private:
    struct Entry {
        double sample, value;
    };
    int64_t window_samples_;
    std::deque<Entry> entries_;
    double sum_ = 0, sum_of_squares_ = 0;
};

}  // namespace noctule
