// SPDX-License-Identifier: Apache-2.0
// What each solver of calibration found, in the units of people (mm, degrees, mg) for documents and in SI for
// machines. The documents come without date and takes.
#pragma once

#include <nlohmann/json.hpp>

#include "core/calibration/accelerometer/accelerometer_calibration.h"
#include "core/calibration/gyroscope/gyroscope_calibration.h"
#include "core/calibration/motion/motion_calibration.h"
#include "core/calibration/rest_pose/rest_pose_calibration.h"
#include "core/calibration/rest_pose/still_check.h"
#include "core/calibration/source_offsets/source_offsets.h"
#include "core/report/calibration_document.h"

namespace noctule {

CalibrationDocument documentOf(const SourceOffsetReport& report);
CalibrationDocument documentOf(const AccelerometerReport& report);
CalibrationDocument documentOf(const GyroscopeReport& report);
CalibrationDocument documentOf(const RestPoseReport& report);
CalibrationDocument documentOf(const MotionReport& report);
CalibrationDocument documentOf(const StillCheckReport& report);

/// Members of one procedure alone; verdict and reasons are the same for all (findingsJson).
nlohmann::json toJson(const SourceOffsetReport& report);
nlohmann::json toJson(const AccelerometerReport& report);
nlohmann::json toJson(const GyroscopeReport& report);
nlohmann::json toJson(const RestPoseReport& report);
nlohmann::json toJson(const MotionReport& report);
nlohmann::json toJson(const StillCheckReport& report);

/// {"verdict": "usable", "reasons": [sentence...], "findings": [{"verdict", "part", "what", "remedy"}...]}
nlohmann::json findingsJson(const std::vector<Finding>& findings);

}  // namespace noctule
