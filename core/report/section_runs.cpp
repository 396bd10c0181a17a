// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <deque>

#include "core/body/text.h"
#include "core/report/course_points.h"
#include "core/report/html.h"
#include "core/report/paper_table.h"
#include "core/report/sections.h"
#include "core/report/svg_plot.h"

namespace noctule {
namespace {

constexpr size_t kMostCurves = 7;

std::vector<const ReportRun*> inPaperOrder(const std::vector<ReportRun>& runs) {
    std::vector<const ReportRun*> ordered;
    for (const ReportRun& run : runs)
        if (run.comparison)
            ordered.push_back(&run);
    std::stable_sort(ordered.begin(), ordered.end(), [](const ReportRun* a, const ReportRun* b) {
        return paperOrder(a->sensors) < paperOrder(b->sensors);
    });
    return ordered;
}

/// "2: AGD smoothed", escaped.
std::string numberedName(const ReportRun& run) {
    return (run.number > 0 ? std::to_string(run.number) + ": " : std::string()) + text::escaped(run.name);
}

html::Row ownRow(const ReportRun& run, bool shown) {
    html::Row row{{text::escaped(sensorsLabel(run.sensors)), numberedName(run),
                   text::escaped(estimatorInWords(run.estimator) + (run.root_given ? ", root given" : ""))},
                  shown ? "shown" : ""};
    for (const char* name : kPaperJoints) {
        const JointComparison* joint = run.comparison->find(name);
        row.cells_html.push_back(joint ? text::number(joint->angle.mean_deg, 1) : "–");
        row.cells_html.push_back(joint ? text::number(joint->angle.std_deg, 1) : "–");
    }
    row.cells_html.push_back(text::number(run.comparison->mean_deg, 1));
    return row;
}

html::Row paperRow(const PaperRow& paper) {
    html::Row row{{sensorsLabel(paper.sensors), "the paper", "extended Kalman filter"}, "paper"};
    for (size_t i = 0; i < kPaperJoints.size(); ++i) {
        row.cells_html.push_back(text::number(paper.mean_deg[i], 1));
        row.cells_html.push_back(text::number(paper.std_deg[i], 1));
    }
    row.cells_html.push_back("–");
    return row;
}

std::string table1(const std::vector<const ReportRun*>& runs, const ReportRun* shown) {
    html::Table table{"Orientation differences to the reference by sensors, in degrees",
                      {{"Sensors", false},
                       {"Result", false},
                       {"Estimator", false},
                       {"Mean", true, "Neck\u00A0°"},
                       {"Deviation", true, "Neck\u00A0°"},
                       {"Mean", true, "Right shoulder\u00A0°"},
                       {"Deviation", true, "Right shoulder\u00A0°"},
                       {"Mean", true, "Left hip\u00A0°"},
                       {"Deviation", true, "Left hip\u00A0°"},
                       {"Mean", true, "All joints\u00A0°"}},
                      {}};
    for (size_t i = 0; i < runs.size(); ++i) {
        table.rows.push_back(ownRow(*runs[i], runs[i] == shown));
        const size_t place = paperOrder(runs[i]->sensors);
        const bool is_last_of_its_kind = i + 1 == runs.size() || runs[i + 1]->sensors != runs[i]->sensors;
        if (is_last_of_its_kind && place < kPaperTable1.size())
            table.rows.push_back(paperRow(kPaperTable1[place]));
    }
    return html::table(table);
}

/// The paper's figure 7: with and without distances, does the error grow?
std::string errorPlot(const std::vector<const ReportRun*>& runs, const std::string& title,
                      const ReportData& data) {
    if (runs.empty())
        return "";
    LinePlot plot;
    plot.title = title;
    plot.time_s = takeInterval(data);
    plot.unit = "°";
    plot.height_px = 160;
    std::vector<std::span<const double>> all;
    std::deque<CoursePoints> courses;  // the plot looks at them
    for (size_t i = runs.size() - std::min(runs.size(), kMostCurves); i < runs.size(); ++i) {
        const CoursePoints& mean_deg = courses.emplace_back(pointsOf(runs[i]->comparison->mean_curve_deg));
        plot.curves.push_back(
            {mean_deg.time_s, mean_deg.values, "run" + std::to_string(runs.size() - 1 - i), runs[i]->name});
        all.emplace_back(mean_deg.values);
    }
    plot.values = niceInterval(all, 1);
    plot.values.min = 0;
    plot.value_decimals = plot.values.max < 4 ? 1 : 0;
    plot.description = "Mean over all joints of the angle to the reference, one curve per result";
    return "<div class=\"scroll\">" + svg(plot) + "</div>" +
           (runs.size() > kMostCurves ? html::note("Drawn are the last " + std::to_string(kMostCurves) +
                                                   " of " + std::to_string(runs.size()) + " results.")
                                      : "");
}

/// Runs without gyroscopes are so much worse that they would flatten the others' curves.
std::string errorPlots(const std::vector<const ReportRun*>& runs, const ReportData& data) {
    std::vector<const ReportRun*> with, without;
    for (const ReportRun* run : runs)
        (run->sensors.find('G') != std::string::npos ? with : without).push_back(run);
    return errorPlot(with, "Mean joint error over time, results with gyroscopes", data) +
           errorPlot(without, "Mean joint error over time, results without gyroscopes", data);
}

/// Joint by joint, the runs that were held against the shown one.
std::string distancesTable(const ReportData& data) {
    const ReportRun* shown = data.shownRun();
    std::vector<const ReportRun*> others;
    for (const ReportRun& run : data.runs)
        if (run.from_shown)
            others.push_back(&run);
    if (!shown || others.empty())
        return "";
    html::Table table{"How far other results are from the shown one, in degrees", {{"Joint", false}}, {}};
    for (const ReportRun* run : others)
        for (const char* what : {"Mean", "95\u00A0%"})
            table.columns.push_back({what, true, numberedName(*run) + "\u00A0°"});
    for (const JointComparison& joint : others[0]->from_shown->joints) {
        html::Row row{{text::escaped(text::jointLabel(joint.name))}, ""};
        for (const ReportRun* run : others) {
            const JointComparison* there = run->from_shown->find(joint.name);
            row.cells_html.push_back(there ? text::number(there->angle.mean_deg, 2) : "–");
            row.cells_html.push_back(there ? text::number(there->angle.p95_deg, 2) : "–");
        }
        table.rows.push_back(std::move(row));
    }
    html::Row all{{"All joints"}, "total"};
    for (const ReportRun* run : others) {
        all.cells_html.push_back(text::number(run->from_shown->mean_deg, 2));
        all.cells_html.push_back("");
    }
    table.rows.push_back(std::move(all));
    return html::heading(table.caption) + html::table(table) +
           html::note(
               "The angle between a joint's two orientations, in the mean and below what it is for 95 % of "
               "the time. The shown result is " +
               text::escaped(shown->name) + ". Which of two results is right only a reference tells.");
}

}  // namespace

std::string runsSection(const ReportData& data) {
    const std::vector<const ReportRun*> runs = inPaperOrder(data.runs);
    std::string body;
    if (runs.empty()) {
        body = html::nothing(
            "No result of this take has been compared: it has no reference, or was not processed yet.");
    } else {
        body = html::note("A stands for accelerometers, G for gyroscopes and D for distances.") +
               table1(runs, data.shownRun()) +
               html::note(
                   "The paper's rows are its Table 1: another motion, performer and suit, 30 s against an "
                   "optical system. They are a scale to read ours by and no contest. Its neck is our "
                   "head joint.") +
               errorPlots(runs, data);
    }
    body += distancesTable(data);
    return html::section(
        "runs", "Sensors and results",
        "How each result of this take compares with the reference: the angle between the two "
        "orientations of a joint, its mean and its standard deviation over the take.",
        body);
}

}  // namespace noctule
