// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/signal_sampler.h"

#include <algorithm>
#include <cmath>

namespace noctule::simulation {

SignalSampler::SignalSampler(const SuitWorld& world, const Scenario& scenario, const HiddenTruth& truth,
                             const std::optional<Room>& room)
    : sound_(world, scenario.sound,
             {static_cast<double>(scenario.sample_rate_hz), truth.air.speedOfSound_m_per_s(),
              scenario.schedule()},
             truth.seed, room) {
    addLines(world, scenario, truth);
}

SignalSampler::SignalSampler(const SuitWorld& world, const World& heard, const Scenario& scenario,
                             const HiddenTruth& truth, const Room& room,
                             const std::vector<OtherVoice>& others)
    : sound_(heard, scenario.sound,
             {static_cast<double>(scenario.sample_rate_hz), truth.air.speedOfSound_m_per_s(),
              scenario.schedule()},
             truth.seed, room) {
    for (const OtherVoice& other : others)
        sound_.add(other);
    addLines(world, scenario, truth);
}

void SignalSampler::addLines(const SuitWorld& world, const Scenario& scenario, const HiddenTruth& truth) {
    for (int b = 0; b < world.boardCount(); ++b) {
        const InertialTruth& inertia = truth.inertia[b];
        auto stream = std::make_shared<BoardStream>(world, b, inertia, scenario.sample_rate_hz, truth.seed);
        lines_.emplace_back(scenario.sample_rate_hz, inertia.phase_samples, scenario.stream_amplitude_counts,
                            [stream, counter = 0, next = BoardStream::kFirstFrame](int64_t frame) mutable {
                                LineBits bits{};
                                for (; next <= frame; ++next)
                                    bits = stream->next(counter);
                                return std::optional<LineBits>(bits);
                            });
    }
}

std::span<const int16_t> SignalSampler::next(int64_t count) {
    const size_t boards = lines_.size(), samples = static_cast<size_t>(count);
    mixed_.assign(samples * boards, 0.0F);
    sound_.render(next_sample_, count, mixed_.data());
    line_.resize(samples);
    sampled_.resize(samples * boards);
    for (size_t b = 0; b < boards; ++b) {
        std::fill(line_.begin(), line_.end(), 0.0F);
        lines_[b].addTo(line_);
        for (size_t i = 0; i < samples; ++i) {
            const float value = std::clamp(mixed_[i * boards + b] + line_[i], -32767.0F, 32767.0F);
            sampled_[i * boards + b] = static_cast<int16_t>(std::lrintf(value));
        }
    }
    next_sample_ += count;
    return sampled_;
}

}  // namespace noctule::simulation
