// SPDX-License-Identifier: Apache-2.0
// The complementary filters of Miller 2004, section 3: gyroscopes are integrated, gravity and the Earth's
// field correct the drift. They are baselines; orientation_filter.h is ours. World frame: field_reference.h.
#pragma once

#include "core/orientation/field_reference.h"

namespace noctule {

struct MillerSettings {
    /// The paper's alpha, equation 13, 1/s. Range 0 to 10. Larger: drift is corrected faster, accelerations
    /// and disturbed fields turn the estimate more. Default: best of thirty trials of BROAD.
    double alpha_per_s = 0.04;
    /// Level the sensed field by the sensed gravity, as m_ref was levelled. The paper compares a levelled
    /// reference with an unlevelled reading; this option mends it (best alpha then 0.1).
    bool level_reading = false;
};

/// Miller 2004, equations 1 to 14. Mended, as the text can only be meant: the quaternion product (5) is
/// Hamilton's, rates are radians, the angle found in a plane turns about the axis across it, and it has a
/// sign (the law of cosines loses it).
std::vector<Quaterniond> millerOrientation(const ImuSamples& samples, const MillerSettings& settings = {});

struct BachmannSettings {
    double gain_per_s = 0.1;  ///< share of the Gauss-Newton step taken per second; range 0 to 10
};

/// Bachmann's correction (Miller 2004, equation 15): one Gauss-Newton step on the six differences of gravity
/// and field, as three local turns.
std::vector<Quaterniond> bachmannOrientation(const ImuSamples& samples,
                                             const BachmannSettings& settings = {});

}  // namespace noctule
