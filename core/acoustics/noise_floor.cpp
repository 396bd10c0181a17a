// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/noise_floor.h"

#include <algorithm>

namespace noctule {

void NoiseFloor::push(double window_noise_power) {
    recent_[next_] = window_noise_power;
    next_ = (next_ + 1) % kWindows;
    count_ = std::min(count_ + 1, kWindows);
    std::array<double, kWindows> sorted = recent_;
    const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(count_);
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>((count_ - 1) / 2);
    std::nth_element(sorted.begin(), middle, end);
    power_ = *middle;
}

}  // namespace noctule
