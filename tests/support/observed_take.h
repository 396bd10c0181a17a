// SPDX-License-Identifier: Apache-2.0
// Simulated takes as the solvers of calibration read them, through a take file; with what they do not see.
#pragma once

#include "core/processing/calibration_observations.h"
#include "core/simulation/simulate.h"
#include "core/suit/default_suit.h"
#include "tests/support/files.h"

namespace noctule::test {

struct ObservedTake {
    simulation::Stage stage;  ///< the truth: for tests alone
    Observations observations;
};

/// The whole default suit, nominal scenario, at the level of readings unless the request says otherwise.
inline simulation::StageRequest stageOf(std::optional<simulation::RigKind> rig, uint64_t seed = 1) {
    simulation::StageRequest request;
    request.suit = defaultSuit();
    request.scenario = simulation::Scenario::nominal();
    request.rig = rig;
    request.seed = seed;
    return request;
}

inline Result<ObservedTake> observe(const simulation::StageRequest& request,
                                    simulation::Level level = simulation::Level::kReadings) {
    auto stage = simulation::prepareStage(request);
    if (!stage)
        return stage.error();
    const Folder folder;
    simulation::TakeRequest take;
    take.out_path = folder.file("observed_001.noctule");
    take.level = level;
    take.name = "observed_001";
    take.created_utc = "2026-01-01T00:00:00Z";
    take.software = "test";
    if (const auto written = simulation::writeTake(*stage, take, {}); !written)
        return written.error();
    const auto opened = Take::open(take.out_path);
    if (!opened)
        return opened.error();
    auto observations = readObservations(*opened, Detector::kInflection, {});
    if (!observations)
        return observations.error();
    return ObservedTake{std::move(*stage), std::move(*observations)};
}

}  // namespace noctule::test
