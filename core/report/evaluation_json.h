// SPDX-License-Identifier: Apache-2.0
// The figures of `noctule --batch evaluate --json`.
#pragma once

#include <nlohmann/json.hpp>

#include "core/report/report_data.h"

namespace noctule {

/// Of one run. Members of the command's documentation: take, run, sensors, joints[{name, mean_deg, std_deg,
/// rms_deg}], mean_deg, end_effector_mm, root{yaw_deg, tilt_deg, position_m}, nees, duration_s; what is
/// unknown is null. More members explain them. Every number is finite.
nlohmann::json evaluationJson(const ReportData& data, const ReportRun& run);

}  // namespace noctule
