// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/simulation/simulate.h"

namespace noctule::simulation {
namespace {

constexpr double kRestRigSeconds = 10;

Result<Actor> believedActor(const StageRequest& request) {
    if (request.actor)
        return *request.actor;
    if (request.clip)
        return actorFromClip(*request.clip);
    return defaultActor();
}

Status checkTiming(double rest_seconds, const StageRequest& request) {
    if (!(rest_seconds >= 0 && rest_seconds <= 3600))
        return Error{ErrorKind::kUsage,
                     "The rest pose cannot be held for " + std::to_string(rest_seconds) + " s",
                     "Give 0 to 3600 seconds"};
    const bool endless = !(request.duration_s <= 86400);
    if (!(request.duration_s >= 0) || endless)
        return Error{ErrorKind::kUsage, "A take cannot last " + std::to_string(request.duration_s) + " s",
                     "Give at most a day (86400 seconds)"};
    return Done{};
}

}  // namespace

int64_t Stage::sampleCount() const {
    return static_cast<int64_t>(std::floor(world->duration_s() * scenario.sample_rate_hz));
}

Result<Stage> prepareStage(const StageRequest& request) {
    const Scenario& scenario = request.scenario;
    Timing timing{request.rest_seconds.value_or(scenario.rest_seconds), request.duration_s};
    Status sensible = checkTiming(timing.rest_seconds, request);
    if (!sensible)
        return sensible.error();
    Result<Actor> actor = believedActor(request);
    if (!actor)
        return actor.error();

    Stage stage;
    stage.suit = request.suit;
    stage.scenario = scenario;
    stage.actor = *actor;
    stage.mover =
        withScaledBones(scenario.unreduced_motion ? freedActor(*actor) : *actor, scenario, request.seed);
    if (request.clip) {
        Result<FittedMotion> motion =
            fitMotion(*request.clip, {stage.actor, stage.mover.skeleton, scenario.motion_low_pass_hz});
        if (!motion)
            return motion.error();
        stage.motion = std::move(*motion);
    } else {
        timing.duration_s = timing.duration_s > 0 ? timing.duration_s : kRestRigSeconds;
        timing.rest_seconds = timing.duration_s;
    }
    Result<WornSuit> worn = wear(request.suit, stage.mover.skeleton, scenario, request.seed);
    if (!worn)
        return worn.error();

    const Coordinates coordinates(stage.mover.skeleton);
    stage.world = std::make_unique<BodyWorld>(
        Performance(coordinates, heldRestRow(coordinates, stage.mover, scenario, request.seed),
                    request.clip ? &stage.motion : nullptr, timing),
        std::move(*worn), stage.mover.capsules, scenario.soft_tissue);
    stage.truth = drawHiddenTruth(request.suit, scenario, request.seed);
    stage.calibration = laboratoryCalibration(request.suit, scenario, stage.truth);
    return stage;
}

}  // namespace noctule::simulation
