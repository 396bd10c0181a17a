// SPDX-License-Identifier: Apache-2.0
// The main job: a take in, joint angles out, written into the take as derived runs. The same code as live:
// the take's data are pushed through the live pipeline.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/acoustics/pulse_detector.h"
#include "core/estimation/measurement.h"
#include "core/job/job.h"
#include "core/live/motion_tracker.h"
#include "core/recording/take.h"
#include "core/suit/calibration_lack.h"

namespace noctule {

/// kAuto: where it can be done; what is in the way is a warning. kOn: it is an error.
enum class Wanted { kAuto, kOn, kOff };

struct ProcessRequest {
    std::string take_path;
    std::optional<Calibration> calibration;  ///< else the one in force in the take; becomes the one in force
    std::optional<Actor> actor;              ///< likewise
    TrackerSettings tracker;                 ///< sensors, root, estimator
    std::optional<Detector> detector{};      ///< none: the estimator's own (EstimatorEntry::detector)
    std::vector<std::string> subjects;       ///< by name; empty: all
    Wanted between = Wanted::kAuto;          ///< ranges between subjects
    Wanted room = Wanted::kAuto;             ///< ranges to and from anchors in the room
    double select = 1;                       ///< share of those ranges, most informative first
    std::string run_name;                    ///< empty: defaultRunName()
    std::string software;                    ///< goes into the runs' rows
    std::string created_utc;
};

struct ProcessSummary {
    std::string run_name;
    int64_t pose_run = 0, range_run = 0, inertial_run = 0;  ///< 0: primary data or none
    int64_t poses = 0;
    double duration_s = 0;
    RangeTally ranges;
    int64_t frames_seen = 0, frames_lost = 0, clipped_readings = 0;
    int resets = 0;
    int64_t contacts = 0;               ///< of all feet
    bool contacts_edited = false;       ///< an operator's, instead of those in the readings
    CalibrationLack lack;               ///< of the calibration it was made with
    Grade calibrated = Grade::kGood;    ///< what that makes of the run; kNotUsable: the poses mean nothing
    std::vector<std::string> warnings;  ///< whole sentences
    struct Subject {
        std::string name;
        int suit = 0;  ///< counts from 1
        int64_t poses = 0;
        RangeTally ranges;
    };
    std::vector<Subject> subjects;  ///< in the order of the take
    /// Ranges between suits, where subjects were estimated together.
    struct Together {
        bool between = false, room = false;
        RangeTally ranges;
        std::vector<int> unjoined;  ///< suits whose wearers could not be placed against the others
    };
    std::optional<Together> together;
};

/// What a run is called when no name is given: "AGD", "G paper", "AGD lag", "AGD smoothed", "AGD batch".
std::string defaultRunName(const TrackerSettings& tracker);

/// Everything or nothing: failed or cancelled, the take stays as it was.
Result<ProcessSummary> processTake(const ProcessRequest& request, const JobContext& job);

}  // namespace noctule
