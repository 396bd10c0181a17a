// SPDX-License-Identifier: Apache-2.0
// Impulsive noise: keys, zips, claps, a hard shoe. A Poisson process of short broadband sounds, each from a
// point 0.5 to 3 m away, each three damped tones between 30 and 50 kHz (decay 0.05 to 0.4 ms, sudden onset),
// with an amplitude of 100 to 3000 counts at 1 m, evenly in its logarithm. Every board hears it after its own
// delay.
#pragma once

#include <cstdint>
#include <optional>

#include "core/simulation/random.h"
#include "core/simulation/sound_tone.h"

namespace noctule::simulation {

struct Click {
    double t_s = 0;
    Vector3d from_middle_m;  ///< position relative to the middle of the suit
    ToneSum tones;           ///< in counts at 1 m
};

/// The clicks of a take, one after the other.
class ClickProcess {
public:
    ClickProcess(double clicks_per_s, uint64_t seed);
    /// The next click if it begins before t; the caller asks until there is none.
    std::optional<Click> nextBefore(double t_s);

private:
    uint64_t seed_;
    double clicks_per_s_;
    Random waiting_;
    double next_s_ = 0;
    uint64_t index_ = 0;
};

}  // namespace noctule::simulation
