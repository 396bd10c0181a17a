// SPDX-License-Identifier: Apache-2.0
// How well two sensors fit on neighbouring segments, however each is mounted: some point must be fixed in
// both, so that both see its acceleration with one magnitude. Source: Seel, Raisch, Schauer, "IMU-based joint
// angle measurement for gait analysis", Sensors 14, 2014, section 3.2.
#pragma once

#include <vector>

#include "core/orientation/imu_samples.h"

namespace noctule::assignment {

/// Smoothed and thinned readings of one sensor, all sensors at the same instants.
struct SmoothMotion {
    std::vector<Vector3d> rate_rad_per_s, accel_m_per_s2;
    std::vector<Matrix3d> lever;  ///< takes a lever arm to the acceleration that turning gives its end
};
SmoothMotion smoothMotion(const ImuSamples& samples);

struct JointEvidence {
    double misfit_m_per_s2 = 0;  ///< mean difference of the two magnitudes
    Vector3d lever_first_m = Vector3d::Zero(), lever_second_m = Vector3d::Zero();  ///< sensor minus joint
};
JointEvidence jointEvidence(const SmoothMotion& first, const SmoothMotion& second);

/// Mean over windows of a raised cosine of two periods of `cutoff_hz`; the ends are held.
std::vector<Vector3d> lowPassed(const std::vector<Vector3d>& values, double rate_hz, double cutoff_hz);
std::vector<double> lowPassed(const std::vector<double>& values, double rate_hz, double cutoff_hz);

}  // namespace noctule::assignment
