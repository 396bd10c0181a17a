// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/sound_scenario.h"

#include "core/simulation/random.h"

namespace noctule::simulation {
namespace {

double draw(const Bounds& bounds, uint64_t seed, const char* name, int index) {
    return Random(seed, name, static_cast<uint64_t>(index)).uniform(bounds[0], bounds[1]);
}

double draw(double sigma, uint64_t seed, const char* name, int index) {
    return Random(seed, name, static_cast<uint64_t>(index)).gaussian(sigma);
}

}  // namespace

SoundTruth drawSoundTruth(const SoundScenario& scenario, int source_count, int board_count, uint64_t seed) {
    SoundTruth truth;
    for (int s = 0; s < source_count; ++s)
        truth.sources.push_back(
            {.resonance_hz = draw(scenario.source_resonance_hz, seed, "source resonance", s),
             .q = draw(scenario.source_q, seed, "source q", s),
             .start_delay_s = draw(scenario.source_start_delay_s, seed, "start delay", s),
             .gain_db = draw(scenario.source_gain_db, seed, "source gain", s),
             .ka = draw(scenario.ka, seed, "source ka", s)});
    for (int b = 0; b < board_count; ++b)
        truth.boards.push_back({.gain_db = draw(scenario.board_gain_db, seed, "board gain", b),
                                .mic_delay_s = draw(scenario.board_mic_delay_s, seed, "mic delay", b)});
    return truth;
}

}  // namespace noctule::simulation
