// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/body/text.h"
#include "core/report/angle_names.h"
#include "core/report/html.h"
#include "core/report/sections.h"
#include "core/report/svg_plot.h"
#include "core/report/take_verdict.h"

namespace noctule {
namespace {

constexpr const char* kAngleNames[] = {"Z", "X", "Y"};  // the order of joint_angles.h

html::Row jointRow(const JointComparison& joint, double scale_deg) {
    const AngleStatistics& a = joint.angle;
    const bool look = a.mean_deg > VerdictLimits{}.good_joint_deg;
    const std::string words = text::jointLabel(joint.name) + ", mean " + text::degrees(a.mean_deg);
    return {
        {text::escaped(text::jointLabel(joint.name)) +
             (joint.composed ? " <small>from " + text::escaped(joint.relative_to) + "</small>" : ""),
         std::string(look ? "<span class=\"look\">" : "<span>") + text::degrees(a.mean_deg, 2) + "</span>",
         text::degrees(a.median_deg, 2), text::degrees(a.std_deg, 2), text::degrees(a.rms_deg, 2),
         text::degrees(a.p95_deg, 2), text::degrees(a.max_deg, 1), text::degrees(a.drift_deg_per_min, 2),
         text::number(joint.position_mm, 1), text::number(joint.nees, 1),
         html::bar({{scale_deg > 0 ? a.mean_deg / scale_deg : 0, look ? "inertia" : "good"}}, words)},
        ""};
}

std::string jointTable(const Comparison& c) {
    html::Table table{"Error of every joint",
                      {{"Joint", false},
                       {"Mean"},
                       {"Median"},
                       {"Deviation"},
                       {"RMS"},
                       {"95 %"},
                       {"Largest"},
                       {"Drift per minute"},
                       {"Position mm"},
                       {"NEES"},
                       {"Mean, against the worst joint", false}},
                      {}};
    double worst_deg = 0;
    for (const JointComparison& joint : c.joints)
        worst_deg = std::max(worst_deg, joint.angle.mean_deg);
    for (const JointComparison& joint : c.joints)
        table.rows.push_back(jointRow(joint, worst_deg));
    table.rows.push_back({{"Mean of all joints", text::degrees(c.mean_deg, 2), "", "", "", "", "", "", "",
                           text::number(c.nees, 1), ""},
                          "total"});
    return html::table(table);
}

/// One angle of figure 6.
std::string anglePlot(const JointCurve& curve, size_t axis, const Comparison& c, const ReportData& data) {
    LinePlot plot;
    const std::string name = anatomicalAngle(curve.name, axis);
    plot.title = text::jointLabel(curve.name) + ", " + (name.empty() ? "angle " : name + ", angle ") +
                 kAngleNames[axis];
    plot.description = "Estimate and reference over time; the band is two sigma of the estimate";
    plot.time_s = takeInterval(data);
    plot.values = niceInterval({curve.estimate_deg[axis], curve.reference_deg[axis]}, 10);
    plot.unit = "°";
    plot.height_px = 96;
    plot.time_labels = false;
    std::vector<double> two_sigma_deg;
    for (const double sigma_deg : curve.sigma_deg[axis])
        two_sigma_deg.push_back(2 * sigma_deg);
    if (!two_sigma_deg.empty())
        plot.bands.push_back({c.time_s, curve.estimate_deg[axis], two_sigma_deg});
    plot.curves.push_back({c.time_s, curve.estimate_deg[axis], "estimate",
                           two_sigma_deg.empty() ? "estimate" : "estimate with 2 sigma"});
    plot.curves.push_back({c.time_s, curve.reference_deg[axis], "reference", "reference"});
    return svg(plot);
}

std::string differencePlot(const JointCurve& curve, const Comparison& c, const ReportData& data) {
    LinePlot plot;
    plot.title = text::jointLabel(curve.name) + ", orientation difference";
    plot.description = "Angle between the estimated and the reference orientation over time";
    plot.time_s = takeInterval(data);
    plot.values = niceInterval({curve.difference_deg}, 1);
    plot.values.min = 0;
    plot.value_decimals = plot.values.max < 4 ? 1 : 0;
    plot.unit = "°";
    plot.height_px = 72;
    plot.curves.push_back({c.time_s, curve.difference_deg, "error", ""});
    return svg(plot);
}

}  // namespace

std::string jointsSection(const ReportData& data) {
    const ReportRun* run = data.shownRun();
    const std::string title = "Joints";
    if (!run || !run->comparison)
        return html::section("joints", title, "",
                             html::nothing("Without a reference the joints cannot be scored."));
    const Comparison& c = *run->comparison;
    std::string body = jointTable(c);
    body += html::note(
        "Half of the time a joint errs less than its median, 95 % of the time less than the value so headed. "
        "NEES compares the errors with what the filter says about them: 1 is honest, more is too sure. "
        "Position is that of the joint in the frame of the pelvis, so it gathers the errors of all joints "
        "above.");
    for (const JointCurve& curve : c.curves) {
        body +=
            html::heading(text::jointLabel(curve.name) + " against the reference") + "<div class=\"scroll\">";
        for (size_t axis = 0; axis < 3; ++axis)
            body += anglePlot(curve, axis, c, data);
        body += differencePlot(curve, c, data) + "</div>";
    }
    return html::section("joints", title,
                         "Angle between the estimated and the reference rotation of each joint, of run " +
                             run->name +
                             ". Curves are Cardan angles in the order Z, X, Y from the T pose, named as the "
                             "ISB names them; an "
                             "angle is positive in the direction of its name.",
                         body);
}

std::string rootSection(const ReportData& data) {
    const ReportRun* run = data.shownRun();
    if (!run || !run->comparison)
        return html::section("root", "Root", "",
                             html::nothing("Without a reference the drift is not known."));
    const Comparison& c = *run->comparison;
    std::string body =
        html::definitions({{"Heading, root mean square", text::degrees(c.root.yaw_deg, 2)},
                           {"Tilt, root mean square", text::degrees(c.root.tilt_deg, 2)},
                           {"Position, root mean square", text::number(c.root.position_m, 3) + " m"},
                           {"Root", run->root_given ? "given by another system" : "free"}});
    LinePlot plot;
    plot.time_s = takeInterval(data);
    plot.height_px = 84;
    plot.time_labels = false;
    const auto draw = [&](const char* title, const std::vector<double>& values, const char* unit,
                          double least, int decimals, bool is_signed) {
        plot.title = title;
        plot.description = "Difference to the reference over time";
        plot.values = niceInterval({values}, least);
        if (!is_signed)
            plot.values = {0, std::max(plot.values.max, least)};
        plot.unit = unit;
        plot.value_decimals = decimals;
        plot.curves = {{c.time_s, values, "error", ""}};
        body += svg(plot);
    };
    body += "<div class=\"scroll\">";
    draw("Heading", c.root.yaw_curve_deg, "°", 2, 1, true);
    draw("Tilt", c.root.tilt_curve_deg, "°", 1, 1, false);
    plot.time_labels = true;
    draw("Position", c.root.position_curve_m, " m", 0.05, 2, false);
    return html::section(
        "root", "Root",
        "How far the hips wander from the reference after heading and position were made equal "
        "in the first compared frame.",
        body + "</div>");
}

}  // namespace noctule
