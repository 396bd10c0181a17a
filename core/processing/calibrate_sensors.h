// SPDX-License-Identifier: Apache-2.0
// Calibrations of single inertial sensors that need nothing but the sensor: magnetometers turned through all
// directions, gyroscopes and accelerometers laid down and turned by hand. Takes of readings in, a
// calibration and what is to be said about it out.
#pragma once

#include <optional>

#include "core/processing/calibrate_takes.h"

namespace noctule {

/// `strength_ut` none: the mean length of the readings is kept. Boards without magnetometer, and those
/// without readings of it, keep what they have. Each take is also looked through for stretches in which the
/// field is bent.
Result<CalibrationResult> calibrateMagnetometers(const CalibrateRequest& request,
                                                 std::optional<double> strength_ut, const JobContext& job);
/// Gravity as the take states it.
Result<CalibrationResult> calibrateInertial(const CalibrateRequest& request, const JobContext& job);

/// Puts a calibration in force in each of the takes of the request.
Status storeCalibration(const std::vector<std::string>& take_paths, const Calibration& calibration);

}  // namespace noctule
