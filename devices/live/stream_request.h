// SPDX-License-Identifier: Apache-2.0
// What is wished of a LiveSession's stream, and what came of it.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/processing/process_take.h"
#include "devices/live/live_processor.h"
#include "devices/live/recorder.h"

namespace noctule {

struct RecordingRequest {
    std::filesystem::path folder;
    std::string name = "take";
    /// In the midst of a stream: it begins so long before `seen_sample`, up to kLongestPreRoll_s.
    double pre_roll_s = 0;
    std::optional<int64_t> seen_sample{};  ///< of that stream; absent: now
    std::string take_kind = "motion";
    std::map<std::string, std::string> meta;  ///< performer, actor_name, ...
    int64_t reserve_bytes = RecorderSettings{}.reserve_bytes;
    bool compress = false;
    /// So long it shall be, where that is known: sound that broke off is marked as missing up to there.
    std::optional<double> length_s{};
};

struct StreamRequest {
    std::optional<RecordingRequest> take;
    std::optional<Suit> suit;  ///< as this performer wears it, matched by serial; else as the box says
    std::optional<Calibration> calibration;
    std::optional<Actor> actor;
    bool process = true;
    bool keep_results = false;  ///< the live results become derived runs of the take
    TrackerSettings tracker;
    /// None: matched where the calibration knows the shape of every source's pulse, else inflection.
    std::optional<Detector> detector{};
    PoseListener pose_listener = {};  ///< of every pose, as soon as it is there
    double rest_s = 0;                ///< the performer begins in the rest pose and holds it so long
    std::string software, created_utc;
};

struct StreamResult {
    std::optional<RecorderState> recording;
    std::shared_ptr<const LiveFrame> frame;  ///< the last one; null without processing
    std::optional<ProcessSummary> results;   ///< in the take
    std::vector<std::string> warnings;       ///< whole sentences
    std::optional<Error> trouble;            ///< of the device; the recorder's own stands in recording
    bool lacks_poses = false;                ///< the live view skipped part of the sound: process the take
};

}  // namespace noctule
