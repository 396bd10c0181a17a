// SPDX-License-Identifier: Apache-2.0
// The report of a take: one HTML file that needs nothing else, no script, no network. UTF-8, light and dark,
// printable. Below about 3 MB whatever the length of the take.
#pragma once

#include <string>

#include "core/report/report_data.h"

namespace noctule {

std::string htmlReport(const ReportData& data);

}  // namespace noctule
