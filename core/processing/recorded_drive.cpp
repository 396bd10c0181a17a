// SPDX-License-Identifier: Apache-2.0
#include "core/processing/recorded_drive.h"

#include <algorithm>
#include <cmath>

#include "core/math/json.h"
#include "core/robot/drive_csv.h"

namespace noctule {
namespace {

/// More points of an achieved path do not tell a delay better.
constexpr size_t kMostCompared = 20'000;
constexpr const char* kFollowing = "following";

double secondsOf(int64_t time_ns) {
    return static_cast<double>(time_ns) * 1e-9;
}

std::optional<double> secondsOf(const std::optional<int64_t>& time_ns) {
    return time_ns ? std::optional(secondsOf(*time_ns)) : std::nullopt;
}

std::vector<robot::PathPoint> thinned(const std::vector<robot::PathPoint>& path) {
    const size_t stride = path.size() / kMostCompared + 1;
    std::vector<robot::PathPoint> few;
    for (size_t i = 0; i < path.size(); i += stride)
        few.push_back(path[i]);
    return few;
}

/// Of the first command after each new pose.
std::optional<double> medianDelay_ms(const std::vector<RobotCommandRow>& commands) {
    std::vector<double> delays;
    std::optional<int64_t> last;
    for (const RobotCommandRow& command : commands) {
        if (command.pose_arrived_ns && command.pose_arrived_ns != last)
            delays.push_back(static_cast<double>(command.time_ns - *command.pose_arrived_ns) * 1e-6);
        last = command.pose_arrived_ns;
    }
    if (delays.empty())
        return std::nullopt;
    std::nth_element(delays.begin(), delays.begin() + std::ssize(delays) / 2, delays.end());
    return delays[delays.size() / 2];
}

std::string textOf(const char* form, double value) {
    char text[80];
    std::snprintf(text, sizeof text, form, value);
    return text;
}

nlohmann::json trackingJson(const robot::Tracking& tracking) {
    return {{"delay_ms", 1e3 * tracking.delay_s},
            {"apart_rms_mm", 1e3 * tracking.apart_rms_m},
            {"rest_rms_mm", 1e3 * tracking.rest_rms_m},
            {"rest_max_mm", 1e3 * tracking.rest_max_m},
            {"points", tracking.points}};
}

}  // namespace

Result<RecordedDrive> readRecordedDrive(const Take& take, int64_t drive) {
    const auto drives = take.robotDrives();
    if (!drives)
        return drives.error();
    const auto found = drive == 0 ? (drives->empty() ? drives->end() : drives->end() - 1)
                                  : std::ranges::find(*drives, drive, &RobotDriveRow::drive);
    if (found == drives->end())
        return Error{ErrorKind::kUnusable,
                     take.path() + (drive == 0 ? std::string(": no drive of a robot is recorded in it")
                                               : ": it has no drive " + std::to_string(drive)),
                     "Record one with `noctule --batch drive --record`, or name one that `inspect` lists"};
    auto commands = take.robotCommands(*found);
    if (!commands)
        return commands.error();
    auto states = take.robotStates(*found);
    if (!states)
        return states.error();
    return RecordedDrive{*found, std::move(*commands), std::move(*states)};
}

std::vector<robot::HandPair> handsOf(const RecordedDrive& drive) {
    std::vector<robot::HandPair> hands;
    for (size_t arm = 0; arm < drive.about.arms.size(); ++arm) {
        robot::HandPair hand{drive.about.arms[arm], {}, {}};
        for (const RobotCommandRow& command : drive.commands)
            hand.wanted.push_back({secondsOf(command.time_ns), command.tips_m[arm]});
        for (const RobotStateRow& state : drive.states)
            hand.reached.push_back({secondsOf(state.time_ns), state.tips_m[arm]});
        hands.push_back(std::move(hand));
    }
    return hands;
}

DriveSummary summaryOf(const RecordedDrive& drive) {
    DriveSummary summary;
    summary.about = drive.about;
    summary.commands = std::ssize(drive.commands);
    summary.states = std::ssize(drive.states);
    summary.following = std::ranges::count(drive.commands, kFollowing, &RobotCommandRow::state);
    if (!drive.commands.empty()) {
        const RobotCommandRow &first = drive.commands.front(), &last = drive.commands.back();
        summary.missing = last.sequence - first.sequence + 1 - summary.commands;
        summary.duration_s = secondsOf(last.time_ns - first.time_ns);
    }
    summary.pose_to_command_ms = medianDelay_ms(drive.commands);
    for (const robot::HandPair& hand : handsOf(drive))
        summary.tracking.push_back(robot::trackingOf(hand.wanted, thinned(hand.reached)));
    return summary;
}

nlohmann::json toJson(const DriveSummary& summary) {
    const RobotDriveRow& about = summary.about;
    nlohmann::json hands = nlohmann::json::array();
    for (size_t arm = 0; arm < about.arms.size(); ++arm) {
        nlohmann::json hand{{"arm", about.arms[arm]}, {"tracking", nullptr}};
        if (const auto& tracking = summary.tracking[arm])
            hand["tracking"] = trackingJson(*tracking);
        hands.push_back(std::move(hand));
    }
    return {{"drive", about.drive},
            {"created_utc", about.created_utc},
            {"robot", about.robot},
            {"address", about.address},
            {"leader", about.leader},
            {"rate_hz", about.rate_hz},
            {"joints", about.joints},
            {"take_time_s", json::orNull(secondsOf(about.take_time_ns))},
            {"duration_s", summary.duration_s},
            {"commands", summary.commands},
            {"commands_following", summary.following},
            {"commands_missing", summary.missing},
            {"states", summary.states},
            {"lost_rows", about.lost_rows},
            {"pose_to_command_median_ms", json::orNull(summary.pose_to_command_ms)},
            {"hands", std::move(hands)}};
}

std::string summaryText(const DriveSummary& summary) {
    const RobotDriveRow& about = summary.about;
    std::string text = about.robot + " led by the " + about.leader + ", " +
                       textOf("%.1f s", summary.duration_s) + ": " + std::to_string(summary.commands) +
                       " commands, " + std::to_string(summary.following) + " following, " +
                       std::to_string(summary.states) + " states";
    if (about.lost_rows > 0)
        text += ", " + std::to_string(about.lost_rows) + " could not be written";
    for (size_t arm = 0; arm < about.arms.size(); ++arm)
        if (const auto& tracking = summary.tracking[arm])
            text += "; arm " + about.arms[arm] + textOf(" %.0f ms later", 1e3 * tracking->delay_s) +
                    textOf(", rest %.1f mm", 1e3 * tracking->rest_rms_m);
    return text;
}

std::string driveCsv(const RecordedDrive& drive) {
    std::string text = robot::driveCsvHead(drive.about.joints);
    size_t next = 0;
    for (const RobotCommandRow& command : drive.commands) {
        while (next < drive.states.size() && drive.states[next].time_ns <= command.time_ns)
            ++next;
        robot::DriveCsvRow row{.time_s = secondsOf(command.time_ns),
                               .pose_arrived_s = secondsOf(command.pose_arrived_ns),
                               .pose_time_s = secondsOf(command.pose_time_ns),
                               .sequence = command.sequence,
                               .state = command.state,
                               .trouble = command.trouble,
                               .command = command.q};
        if (next > 0) {
            const RobotStateRow& state = drive.states[next - 1];
            row.robot_arrived_s = secondsOf(state.time_ns);
            row.robot_sequence = state.obeyed_sequence;
            row.actual = &state.q;
        }
        robot::appendDriveCsv(row, text);
    }
    return text;
}

nlohmann::json driveTrajectory(const RecordedDrive& drive) {
    const auto& commands = drive.commands;
    nlohmann::json points = nlohmann::json::array();
    for (size_t i = 0; i < commands.size(); ++i) {
        std::vector<double> speeds(drive.about.joints.size(), 0);
        if (i > 0 && i + 1 < commands.size()) {
            const double span_s = secondsOf(commands[i + 1].time_ns - commands[i - 1].time_ns);
            for (size_t j = 0; j < speeds.size() && span_s > 0; ++j)
                speeds[j] = (commands[i + 1].q[j] - commands[i - 1].q[j]) / span_s;
        }
        const int64_t time_ns = commands[i].time_ns - commands.front().time_ns;
        points.push_back(
            {{"positions", commands[i].q},
             {"velocities", speeds},
             {"time_from_start", {{"secs", time_ns / 1'000'000'000}, {"nsecs", time_ns % 1'000'000'000}}}});
    }
    return {{"joint_names", drive.about.joints}, {"points", std::move(points)}};
}

std::string driveReportHtml(const RecordedDrive& drive) {
    const DriveSummary summary = summaryOf(drive);
    robot::RobotReport page{"Robot " + drive.about.robot + ", led by the " + drive.about.leader,
                            "Recorded in a take; times are those at which commands were made and states "
                            "arrived.",
                            "the hand as it was commanded",
                            "the hand as the robot tells it",
                            handsOf(drive),
                            {{"Commands", std::to_string(summary.commands)},
                             {"Commands while following", std::to_string(summary.following)},
                             {"States of the robot", std::to_string(summary.states)}}};
    if (summary.pose_to_command_ms)
        page.facts.emplace_back("Data to command, median", textOf("%.1f ms", *summary.pose_to_command_ms));
    if (drive.about.lost_rows > 0)
        page.facts.emplace_back("Rows that could not be written", std::to_string(drive.about.lost_rows));
    return robot::reportHtml(page);
}

}  // namespace noctule
