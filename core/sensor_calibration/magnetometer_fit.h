// SPDX-License-Identifier: Apache-2.0
// Hard and soft iron of a magnetometer that was turned through all directions in one place, and where a
// field is bent.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/orientation/imu_samples.h"
#include "core/sensor_calibration/ellipsoid_fit.h"

namespace noctule {

struct MagnetometerFit {
    EllipsoidFit ellipsoid;      ///< its matrix gives microtesla
    double strength_ut = 0;      ///< of the field
    double before_percent = 0;   ///< fieldSpread_percent() as it was read
    double after_percent = 0;    ///< and with the fit
    DirectionCoverage coverage;  ///< of the directions of the calibrated field in the sensor's frame
    /// Why it must not be used, a sentence; empty: usable.
    std::string problem, remedy;
};

/// `strength_ut` none: the mean length of the readings is kept, which is right for readings in microtesla.
/// Missing readings are left out.
MagnetometerFit fitMagnetometer(const std::vector<Vector3d>& readings, std::optional<double> strength_ut);

/// Standard deviation of |matrix * (reading - zero)| over the directions that were seen, in percent of its
/// mean; each direction counts once. 0 with too few readings.
double fieldSpread_percent(const std::vector<Vector3d>& readings, const Vector3d& zero,
                           const Matrix3d& matrix);

/// A stretch in which the field is not the usual one of the recording.
struct BentField {
    double from_s = 0, to_s = 0;
    double strength_off_percent = 0;  ///< the largest
    double dip_off_deg = 0;           ///< the largest change of the angle to gravity
};

struct FieldCheck {
    double strength = 0;      ///< median, in the readings' unit
    double dip_deg = 0;       ///< median angle below the horizon, from quiet moments
    double bent_percent = 0;  ///< share of the time
    bool has_dip = false;     ///< false: no quiet moment, so only the strength was judged
    std::vector<BentField> stretches;
};

/// Half-second blocks; bent beyond 7 % of strength or 5 degrees of dip.
FieldCheck checkField(const ImuSamples& samples);

}  // namespace noctule
