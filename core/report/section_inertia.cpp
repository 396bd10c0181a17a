// SPDX-License-Identifier: Apache-2.0
#include "core/body/text.h"
#include "core/report/html.h"
#include "core/report/sections.h"
#include "core/report/verdict.h"

namespace noctule {
namespace {

double shareOf(int64_t part, int64_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : NAN;
}

std::string marked(int64_t count) {
    return count > 0 ? "<span class=\"look\">" + text::count(count) + "</span>" : "0";
}

html::Row boardRow(const ReportData& data, size_t index) {
    const ReportBoard& board = data.boards[index];
    const double present = shareOf(board.readings_present, board.readings_expected);
    std::string label = boardLabel(data, static_cast<int>(index));
    const bool look = present < kGoodReadings;
    return {{text::escaped(text::capitalised(label)), text::count(board.frames_expected),
             marked(board.frames_lost), text::count(board.corrected_bits), marked(board.clipped_gyro),
             marked(board.clipped_accel),
             std::string(look ? "<span class=\"look\">" : "<span>") + text::percent(present) + "</span>",
             html::bar({{std::isfinite(present) ? present : 0, look ? "inertia" : "good"}},
                       text::percent(present) + " of the readings are present")},
            ""};
}

}  // namespace

std::string inertiaSection(const ReportData& data) {
    if (data.boards.empty())
        return html::section("inertia", "Inertial readings", "",
                             html::nothing("The take describes no boards."));
    html::Table table{"Inertial stream by board",
                      {{"Board", false},
                       {"Frames"},
                       {"Lost"},
                       {"Bits repaired"},
                       {"Clipped, gyroscope"},
                       {"Clipped, accelerometer"},
                       {"Readings present"},
                       {"", false}},
                      {}};
    table.columns.back().title = "Share";
    for (size_t i = 0; i < data.boards.size(); ++i)
        table.rows.push_back(boardRow(data, i));
    return html::section(
        "inertia", "Inertial readings",
        "What each board's stream delivered. A lost frame silences its axes until their next "
        "absolute value; a clipped reading lies at the end of its range and is never used.",
        html::table(table));
}

std::string provenanceSection(const ReportData& data) {
    const ReportTake& take = data.take;
    std::string body =
        html::heading("Take") +
        html::definitions(
            {{"File", take.file},
             {"Identity", take.uuid},
             {"Recorded", text::utc(take.created_utc)},
             {"Performer", take.performer},
             {"Actor", take.actor_name},
             {"Length", text::number(take.duration_s, 2) + " s"},
             {"Rest at its start", text::number(std::max(0.0, take.rest_s - take.begin_s), 1) + " s"},
             {"Sample rate", text::number(take.sample_rate_hz, 0) + " Hz"},
             {"Level", take.level},
             {"Reference",
              take.reference_kind + (take.reference_name.empty() ? "" : ", ") + take.reference_name},
             {"Written by", take.software}});
    for (const ReportRun& run : data.runs) {
        NamedValues entries = {{"Sensors", sensorsInWords(run.sensors)},
                               {"Estimator", estimatorInWords(run.estimator)},
                               {"Smoothing", run.smoother},
                               {"Root", run.root_given ? "given" : "free"},
                               {"Calibration", run.calibration},
                               {"Made", text::utc(run.created_utc)},
                               {"Software", run.software}};
        if (run.comparison)
            entries.emplace_back(
                "Reference time added",
                text::number(static_cast<double>(run.comparison->offset.add_to_reference_ns) * 1e-6, 1) +
                    " ms");
        entries.insert(entries.end(), run.settings.begin(), run.settings.end());
        body += html::heading("Result " + run.name) + html::definitions(entries);
    }
    for (const auto& [title, entries] : data.provenance)
        body += html::heading(title) + html::definitions(entries);
    if (!take.notes.empty())
        body += html::heading("Notes") + html::list(take.notes);
    return html::section("provenance", "Settings, calibration and versions",
                         "All that these numbers were made with.", body);
}

}  // namespace noctule
