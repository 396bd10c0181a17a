// SPDX-License-Identifier: Apache-2.0
#include "app/batch/devices/record_report.h"

#include <cstdio>

namespace noctule::batch {

nlohmann::json recordingJson(const RecordReport& report) {
    const RecorderState& recording = *report.stream.recording;
    nlohmann::json json{
        {"take", recording.path},
        {"samples", recording.samples},
        {"seconds", static_cast<double>(recording.samples) / report.sample_rate_hz},
        {"lost_samples", recording.lost_samples},
        {"gaps", recording.gaps},
        {"interrupted", report.interrupted},
        {"commits", recording.commits},
        {"slowest_commit_ms", static_cast<double>(recording.slowest_commit_ns) * 1e-6},
        {"deepest_queue_s", static_cast<double>(recording.queue.deepest_samples) / report.sample_rate_hz},
        {"reconnections", report.link.reconnections},
        {"lacks_poses", report.stream.lacks_poses},
        {"warnings", report.stream.warnings}};
    if (const auto& frame = report.stream.frame)
        json["live"] = {{"poses", frame->poses},
                        {"latency_median_ms", 1e3 * frame->latency_median_s},
                        {"latency_p999_ms", 1e3 * frame->latency_p999_s},
                        {"latency_worst_ms", 1e3 * frame->latency_worst_s},
                        {"dropped_samples", frame->queue.dropped_samples}};
    if (const auto& results = report.stream.results)
        json["run"] = results->run_name;
    return json;
}

std::string recordingText(const RecordReport& report) {
    const RecorderState& recording = *report.stream.recording;
    char text[240];
    std::snprintf(text, sizeof text, ": %.2f s, %lld samples missing in %lld gaps; slowest commit %.0f ms\n",
                  static_cast<double>(recording.samples) / report.sample_rate_hz,
                  static_cast<long long>(recording.lost_samples), static_cast<long long>(recording.gaps),
                  static_cast<double>(recording.slowest_commit_ns) * 1e-6);
    std::string all = recording.path + text;
    if (const auto& frame = report.stream.frame) {
        std::snprintf(text, sizeof text, "live: %lld poses, %.1f ms late in the median, %.1f ms at 99.9 %%\n",
                      static_cast<long long>(frame->poses), 1e3 * frame->latency_median_s,
                      1e3 * frame->latency_p999_s);
        all += text;
    }
    return all;
}

}  // namespace noctule::batch
