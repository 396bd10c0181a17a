// SPDX-License-Identifier: Apache-2.0
// A take made before as a box's sound: the same samples, pulses, holes and measurements. Read ahead a little
// at a time: what plays and what listens to it need the processor as well.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/virtual_suit/sound_source.h"

namespace noctule::virtual_suit {

/// `subject`: whose box, in a take of several suits (`room`: that of its anchors); empty: the first. `loop`:
/// after the end it begins again, or where the take says (kLoopsFromKey), with the sample clock going on.
/// `start_ns`: instant (nowNs()) at which the take begins, the same for the boxes of all its suits: a restart
/// falls into its midst, before it comes silence, and rounds are equally long for all. Absent: each restart
/// begins with the take. Fails (kUnusable) when the take holds no sound.
Result<SoundOfSuit> openTakeSource(const std::string& path, const std::string& subject, bool loop,
                                   std::optional<int64_t> start_ns = {});

}  // namespace noctule::virtual_suit
