// SPDX-License-Identifier: Apache-2.0
#include "app/batch/devices/drive_outcome.h"

#include <cstdio>

namespace noctule::batch {
namespace {

constexpr double kSilentAtEnd_s = 1;  ///< a state that only comes late is not missed

nlohmann::json handsJson(const std::vector<robot::HandPair>& hands) {
    nlohmann::json all = nlohmann::json::array();
    for (const robot::HandPair& hand : hands) {
        nlohmann::json one{{"arm", hand.arm}, {"tracking", nullptr}};
        if (const auto tracking = robot::trackingOf(hand.wanted, hand.reached))
            one["tracking"] = {{"delay_ms", 1e3 * tracking->delay_s},
                               {"apart_rms_mm", 1e3 * tracking->apart_rms_m},
                               {"rest_rms_mm", 1e3 * tracking->rest_rms_m},
                               {"rest_max_mm", 1e3 * tracking->rest_max_m},
                               {"points", tracking->points}};
        all.push_back(std::move(one));
    }
    return all;
}

}  // namespace

void HandRecord::add(const robot_link::DriveMoment& moment) {
    const auto seconds = [&](int64_t steady_ns) {
        return static_cast<double>(steady_ns - moment.start_ns) * 1e-9;
    };
    const bool has_news = moment.link.state && moment.link.state_arrived_ns != last_state_ns_;
    size_t first = 0;
    for (size_t i = 0; i < arms_.size() && hands_[i].wanted.size() < kMostPoints; ++i) {
        hands_[i].wanted.push_back(
            {seconds(moment.now_ns), robot::tipInChest(arms_[i], moment.output.q, first)});
        if (has_news)
            hands_[i].reached.push_back({seconds(moment.link.state_arrived_ns),
                                         robot::tipInChest(arms_[i], moment.link.state->q, first)});
        first += static_cast<size_t>(arms_[i].chain.size());
    }
    if (has_news)
        last_state_ns_ = moment.link.state_arrived_ns;
}

std::optional<Error> robotTrouble(const robot_link::DriveReport& report, const std::string& address) {
    if (report.link.trouble || report.silent_s < kSilentAtEnd_s)
        return report.link.trouble;
    char silence[40];
    std::snprintf(silence, sizeof silence, "%.1f s before the end", report.silent_s);
    return Error{ErrorKind::kDevice, address + ": the robot fell silent " + silence,
                 "Check its program and the network"};
}

nlohmann::json driveJson(const robot_link::DriveReport& report, const RobotDriveRow& drive,
                         const std::vector<robot::HandPair>& hands) {
    const LatencyHistogram& latency = report.link.latency;
    nlohmann::json json{{"robot", drive.robot},
                        {"to", drive.address},
                        {"joints", drive.joints},
                        {"commands", report.commands},
                        {"commands_following", report.following},
                        {"steps_skipped", report.skipped},
                        {"commands_dropped", report.link.dropped},
                        {"states", report.link.states},
                        {"messages_refused", report.link.refused_messages},
                        {"reconnections", report.link.reconnections},
                        {"silent_at_end_s", report.silent_s},
                        {"largest_speed_use", report.largest_speed_use},
                        {"longest_hold_ms", 1e3 * report.longest_hold_s}};
    json["latency"] = {{"count", latency.count()},
                       {"median_ms", 1e3 * latency.quantile_s(0.5)},
                       {"p999_ms", 1e3 * latency.quantile_s(0.999)},
                       {"worst_ms", static_cast<double>(latency.worst_ns()) * 1e-6}};
    json["hands"] = handsJson(hands);
    return json;
}

std::string driveText(const robot_link::DriveReport& report, const RobotDriveRow& drive) {
    const LatencyHistogram& latency = report.link.latency;
    char text[300];
    std::snprintf(text, sizeof text,
                  ": %lld commands, %lld while following; from the arrival of data to the command %.1f ms in "
                  "the median, %.1f ms at 99.9 %%\n",
                  static_cast<long long>(report.commands), static_cast<long long>(report.following),
                  1e3 * latency.quantile_s(0.5), 1e3 * latency.quantile_s(0.999));
    return "robot " + drive.robot + text;
}

std::string driveHtml(const robot_link::DriveReport& report, const RobotDriveRow& drive,
                      const std::vector<robot::HandPair>& hands) {
    const LatencyHistogram& latency = report.link.latency;
    char quantiles[100];
    std::snprintf(quantiles, sizeof quantiles, "%.1f ms, %.1f ms", 1e3 * latency.quantile_s(0.5),
                  1e3 * latency.quantile_s(0.999));
    const robot::RobotReport page{"Robot " + drive.robot + ", driven live",
                                  "Times are those at which commands were made and states arrived.",
                                  "the hand as it was commanded",
                                  "the hand as the robot tells it",
                                  hands,
                                  {{"Commands", std::to_string(report.commands)},
                                   {"Commands while following", std::to_string(report.following)},
                                   {"Data to command: median, 99.9 %", quantiles}}};
    return robot::reportHtml(page);
}

}  // namespace noctule::batch
