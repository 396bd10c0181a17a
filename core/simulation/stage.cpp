// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/simulation/simulate.h"

namespace noctule::simulation {
namespace {

constexpr double kRestRigSeconds = 10;
constexpr double kShortestStation_s = 0.5, kMostStations = 6;

Result<Actor> believedActor(const StageRequest& request) {
    if (request.actor)
        return *request.actor;
    if (request.clip)
        return actorFromClip(*request.clip, request.joints);
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

void drawTruth(Stage& stage, const StageRequest& request) {
    stage.truth = drawHiddenTruth(request.suit, request.scenario, request.seed);
    stage.calibration = laboratoryCalibration(request.suit, request.scenario, stage.truth);
}

Result<Stage> prepareRig(const StageRequest& request) {
    const RigScenario& rigs = request.scenario.rigs;
    const RigKind kind = *request.rig;
    const double duration_s = request.duration_s > 0 ? request.duration_s : usualDuration_s(kind, rigs);
    const double station_s = stationLength_s(kind, rigs, duration_s);
    if (!request.rig_is_operated && station_s < kShortestStation_s)
        return Error{ErrorKind::kUsage,
                     "A calibration on the " + std::string(nameOf(kind)) + " rig does not fit into " +
                         std::to_string(duration_s) + " s",
                     "Give at least " +
                         std::to_string(static_cast<int>(
                             std::ceil(duration_s + (kShortestStation_s - station_s) * kMostStations))) +
                         " seconds"};
    Stage stage;
    stage.suit = request.suit;
    stage.scenario = request.scenario;
    auto rig = std::make_unique<RigWorld>(kind, request.suit, rigs, request.seed, duration_s);
    if (!request.rig_is_operated)
        stage.stations = runThrough(*rig, rigs, station_s);
    stage.rig = rig.get();
    stage.world = std::move(rig);
    drawTruth(stage, request);
    return stage;
}

}  // namespace

nlohmann::json Stage::truthJson() const {
    nlohmann::json json = toJson(truth, suit, scenario);
    if (body) {
        addWorn(json, body->worn());
        json["actor"] = noctule::toJson(mover);
    }
    if (rig)
        json.update(rig->truthJson(scenario.rigs, suit));
    return json;
}

int64_t Stage::sampleCount() const {
    return static_cast<int64_t>(std::floor(world->duration_s() * scenario.sample_rate_hz));
}

Result<Stage> prepareStage(const StageRequest& request) {
    const Scenario& scenario = request.scenario;
    Timing timing{request.rest_seconds.value_or(scenario.rest_seconds), request.duration_s};
    Status sensible = checkTiming(timing.rest_seconds, request);
    if (!sensible)
        return sensible.error();
    if (request.rig)
        return prepareRig(request);
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
        Result<FittedMotion> motion = fitMotion(
            *request.clip, {stage.actor, stage.mover.skeleton, scenario.motion_low_pass_hz, request.joints});
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
    auto body = std::make_unique<BodyWorld>(
        Performance(coordinates, heldRestRow(coordinates, stage.mover, scenario, request.seed),
                    request.clip ? &stage.motion : nullptr, timing),
        std::move(*worn), stage.mover.capsules, scenario.soft_tissue);
    if (request.comes_back_s > 0)
        body->comeBack(request.comes_back_s);
    stage.body = body.get();
    stage.world = std::move(body);
    drawTruth(stage, request);
    return stage;
}

}  // namespace noctule::simulation
