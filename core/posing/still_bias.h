// SPDX-License-Identifier: Apache-2.0
// The bias of a gyroscope from seconds in which its sensor rests. Without a magnetometer nothing else tells
// the bias about the vertical (rest detection as in Laidig, Seel, "VQF", Information Fusion 91, 2023).
#pragma once

#include <optional>

#include "core/orientation/orientation_filter.h"

namespace noctule::posing {

/// None when the sensor never rests.
std::optional<Vector3d> stillBias_rad_per_s(const ImuSamples& samples);

/// Orientation of a sensor that a person wears, with gaps up to 0.1 s bridged and
/// the bias at rest taken off the readings first.
Result<OrientationRun> wornOrientation(ImuSamples& samples, bool smooth, const JobContext& job);

}  // namespace noctule::posing
