// SPDX-License-Identifier: Apache-2.0
// A matched detector needs the shape of every source's pulse. A calibration made with it holds them; where it
// does not, they are learnt from the take's own sound.
#pragma once

#include "core/job/job.h"
#include "core/processing/ingredients.h"
#include "core/processing/sound_log.h"

namespace noctule {

/// Adds to the calibration of `in` what its detector needs and the take can tell, and says so in `warnings`:
/// shapes that were learnt, offsets that had to be derived from another detector's. Reads up to 20 s of
/// sound, and nothing when nothing is missing.
Status completeShapes(const Take& take, const SoundLog& log, Ingredients& in,
                      std::vector<std::string>& warnings, const JobContext& job);

}  // namespace noctule
