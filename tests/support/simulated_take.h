// SPDX-License-Identifier: Apache-2.0
// Takes for tests as the virtual suit would have recorded them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/simulation/simulate.h"
#include "core/suit/default_suit.h"

namespace noctule::test {

struct SimulatedTake {
    MotionClip clip;
    simulation::Level level = simulation::Level::kReadings;  ///< rows at once: quick
    double duration_s = 0;                                   ///< 0: the motion once
    std::optional<double> rest_seconds{};                    ///< none: the scenario's
    simulation::Scenario scenario = simulation::Scenario::nominal();
    uint64_t seed = 1;
    Suit suit = defaultSuit();
};

/// Named as its file.
inline Status writeSimulatedTake(const std::string& path, SimulatedTake wanted, const JobContext& job = {}) {
    simulation::StageRequest request;
    request.suit = std::move(wanted.suit);
    request.clip = std::move(wanted.clip);
    request.scenario = wanted.scenario;
    request.rest_seconds = wanted.rest_seconds;
    request.duration_s = wanted.duration_s;
    request.seed = wanted.seed;
    const auto stage = simulation::prepareStage(request);
    if (!stage)
        return stage.error();
    simulation::TakeRequest take;
    take.out_path = path;
    take.level = wanted.level;
    take.name = std::filesystem::path(path).stem().string();
    take.created_utc = "2026-01-01T00:00:00Z";
    take.software = "test";
    const auto written = simulation::writeTake(*stage, take, job);
    return written ? Status(Done{}) : Status(written.error());
}

}  // namespace noctule::test
