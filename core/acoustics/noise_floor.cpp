// SPDX-License-Identifier: Apache-2.0
#include "core/acoustics/noise_floor.h"

#include <algorithm>
#include <array>

namespace noctule {

void NoiseFloor::push(double window_noise_power) {
    recent_.push_back(window_noise_power);
    if (recent_.size() > kWindows)
        recent_.pop_front();
    std::array<double, kWindows> sorted;
    const auto end = std::copy(recent_.begin(), recent_.end(), sorted.begin());
    const auto middle = sorted.begin() + (recent_.size() - 1) / 2;
    std::nth_element(sorted.begin(), middle, end);
    power_ = *middle;
}

}  // namespace noctule
