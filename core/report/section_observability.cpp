// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/body/text.h"
#include "core/report/html.h"
#include "core/report/sections.h"

namespace noctule {
namespace {

constexpr double kWellBacked = 0.9;

std::string named(const std::vector<std::string>& names) {
    std::string out;
    for (size_t i = 0; i < names.size(); ++i)
        out += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return out;
}

std::string supportStatement(const std::vector<JointSupport>& support) {
    std::vector<std::string> weak;
    for (const JointSupport& joint : support)
        if (joint.ranges < kWellBacked)
            weak.push_back(text::jointLabel(joint.joint) + " (" + text::percent(joint.ranges) + ")");
    if (weak.empty())
        return "Every joint was backed by ranges in at least 90 % of the frames.";
    const auto all = static_cast<int64_t>(support.size());
    return text::count(all - static_cast<int64_t>(weak.size())) + " of " +
           text::plural(all, "joint", "joints") +
           " were backed by ranges in at least 90 % of the frames. Less: " + named(weak) + ".";
}

std::vector<std::string> statements(const ReportData& data, const ReportRun* run) {
    std::vector<std::string> out;
    const bool has_distances = run && run->sensors.find('D') != std::string::npos;
    const bool has_gyroscopes = run && run->sensors.find('G') != std::string::npos;
    const bool has_accelerometers = run && run->sensors.find('A') != std::string::npos;
    if (run && !has_distances)
        out.emplace_back(
            "The shown result used no ranges: every joint rested on inertia alone and nothing held the "
            "angles between segments over long times.");
    else if (!data.support.empty())
        out.emplace_back(supportStatement(data.support));
    if (run && !has_gyroscopes)
        out.emplace_back(
            "The shown result used no gyroscopes: rotation between two ranges or readings is a guess of "
            "the model.");
    if (!run || run->root_given)
        out.emplace_back(
            "The root came from another system; this report says nothing about how well the suit "
            "alone would know it.");
    else
        out.emplace_back(
            "Heading and position of the root cannot be observed by the suit: nothing on it measures "
            "them absolutely, so they drift.");
    if (run && !run->root_given)
        out.emplace_back(has_accelerometers ? "Tilt of the root is held by gravity in the accelerometers."
                                            : "Without accelerometers nothing holds the tilt of the root.");
    if (data.take.reference_kind == "simulated")
        out.emplace_back(
            "The reference is the simulation's own truth: errors contain what the simulation models "
            "and nothing that it leaves out.");
    else if (!data.take.reference_kind.empty())
        out.emplace_back(
            "The reference has errors of its own, which are contained in every error of this report.");
    return out;
}

std::string supportTable(const std::vector<JointSupport>& support) {
    html::Table table{
        "What each joint rested on",
        {{"Joint", false}, {"Ranges"}, {"Inertia alone"}, {"Model alone"}, {"Share of frames", false}},
        {}};
    for (const JointSupport& joint : support)
        table.rows.push_back(
            {{text::escaped(text::jointLabel(joint.joint)), text::percent(joint.ranges),
              text::percent(joint.inertia), text::percent(joint.alone()),
              html::bar({{joint.ranges, "good"}, {joint.inertia, "inertia"}, {joint.alone(), "alone"}},
                        "ranges " + text::percent(joint.ranges) + ", inertia alone " +
                            text::percent(joint.inertia))},
             ""});
    return html::key({{"good", "backed by ranges"},
                      {"inertia", "by inertia alone"},
                      {"alone", "by the model alone"}}) +
           html::table(table);
}

}  // namespace

std::string observabilitySection(const ReportData& data) {
    std::string body = html::list(statements(data, data.shownRun()));
    body += data.support.empty()
                ? html::nothing("How often ranges backed each joint is not known for this result.")
                : supportTable(data.support);
    return html::section(
        "observability", "What was observable",
        "A joint is backed by ranges in a frame when, a moment before, a range in use lay across "
        "it. Otherwise it goes on by its boards' inertia, and without these by the model. The rest pose at "
        "the beginning does not count.",
        body);
}

}  // namespace noctule
