// SPDX-License-Identifier: Apache-2.0
// The converter of one box among several: what its boards hear of all suits, on its own clock.
#pragma once

#include <memory>

#include "core/simulation/cast_world.h"
#include "core/simulation/signal_sampler.h"
#include "core/simulation/suit_rows.h"

namespace noctule::simulation {

class CastSampler {
public:
    CastSampler(const CastSampler&) = delete;
    CastSampler& operator=(const CastSampler&) = delete;
    /// The suits must outlive the object. One of them is `listener`. `first_sample`: of its clock, the one
    /// that next() begins with; negative: before its first pulse.
    CastSampler(const std::vector<StagedSuit>& suits, size_t listener, const Room& chamber,
                int64_t first_sample = 0);

    std::span<const int16_t> next(int64_t count) { return sampler_->next(count); }

private:
    BoxClock clock_;                                      ///< of the listener, from its first sample on
    std::vector<std::unique_ptr<ClockedWorld>> clocked_;  ///< every suit's world on the listener's clock
    std::vector<std::unique_ptr<CastWorld>> heard_;       ///< per suit: its sources, the listener's boards
    std::unique_ptr<SignalSampler> sampler_;
};

}  // namespace noctule::simulation
