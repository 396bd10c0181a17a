// SPDX-License-Identifier: Apache-2.0
// The report of a take: one HTML file that needs nothing else, no script, no network. UTF-8, light and dark,
// printable. Below about 3 MB whatever the length of the take.
#pragma once

#include <string>
#include <vector>

#include "core/report/report_data.h"

namespace noctule {

std::string htmlReport(const ReportData& data);

/// One part of the report, for viewers that bring their own page: well-formed markup (html.h), drawings as
/// inline SVG with the classes of style.h.
struct ReportPart {
    std::string id;     ///< "joints"
    std::string title;  ///< "Joints"
    std::string html;   ///< a <section>
};
std::vector<ReportPart> reportParts(const ReportData& data);

}  // namespace noctule
