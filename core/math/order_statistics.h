// SPDX-License-Identifier: Apache-2.0
// Location and spread that a minority of wild values cannot move.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace noctule {

/// The middle one of the values, the upper one of two; 0 of nothing.
inline double middleValue(std::vector<double> values) {
    if (values.empty())
        return 0;
    const auto middle = values.begin() + std::ssize(values) / 2;
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// The mean of the two middle ones of an even number; 0 of nothing.
inline double medianOf(std::vector<double> values) {
    if (values.empty())
        return 0;
    const auto middle = values.begin() + std::ssize(values) / 2;
    std::ranges::nth_element(values, middle);
    return values.size() % 2 ? *middle : (*middle + *std::max_element(values.begin(), middle)) / 2;
}

/// The standard deviation of normal values, from the median of their absolute distances.
inline double spreadAbout(double center, std::vector<double> values) {
    for (double& value : values)
        value = std::abs(value - center);
    return 1.4826 * medianOf(std::move(values));
}

}  // namespace noctule
