// SPDX-License-Identifier: Apache-2.0
#include "core/robot/robot_report.h"

#include <algorithm>
#include <cstdio>

#include "core/body/text.h"
#include "core/robot/driven_parts.h"

namespace noctule::robot {
namespace {

constexpr double kSize = 260, kMargin = 22;  ///< of a drawing, in its own units
constexpr double kGrid_m = 0.1, kSmallest_m = 0.3;
constexpr size_t kMostPoints = 1500;  ///< of a line; more are not seen

struct ReportView {
    const char *name, *across_name, *up_name;
    int across, up;
    double sign;  ///< of the axis across
};
constexpr ReportView kViews[] = {
    {"Front", "X", "Y", 0, 1, 1}, {"Side", "Z", "Y", 2, 1, 1}, {"Top", "X", "Z", 0, 2, -1}};

template <class... Values>
std::string formatted(const char* format, Values... values) {
    char text[400];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

/// The square of the world that a drawing shows.
class Window {
public:
    Window(const HandPair& pair, const ReportView& view) : view_(view) {
        Eigen::AlignedBox2d box;
        for (const auto* path : {&pair.wanted, &pair.reached})
            for (const PathPoint& point : *path)
                box.extend(flat(point.p_m));
        middle_ = box.isEmpty() ? Eigen::Vector2d::Zero() : Eigen::Vector2d(box.center());
        const double extent = box.isEmpty() ? 0.0 : box.sizes().maxCoeff() * 1.15;
        scale_ = (kSize - 2 * kMargin) / std::max(extent, kSmallest_m);
    }
    Eigen::Vector2d flat(const Vector3d& p) const { return {view_.sign * p[view_.across], p[view_.up]}; }
    Eigen::Vector2d onPage(const Eigen::Vector2d& p) const {
        return {kSize / 2 + (p.x() - middle_.x()) * scale_, kSize / 2 - (p.y() - middle_.y()) * scale_};
    }
    std::string grid() const {
        std::string lines;
        const double reach = kSize / 2 / scale_;
        for (int axis = 0; axis < 2; ++axis)
            for (double at = std::ceil((middle_[axis] - reach) / kGrid_m) * kGrid_m;
                 at < middle_[axis] + reach; at += kGrid_m) {
                const Eigen::Vector2d p = onPage({at, at});
                lines += axis == 0 ? formatted("<path d='M%.1f 0V%.0f'/>", p.x(), kSize)
                                   : formatted("<path d='M0 %.1fH%.0f'/>", p.y(), kSize);
            }
        return "<g class='grid'>" + lines + "</g>";
    }
    std::string line(const std::vector<PathPoint>& path, const char* kind) const {
        const size_t stride = std::max<size_t>(1, path.size() / kMostPoints);
        std::string points;
        for (size_t i = 0; i < path.size(); i += stride) {
            const Eigen::Vector2d p = onPage(flat(path[i].p_m));
            points += formatted("%.1f,%.1f ", p.x(), p.y());
        }
        return formatted("<polyline class='%s' points='", kind) + points + "'/>";
    }

private:
    const ReportView& view_;
    Eigen::Vector2d middle_;
    double scale_ = 1;
};

std::string drawing(const HandPair& pair, const ReportView& view) {
    const Window window(pair, view);
    return formatted("<svg viewBox='0 0 %.0f %.0f' role='img' aria-label='%s view'>", kSize, kSize,
                     view.name) +
           window.grid() + window.line(pair.wanted, "wanted") + window.line(pair.reached, "reached") +
           formatted(
               "<text x='6' y='16'>%s</text><text x='%.0f' y='16'>%s</text><text x='%.0f' y='%.0f'>%s</text>",
               view.name, kSize - 14, view.up_name, kSize - 14, kSize - 6, view.across_name) +
           "</svg>";
}

std::string row(const std::string& name, const std::string& value) {
    return "<tr><th>" + text::escaped(name) + "</th><td>" + text::escaped(value) + "</td></tr>";
}

std::string tableOf(const HandPair& pair) {
    const auto tracking = trackingOf(pair.wanted, pair.reached);
    if (!tracking)
        return "<p>The hand moves too little, or was seen too briefly, to tell a delay.</p>";
    return "<table>" + row("Delay", formatted("%.0f ms", 1e3 * tracking->delay_s)) +
           row("Apart at one instant, rms", formatted("%.1f mm", 1e3 * tracking->apart_rms_m)) +
           row("Rest after the delay, rms", formatted("%.1f mm", 1e3 * tracking->rest_rms_m)) +
           row("Rest after the delay, largest", formatted("%.1f mm", 1e3 * tracking->rest_max_m)) +
           row("Points compared", std::to_string(tracking->points)) + "</table>";
}

constexpr const char* kStyle =
    "body{font:15px/1.45 Roboto,sans-serif;max-width:900px;margin:32px auto;padding:0 16px;color:#161b22;"
    "background:#f6f7f9}h1{font-size:24px}h2{font-size:17px;margin-top:28px}svg{width:32%;min-width:240px;"
    "background:#dce1e8;border-radius:4px;margin-right:1%}.grid path{stroke:#c3cad4;stroke-width:1}"
    "polyline{fill:none;stroke-width:1.3}.wanted{stroke:#2b333f;stroke-dasharray:4 3}.reached{stroke:#1e56c9}"
    "text{font-size:12px;fill:#414b58}table{border-collapse:collapse;margin:12px 0}th{text-align:left;"
    "font-weight:400;padding:4px 24px 4px 0;color:#414b58}td{text-align:right}tr{border-bottom:1px solid "
    "#d0d6df}";

}  // namespace

std::string reportHtml(const RobotReport& report) {
    std::string html = "<!DOCTYPE html><html lang='en'><head><meta charset='utf-8'><title>" +
                       text::escaped(report.title) + "</title><style>" + kStyle +
                       "</style></head><body><h1>" + text::escaped(report.title) + "</h1><p>" +
                       text::escaped(report.about) + "</p><p>Dashed: " + text::escaped(report.wanted_name) +
                       ". Line: " + text::escaped(report.reached_name) +
                       ". Axes of the chest: X to the left, Y up, Z ahead. A division is 100 mm.</p>";
    for (const HandPair& pair : report.hands) {
        html += "<h2>Arm " + text::escaped(pair.arm) + "</h2>";
        for (const ReportView& view : kViews)
            html += drawing(pair, view);
        html += tableOf(pair);
    }
    if (!report.facts.empty()) {
        html += "<h2>All joints</h2><table>";
        for (const auto& [name, value] : report.facts)
            html += row(name, value);
        html += "</table>";
    }
    return html + "</body></html>\n";
}

Vector3d tipInChest(const RobotArm& arm, const std::vector<double>& q, size_t first) {
    JointVector values(arm.chain.size());
    for (int i = 0; i < arm.chain.size(); ++i)
        values[i] = q[first + static_cast<size_t>(i)];
    ChainState state;
    arm.chain.forward(values, state);
    return arm.profile.R_base_body.transpose() * state.p_base_tip;
}

Result<std::vector<HandPair>> wristsOf(const MotionClip& clip, const RobotModel& model,
                                       const RobotProfile& profile, const MappingChoice& choice,
                                       const RobotTrajectory& trajectory) {
    const auto performer = PerformerArms::make(clip.skeleton, clip.name);
    if (!performer)
        return performer.error();
    const auto parts = drivenParts(model, profile, choice);
    if (!parts)
        return parts.error();
    std::vector<HandPair> pairs;
    size_t first = 0;
    for (const RobotArm& arm : parts->arms) {
        HandPair pair{arm.profile.name, {}, {}};
        const double scale = arm.length_m / performer->armLength_m(arm.profile.side);
        for (size_t frame = 0; frame < std::min(clip.frames.size(), trajectory.frames.size()); ++frame) {
            const double time_s = static_cast<double>(frame) * clip.frame_time_s;
            const PerformerFrame seen = performer->at(globalPose(clip, frame));
            pair.wanted.push_back(
                {time_s, scale * seen.in_chest[static_cast<size_t>(arm.profile.side)].wrist_m});
            JointVector q(arm.chain.size());
            for (int i = 0; i < arm.chain.size(); ++i)
                q[i] = trajectory.frames[frame][first + static_cast<size_t>(i)];
            ChainState state;
            arm.chain.forward(q, state);
            const RobotArm::Points points = arm.points(state);
            pair.reached.push_back(
                {time_s, arm.profile.R_base_body.transpose() * (points.wrist - points.shoulder)});
        }
        pairs.push_back(std::move(pair));
        first += static_cast<size_t>(arm.chain.size());
    }
    return pairs;
}

}  // namespace noctule::robot
