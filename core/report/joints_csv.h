// SPDX-License-Identifier: Apache-2.0
// The table of joints as CSV (UTF-8, commas, decimal points), for statistics programs.
#pragma once

#include <string>

#include "core/report/report_data.h"

namespace noctule {

/// A header, then one row per joint of every run that was compared: take, run, sensors, estimator, smoother,
/// joint, relative_to, and the figures of `evaluate --json` under their names there. What is not known is
/// empty.
std::string jointsCsv(const ReportData& data);

}  // namespace noctule
