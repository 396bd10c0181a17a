// SPDX-License-Identifier: Apache-2.0
// Two calibrations side by side: what differs, part by part, in units that mean something on the body.
#pragma once

#include <vector>

#include "core/report/calibration_document.h"
#include "core/suit/calibration.h"

namespace noctule {

/// Tables of boards and of sources: of each part how far `other` is from `one`; "–" where only one of them
/// knows. Parts without any difference are left out, and tables without rows.
std::vector<CalibrationTable> compareCalibrations(const Calibration& one, const Calibration& other);

}  // namespace noctule
