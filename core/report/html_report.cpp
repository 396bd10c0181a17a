// SPDX-License-Identifier: Apache-2.0
#include "core/report/html_report.h"

#include <span>

#include "core/body/text.h"
#include "core/report/html.h"
#include "core/report/sections.h"

namespace noctule {
namespace {

struct Part {
    const char *id, *title;
    std::string (*section)(const ReportData& data);
};

constexpr Part kParts[] = {{"summary", "Summary", summarySection},
                           {"runs", "Sensors and results", runsSection},
                           {"joints", "Joints", jointsSection},
                           {"root", "Root", rootSection},
                           {"confidence", "Confidence", confidenceSection},
                           {"ranges", "Ranges", rangesSection},
                           {"inertia", "Inertial readings", inertiaSection},
                           {"observability", "What was observable", observabilitySection},
                           {"provenance", "Settings", provenanceSection}};

constexpr const char* kWords = "Words of this report";

/// To all parts but the summary, which stands below it.
std::string navigation() {
    std::string out = "<nav aria-label=\"Parts of this report\">";
    for (const Part& part : std::span(kParts).subspan(1))
        out += std::string("<a href=\"#") + part.id + "\">" + part.title + "</a>";
    return out + "</nav>\n";
}

}  // namespace

std::string htmlReport(const ReportData& data) {
    const ReportTake& take = data.take;
    std::string body = navigation();
    for (const Part& part : kParts) {
        body += part.section(data);
        if (part.section == summarySection)  // before any of them is needed
            body += "<section>" + html::folded(kWords, definitionsOfWords()) + "</section>\n";
    }
    std::string about = text::clock(take.duration_s);
    if (!take.performer.empty())
        about += ", " + take.performer;
    if (!take.created_utc.empty())
        about += ", " + text::utc(take.created_utc);
    return html::page(take.name, "Take report", about, body,
                      "Angles in degrees, lengths in metres unless a column says otherwise, time in minutes "
                      "and seconds of the take.");
}

std::vector<ReportPart> reportParts(const ReportData& data) {
    std::vector<ReportPart> parts;
    for (const Part& part : kParts)
        parts.push_back({part.id, part.title, part.section(data)});
    parts.push_back({"words", kWords,
                     html::section("words", kWords, "What the technical words mean.", definitionsOfWords())});
    return parts;
}

}  // namespace noctule
