// SPDX-License-Identifier: Apache-2.0
// The mean of many readings that were rounded to whole counts while next to nothing moved. With noise of a
// quarter of a count (the gyroscope's 0.002 rad/s is 0.23) rounding shifts the plain mean by up to
// exp(-2 pi^2 sigma^2) / pi = 0.1 counts, 0.05 deg/s, however many readings there are (Widrow and Kollar
// 2008, "Quantization noise", section 5). So the mean is taken from the probability of each whole count under
// Gaussian noise, whose width is one for all stretches of an axis.
#pragma once

#include <span>
#include <vector>

#include "core/calibration/observations.h"

namespace noctule {

struct CountMean {
    Vector3d counts = Vector3d::Zero();
    Vector3d sigma = Vector3d::Zero();  ///< of the mean, counts
};

/// Of each stretch. Readings that are not whole counts (other makers' sensors) have their plain mean. No
/// stretch may be empty.
std::vector<CountMean> countMeans(const std::vector<std::span<const CountReading>>& stretches,
                                  Vector3d CountReading::*sensor);

}  // namespace noctule
