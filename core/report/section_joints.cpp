// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

#include "core/body/text.h"
#include "core/report/angle_names.h"
#include "core/report/course_points.h"
#include "core/report/html.h"
#include "core/report/sections.h"
#include "core/report/svg_plot.h"
#include "core/report/take_verdict.h"

namespace noctule {
namespace {

constexpr const char* kAngleNames[] = {"Z", "X", "Y"};  // the order of joint_angles.h
constexpr double kHalfWidth_px = 488;

/// In degrees, which the table's head says. Three digits, so that bad angles need no wider column.
std::string angleCell(double angle_deg) {
    return text::number(angle_deg, std::abs(angle_deg) < 9.995 ? 2 : 1);
}

html::Row jointRow(const JointComparison& joint, double scale_deg) {
    const AngleStatistics& a = joint.angle;
    const bool look = a.mean_deg > VerdictLimits{}.good_joint_deg;
    const std::string words = text::jointLabel(joint.name) + ", mean " + text::degrees(a.mean_deg);
    return {{text::escaped(text::jointLabel(joint.name)) +
                 (joint.composed ? " <small>from " + text::escaped(joint.relative_to) + "</small>" : ""),
             std::string(look ? "<span class=\"look\">" : "<span>") + angleCell(a.mean_deg) + "</span>",
             angleCell(a.median_deg), angleCell(a.std_deg), angleCell(a.rms_deg), angleCell(a.p95_deg),
             text::number(a.max_deg, 1), angleCell(a.drift_deg_per_min), text::number(joint.position_mm, 1),
             text::number(joint.nees, 1),
             html::bar({{scale_deg > 0 ? a.mean_deg / scale_deg : 0, look ? "inertia" : "good"}}, words)},
            ""};
}

std::string jointTable(const Comparison& c) {
    const std::string angle = "Angle, degrees";
    html::Table table{"Error of every joint",
                      {{"Joint", false},
                       {"Mean", true, angle},
                       {"Median", true, angle},
                       {"SD", true, angle},
                       {"RMS", true, angle},
                       {"95 %", true, angle},
                       {"Max", true, angle},
                       {"Drift °/min"},
                       {"Position mm"},
                       {"NEES"},
                       {"Mean, against the worst joint", false}},
                      {}};
    double worst_deg = 0;
    for (const JointComparison& joint : c.joints)
        worst_deg = std::max(worst_deg, joint.angle.mean_deg);
    for (const JointComparison& joint : c.joints)
        table.rows.push_back(jointRow(joint, worst_deg));
    table.rows.push_back({{"Mean of all joints", angleCell(c.mean_deg), "", "", "", "", "", "", "",
                           text::number(c.nees, 1), ""},
                          "total"});
    return html::table(table);
}

/// Half as wide, two in a row, without legend and band: of the joints that are folded away, or else the page
/// of a long take would grow beyond 3 MB.
enum class PlotSize { kWhole, kHalf };

/// One angle of figure 6.
std::string anglePlot(const JointCurve& curve, size_t axis, PlotSize size, const ReportData& data) {
    const CoursePoints estimate_deg =
        withinHalfTurn(pointsOf(curve.estimate_deg[axis], curve.sigma_deg[axis]));
    const CoursePoints reference_deg = withinHalfTurn(pointsOf(curve.reference_deg[axis]));
    const bool is_whole = size == PlotSize::kWhole;
    LinePlot plot;
    const std::string name = anatomicalAngle(curve.name, axis);
    plot.title = text::jointLabel(curve.name) + ", " + (name.empty() ? "angle " : name + ", angle ") +
                 kAngleNames[axis];
    plot.description = is_whole ? "Estimate and reference over time; the band is two sigma of the estimate"
                                : "Estimate and reference over time";
    plot.time_s = takeInterval(data);
    plot.values = niceInterval({estimate_deg.values, reference_deg.values}, 10);
    plot.values = {std::max(plot.values.min, -180.0), std::min(plot.values.max, 180.0)};
    plot.unit = "°";
    plot.height_px = is_whole ? 96 : 72;
    plot.width_px = is_whole ? kPlotWidth_px : kHalfWidth_px;
    plot.time_labels = false;
    const bool has_band = is_whole && !curve.sigma_deg[axis].stretches().empty();
    if (has_band)
        plot.bands.push_back({estimate_deg.time_s, estimate_deg.values, estimate_deg.half_width});
    const std::string estimate = has_band ? "estimate with 2 sigma" : "estimate";
    plot.curves.push_back({estimate_deg.time_s, estimate_deg.values, "estimate", is_whole ? estimate : ""});
    plot.curves.push_back(
        {reference_deg.time_s, reference_deg.values, "reference", is_whole ? "reference" : ""});
    return svg(plot);
}

std::string differencePlot(const JointCurve& curve, PlotSize size, const ReportData& data) {
    const CoursePoints difference_deg = pointsOf(curve.difference_deg);
    LinePlot plot;
    plot.title = text::jointLabel(curve.name) + ", orientation difference";
    plot.description = "Angle between the estimated and the reference orientation over time";
    plot.time_s = takeInterval(data);
    plot.values = niceInterval({difference_deg.values}, 1);
    plot.values = {0, std::min(plot.values.max, 180.0)};
    plot.value_decimals = plot.values.max < 4 ? 1 : 0;
    plot.unit = "°";
    plot.height_px = 72;
    plot.width_px = size == PlotSize::kWhole ? kPlotWidth_px : kHalfWidth_px;
    plot.curves.push_back({difference_deg.time_s, difference_deg.values, "error", ""});
    return svg(plot);
}

std::string jointPlots(const JointCurve& curve, PlotSize size, const ReportData& data) {
    std::string out = html::heading(text::jointLabel(curve.name) + " against the reference") +
                      (size == PlotSize::kWhole ? "<div class=\"scroll\">" : "<div class=\"pair\">");
    for (size_t axis = 0; axis < 3; ++axis)
        out += anglePlot(curve, axis, size, data);
    return out + differencePlot(curve, size, data) + "</div>";
}

/// The three that err most, and those of the paper's figure 6.
std::set<std::string> shownAtOnce(const Comparison& c) {
    constexpr size_t kWorst = 3;
    std::vector<const JointComparison*> joints;
    for (const JointComparison& joint : c.joints)
        joints.push_back(&joint);
    std::ranges::stable_sort(joints, std::greater(), [](const JointComparison* joint) {
        return std::isfinite(joint->angle.mean_deg) ? joint->angle.mean_deg : INFINITY;
    });
    std::set<std::string> names = {"Head", "RightArm", "LeftUpLeg"};
    for (size_t i = 0; i < std::min(kWorst, joints.size()); ++i)
        names.insert(joints[i]->name);
    return names;
}

constexpr const char* kBodyParts[] = {"Trunk and head", "Left arm",  "Right arm",
                                      "Left leg",       "Right leg", "Other joints"};

/// Index in kBodyParts.
size_t bodyPartOf(const std::string& joint) {
    const bool is_right = joint.starts_with("Right");
    const std::string part = is_right || joint.starts_with("Left") ? joint.substr(is_right ? 5 : 4) : "";
    const auto is_one_of = [](const std::string& name, std::initializer_list<const char*> names) {
        return std::ranges::find(names, name) != names.end();
    };
    if (is_one_of(joint, {"Spine", "Chest", "Neck", "Head"}))
        return 0;
    if (is_one_of(part, {"Shoulder", "Arm", "ForeArm", "Hand"}))
        return is_right ? 2 : 1;
    if (is_one_of(part, {"UpLeg", "Leg", "Foot", "ToeBase"}))
        return is_right ? 4 : 3;
    return std::size(kBodyParts) - 1;
}

std::string allCurves(const Comparison& c, const ReportData& data) {
    const std::set<std::string> at_once = shownAtOnce(c);
    std::string open;
    std::array<std::string, std::size(kBodyParts)> folded;
    for (const JointCurve& curve : c.curves)
        if (at_once.contains(curve.name))
            open += jointPlots(curve, PlotSize::kWhole, data);
        else
            folded[bodyPartOf(curve.name)] += jointPlots(curve, PlotSize::kHalf, data);
    for (size_t part = 0; part < folded.size(); ++part)
        if (!folded[part].empty())
            open += html::folded(kBodyParts[part], folded[part]);
    return open;
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
        "SD is the standard deviation, RMS the root mean square. Half of the time a joint errs less than its "
        "median, 95 % of the time less than the value so headed. "
        "NEES compares the errors with what the filter says about them: 1 is honest, more is too sure. "
        "Position is that of the joint in the frame of the pelvis, so it gathers the errors of all joints "
        "above.");
    body += html::note(
        "Curves follow of the head, the right shoulder, the left hip and the three joints that err most; "
        "those "
        "of all others are folded below them, by body part. Estimates are whole lines, the reference is "
        "dashed; a curve breaks where it passes 180°.");
    body += allCurves(c, data);
    return html::section("joints", title,
                         "Angle between the estimated and the reference rotation of each joint, of result " +
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
    const auto draw = [&](const char* title, const Course& course, const char* unit, double least,
                          int decimals, bool is_signed) {
        const CoursePoints points = pointsOf(course);
        plot.title = title;
        plot.description = "Difference to the reference over time";
        plot.values = niceInterval({points.values}, least);
        if (!is_signed)
            plot.values = {0, std::max(plot.values.max, least)};
        plot.unit = unit;
        plot.value_decimals = decimals;
        plot.curves = {{points.time_s, points.values, "error", ""}};
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
