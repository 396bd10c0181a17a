// SPDX-License-Identifier: Apache-2.0
// Which sensor sits on which segment, from walking or free movement, however each is mounted and without
// magnetometers. README of core/import explains the steps; sensors must share one clock and rate.
#pragma once

#include <string>
#include <vector>

#include "core/job/job.h"
#include "core/orientation/imu_samples.h"

namespace noctule::assignment {

struct AssignedSensor {
    std::string segment;  ///< canonical joint
    /// 0..1; how much worse the next best place of this sensor fits, and how clearly its side shows. No
    /// probability: above 0.5 has been right in all motions tried.
    double confidence = 0;
};

struct Assignment {
    std::vector<AssignedSensor> sensors;  ///< in the order given
    double legs_side = 0;  ///< -1..1: correlation by which the legs' sides were told; near 0: guessed
    double arms_side = 0;  ///< the same of the arms: share of the shoulders' distance that points sideways
    std::vector<std::string> warnings;
};

/// Numbers of sensors that a body is known for: 7 (hips and legs), 8 (and the chest), 16 (whole body).
std::vector<size_t> knownCounts();

/// kUnusable: another number of sensors, different rates or lengths, too short or too still a recording.
Result<Assignment> assignSegments(const std::vector<ImuSamples>& sensors, const JobContext& job);

}  // namespace noctule::assignment
