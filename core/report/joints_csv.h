// SPDX-License-Identifier: Apache-2.0
// The table of joints as CSV (UTF-8, commas, decimal points), for statistics programs.
#pragma once

#include <string>
#include <vector>

#include "core/report/report_data.h"

namespace noctule {

struct SubjectReport {
    std::string subject;
    ReportData data;
};

/// A header, then one row per joint of every run that was compared: take, subject, run, sensors, estimator,
/// smoother, joint, relative_to, and the figures of `evaluate --json` under their names there. What is not
/// known is empty.
std::string jointsCsv(const std::vector<SubjectReport>& subjects);

}  // namespace noctule
