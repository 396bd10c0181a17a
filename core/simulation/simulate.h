// SPDX-License-Identifier: Apache-2.0
// A whole simulated take: a motion in, a take file out. The same request gives the same file on every machine
// up to the last bits of the mathematical library.
#pragma once

#include <memory>

#include "core/job/job.h"
#include "core/motion/clip.h"
#include "core/simulation/body_world.h"
#include "core/simulation/laboratory.h"
#include "core/simulation/motion_fit.h"
#include "core/simulation/rig_world.h"

namespace noctule::simulation {

struct StageRequest {
    std::optional<MotionClip> clip;  ///< none: the performer stands in the rest pose (rig `rest`)
    std::optional<Actor> actor;      ///< none: the default actor with the clip's measures
    Suit suit;
    Scenario scenario;
    std::optional<double> rest_seconds;  ///< none: the scenario's
    double duration_s = 0;               ///< of the whole take; 0: the motion once; a longer one repeats it
    double comes_back_s = 0;             ///< > 0: all of it is gone through to and fro for so long
    uint64_t seed = 1;
    std::optional<RigKind> rig{};  ///< the suit is not worn, it is on a rig: without clip and actor
    bool rig_is_operated = false;  ///< by hand while time goes on; else it runs through a whole calibration
    std::optional<figure::JointMapping> joints{};  ///< which of the clip's is which; none: found here
};

/// Performer, suit and all hidden draws, before anything is sampled. The virtual suit starts here too.
struct Stage {
    Suit suit;
    Scenario scenario;
    Actor actor;  ///< whom the studio believes in
    Actor mover;  ///< who really moves: in realistic other bones, and every joint free
    std::unique_ptr<SuitWorld> world;
    BodyWorld* body = nullptr;  ///< the world when the suit is worn
    RigWorld* rig = nullptr;    ///< the world when it is on a rig
    std::vector<RigStation> stations;
    HiddenTruth truth;
    Calibration calibration;  ///< what a laboratory would know
    FittedMotion motion;      ///< quality of the fit; no rows without a clip

    int64_t sampleCount() const;
    nlohmann::json truthJson() const;
};
Result<Stage> prepareStage(const StageRequest& request);

struct TakeRequest {
    std::string out_path{};
    Level level = Level::kSignal;
    bool overwrite = false;
    bool external_root = true;
    bool compress = false;
    std::string name{}, created_utc{}, software{};  ///< for the take's header; created_utc is ISO 8601 with Z
};

struct SimulationSummary {
    double duration_s = 0;
    int64_t samples = 0, pulses = 0, inertial_rows = 0, range_rows = 0;
};

/// Writes aside and renames; cancelled or failed, nothing is left.
Result<SimulationSummary> writeTake(const Stage& stage, const TakeRequest& request, const JobContext& job);

}  // namespace noctule::simulation
