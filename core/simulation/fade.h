// SPDX-License-Identifier: Apache-2.0
// The way from one movement to another without a jump in position, velocity or acceleration.
#pragma once

#include <type_traits>

#include "core/simulation/jet.h"

namespace noctule::simulation {

/// 0 to 1 over one fade, constant before and after; first and second derivative vanish at both ends.
template <class T>
T fadeWeight(double t_s, double fade_s) {
    const double x = t_s / fade_s;
    if (x <= 0)
        return T(0.0);
    if (x >= 1)
        return T(1.0);
    const double value = x * x * x * (10 + x * (-15 + 6 * x));
    if constexpr (std::is_same_v<T, double>)
        return value;
    else
        return Jet(value, 30 * x * x * (1 - x) * (1 - x) / fade_s,
                   60 * x * (1 - x) * (1 - 2 * x) / (fade_s * fade_s));
}

}  // namespace noctule::simulation
