// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/sound_click.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace noctule::simulation {
namespace {

ToneSum drawTones(Random& random) {
    const double amplitude_counts = 100 * std::pow(30.0, random.uniform());
    ToneSum tones;
    for (int i = 0; i < 3; ++i) {
        const double frequency_hz = random.uniform(30000, 50000);
        const double decay_s = random.uniform(5e-5, 4e-4);
        const double phase_rad = random.uniform(0, 2 * std::numbers::pi);
        tones.push_back({0,
                         std::numeric_limits<double>::infinity(),
                         std::polar(amplitude_counts / 3, phase_rad),
                         {-1 / decay_s, 2 * std::numbers::pi * frequency_hz}});
    }
    return tones;
}

}  // namespace

ClickProcess::ClickProcess(double clicks_per_s, uint64_t seed)
    : seed_(seed), clicks_per_s_(clicks_per_s), waiting_(seed, "click times") {
    if (clicks_per_s_ > 0)
        next_s_ = waiting_.exponential() / clicks_per_s_;
}

std::optional<Click> ClickProcess::nextBefore(double t_s) {
    if (clicks_per_s_ <= 0 || next_s_ >= t_s)
        return std::nullopt;
    Random random(seed_, "click", index_++);
    // Drawn one by one: compilers evaluate operands in different orders.
    const double distance_m = random.uniform(0.5, 3);
    const Vector3d direction = random.direction();
    Click click{next_s_, distance_m * direction, drawTones(random)};
    next_s_ += waiting_.exponential() / clicks_per_s_;
    return click;
}

}  // namespace noctule::simulation
