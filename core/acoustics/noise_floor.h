// SPDX-License-Identifier: Apache-2.0
// Ambient noise of one board, running and causal: the median of the last 16 windows' own estimates (two
// rounds of eight sources), which neither an impulse nor one close source's long ringing moves.
#pragma once

#include <array>
#include <cstddef>

namespace noctule {

class NoiseFloor {
public:
    void push(double window_noise_power);
    double power() const { return power_; }  ///< counts^2

private:
    static constexpr size_t kWindows = 16;
    std::array<double, kWindows> recent_{};  // a ring
    size_t count_ = 0, next_ = 0;
    double power_ = 0;
};

}  // namespace noctule
