// SPDX-License-Identifier: Apache-2.0
// How late poses come: from the arrival of the block that holds a frame's last bit to the pose (design,
// section 8). Durations are given; nothing here reads a clock. Memory does not grow: bins of 1 %.
#pragma once

#include <array>
#include <cstdint>

namespace noctule {

class LatencyHistogram {
public:
    void add(int64_t latency_ns);

    int64_t count() const { return count_; }
    int64_t worst_ns() const { return worst_ns_; }
    /// 0.5: the median; within 1 %. 0 when nothing was added.
    double quantile_s(double share) const;

private:
    static constexpr int64_t kLowest_ns = 1000;
    static constexpr size_t kBins = 2000;  ///< 1 us to 400 s
    std::array<int64_t, kBins> bins_{};
    int64_t count_ = 0, worst_ns_ = 0;
};

}  // namespace noctule
