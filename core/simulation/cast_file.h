// SPDX-License-Identifier: Apache-2.0
// A cast as its JSON describes it: who is in the room, by which files. Nothing but the description is read
// here. Optional members take the defaults below; unknown ones are ignored.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/job/result.h"
#include "core/motion/clip.h"
#include "core/simulation/performance.h"

namespace noctule::simulation {

/// Paths are as they stand in the file; empty: not given.
struct CastFileSubject {
    std::string name, motion, suit, actor;
    std::optional<StandingPlace> place;
    double start_s = 0, motion_scale = 1;
    std::optional<double> motion_rate_hz, carrier_hz;
    std::optional<int> pulse_interval_samples;
    int motion_skip = 0;  ///< first frames that are left out
};

struct CastFile {
    std::vector<CastFileSubject> subjects;
    std::string room;
    bool shared_clock = false;
    std::vector<std::string> warnings;  ///< what it asks for and is not simulated
};

/// `where` names the file in errors. Subjects without a name are called A, B, C and so on. kUnreadable and
/// kUnusable name the subject and the member.
Result<CastFile> castFromJson(const nlohmann::json& json, const std::string& where);

/// The motion as the cast wants it: first frames left out, another rate, another size. kUnusable when no
/// frame is left.
Result<MotionClip> adjustedMotion(MotionClip clip, const CastFileSubject& subject);

}  // namespace noctule::simulation
