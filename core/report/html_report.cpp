// SPDX-License-Identifier: Apache-2.0
#include "core/report/html_report.h"

#include <span>

#include "core/report/html.h"
#include "core/report/sections.h"
#include "core/report/style.h"
#include "core/report/text.h"

namespace noctule {
namespace {

constexpr const char* kMark =
    "<svg class=\"mark\" viewBox=\"0 0 26 18\" aria-hidden=\"true\"><path d=\"M13 3.2l1.5-1.7 1 2.4c2-.2 "
    "2.9-1.6 "
    "3-3.4 3.4 1.5 6.2 4.6 7 9.5-1.7-1.100-3.5-1-4.9.3-1.5-1.2-3.3-.8-4.2 1-.7 1.7-1.8 "
    "3.4-3.4 5-1.6-1.6-2.7-3.3-3.4-5-.9-1.8-2.7-2.2-4.2-1-1.4-1.3-3.2-1.4-4.9-.3.8-4.9 "
    "3.6-8 7-9.5.1 1.8 1 3.2 3 3.4l1-2.4z\"/></svg>";

struct Part {
    const char *id, *title;
    std::string (*section)(const ReportData& data);
};

constexpr Part kParts[] = {{"summary", "Summary", summarySection},
                           {"runs", "Sensors and runs", runsSection},
                           {"joints", "Joints", jointsSection},
                           {"root", "Root", rootSection},
                           {"confidence", "Confidence", confidenceSection},
                           {"ranges", "Ranges", rangesSection},
                           {"inertia", "Inertial readings", inertiaSection},
                           {"observability", "What was observable", observabilitySection},
                           {"provenance", "Settings", provenanceSection}};

/// To all parts but the summary, which stands below it.
std::string navigation() {
    std::string out = "<nav aria-label=\"Parts of this report\">";
    for (const Part& part : std::span(kParts).subspan(1))
        out += std::string("<a href=\"#") + part.id + "\">" + part.title + "</a>";
    return out + "</nav>\n";
}

std::string head(const ReportTake& take) {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
           text::escaped(take.name) +
           ", take report</title><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
           "<meta name=\"generator\" content=\"Noctule\"><style>" +
           styleSheet() + "</style></head>\n";
}

std::string banner(const ReportTake& take) {
    return std::string("<header><div>") + kMark + "<strong>" + text::escaped(take.name) + "</strong><span>" +
           text::clock(take.duration_s) + "</span><span class=\"what\">Take report" +
           (take.performer.empty() ? "" : ", " + text::escaped(take.performer)) +
           (take.created_utc.empty() ? "" : ", " + text::escaped(text::utc(take.created_utc))) +
           "</span></div></header>\n";
}

}  // namespace

std::string htmlReport(const ReportData& data) {
    std::string page = head(data.take) + "<body>" + banner(data.take) + "<main>" + navigation();
    for (const Part& part : kParts)
        page += part.section(data);
    return page +
           "<footer>Made by Noctule. Angles in degrees, lengths in metres unless a column says otherwise, "
           "time in minutes and seconds of the take.</footer></main></body></html>\n";
}

std::vector<ReportPart> reportParts(const ReportData& data) {
    std::vector<ReportPart> parts;
    for (const Part& part : kParts)
        parts.push_back({part.id, part.title, part.section(data)});
    return parts;
}

}  // namespace noctule
