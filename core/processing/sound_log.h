// SPDX-License-Identifier: Apache-2.0
// What a take holds beside its sound, and what decoding needs of it.
#pragma once

#include <vector>

#include "core/acoustics/speed_of_sound.h"
#include "core/recording/take.h"

namespace noctule {

struct SoundLog {
    std::vector<Pulse> pulses;
    std::vector<TemperatureStatus> statuses;
    std::vector<GapRow> gaps;
};

Result<SoundLog> readSoundLog(const Take& take);

}  // namespace noctule
