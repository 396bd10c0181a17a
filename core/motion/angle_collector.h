// SPDX-License-Identifier: Apache-2.0
// Collects an angle over time: moments, the largest, the slope of the least-squares line, and quantiles by a
// histogram, so that an hour takes no more memory than a second.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/motion/comparison.h"

namespace noctule {

class AngleCollector {
public:
    /// Times in seconds from near zero, so that their squares keep their digits.
    void add(double time_s, double angle_rad) {
        ++count_;
        sum_ += angle_rad, squares_ += angle_rad * angle_rad;
        max_ = std::max(max_, angle_rad);
        ++histogram_[static_cast<size_t>(std::clamp(degrees(std::abs(angle_rad)) * kBinsPerDegree, 0.0,
                                                    kLargest_deg * kBinsPerDegree - 1))];
        time_ += time_s, time_squares_ += time_s * time_s, time_angle_ += time_s * angle_rad;
    }

    AngleStatistics statistics() const {
        if (count_ == 0)
            return {};
        const double n = static_cast<double>(count_);
        const double mean = sum_ / n;
        const double variance = std::max(0.0, squares_ / n - mean * mean);
        const double time_variance = time_squares_ / n - (time_ / n) * (time_ / n);
        const double slope = time_variance > 1e-12 ? (time_angle_ / n - mean * time_ / n) / time_variance : 0;
        return {degrees(mean),     degrees(std::sqrt(variance)), degrees(std::sqrt(squares_ / n)),
                degrees(max_),     degrees(slope) * 60,          quantile_deg(0.5),
                quantile_deg(0.95)};
    }

private:
    static constexpr double kBinsPerDegree = 100, kLargest_deg = 180;

    double quantile_deg(double share) const {
        const double wanted = share * static_cast<double>(count_);
        double below = 0;
        for (size_t bin = 0; bin < histogram_.size(); ++bin) {
            below += static_cast<double>(histogram_[bin]);
            if (below >= wanted)
                return (static_cast<double>(bin) + 0.5) / kBinsPerDegree;
        }
        return kLargest_deg;
    }

    std::vector<uint32_t> histogram_ =
        std::vector<uint32_t>(static_cast<size_t>(kLargest_deg * kBinsPerDegree));
    int64_t count_ = 0;
    double sum_ = 0, squares_ = 0, max_ = 0, time_ = 0, time_squares_ = 0, time_angle_ = 0;
};

}  // namespace noctule
