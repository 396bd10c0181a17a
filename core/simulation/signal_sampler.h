// SPDX-License-Identifier: Apache-2.0
// The driver box's converter: sound and digital streams of all boards on one sample clock, rounded to int16
// and clipped at +-32767.
#pragma once

#include "core/inertial/line_shaper.h"
#include "core/simulation/laboratory.h"
#include "core/simulation/sound_synthesizer.h"

namespace noctule::simulation {

class SignalSampler {
public:
    /// `world` must outlive the sampler. `room`: of another sampler of the same, for a quicker beginning.
    SignalSampler(const SuitWorld& world, const Scenario& scenario, const HiddenTruth& truth,
                  const std::optional<Room>& room = {});
    /// Of one of several suits: `heard` is its world with all bodies in it, `others` are the other suits.
    SignalSampler(const SuitWorld& world, const World& heard, const Scenario& scenario,
                  const HiddenTruth& truth, const Room& room, const std::vector<OtherVoice>& others);

    const Room& room() const { return sound_.room(); }

    /// The next `count` samples of all boards, sample-interleaved; valid until the next call.
    std::span<const int16_t> next(int64_t count);

private:
    void addLines(const SuitWorld& world, const Scenario& scenario, const HiddenTruth& truth);

    SoundSynthesizer sound_;
    std::vector<LineShaper> lines_;
    int64_t next_sample_ = 0;
    std::vector<float> mixed_, line_;
    std::vector<int16_t> sampled_;
};

}  // namespace noctule::simulation
