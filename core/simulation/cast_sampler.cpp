// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/cast_sampler.h"

namespace noctule::simulation {

CastSampler::CastSampler(const std::vector<StagedSuit>& suits, size_t listener, const Room& chamber,
                         int64_t first_sample)
    : clock_(
          suits[listener].clock->startedAt(static_cast<double>(first_sample) / suits[listener].rate_hz())) {
    std::vector<const World*> worlds;
    for (const StagedSuit& suit : suits) {
        clocked_.push_back(std::make_unique<ClockedWorld>(*suit.stage->world, clock_));
        worlds.push_back(clocked_.back().get());
    }
    std::vector<OtherVoice> others;
    for (size_t speaker = 0; speaker < suits.size(); ++speaker) {
        heard_.push_back(std::make_unique<CastWorld>(worlds, speaker, listener));
        if (speaker == listener && first_sample == 0)
            continue;
        const Stage& stage = *suits[speaker].stage;
        const auto drive_s = [suit = suits[speaker], this](int64_t sample) {
            return clock_.suitTime_s(suit.takeTimeOf_s(static_cast<double>(sample)));
        };
        others.push_back({heard_.back().get(), stage.scenario.sound, stage.scenario.schedule(),
                          stage.truth.sound, drive_s});
    }
    const Stage& stage = *suits[listener].stage;
    Scenario scenario = stage.scenario;
    if (first_sample != 0)  // its own pulses do not begin at sample 0 either
        scenario.enabled_sources = std::vector<int>{};
    sampler_ = std::make_unique<SignalSampler>(*clocked_[listener], *heard_[listener], scenario, stage.truth,
                                               chamber, others);
}

}  // namespace noctule::simulation
