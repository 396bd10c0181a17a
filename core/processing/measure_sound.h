// SPDX-License-Identifier: Apache-2.0
// The sound of a take with several suits, measured: readings and ranges of every suit, own ones and those
// between suits. The result is a take of level readings that knows the same suits; estimation goes on from
// there as it does for any such take. Pulses of different suits are told apart by their carriers
// (several-suits.md, section 3).
#pragma once

#include <string>
#include <vector>

#include "core/job/job.h"
#include "core/processing/ingredients.h"
#include "core/recording/take.h"

namespace noctule {

/// One suit whose sound is measured: a subject's, or the room's.
struct SoundOfSuit {
    int suit = kSuitInView;  ///< as rows of the take count it
    Suit described;
    Calibration calibration;
    DecoderSettings decoder;
    std::vector<Vector3d> source_places_m, board_places_m;  ///< of a standing body, or in the room
    bool is_room = false;
};

/// Written into `folder` and removed from it at once: the take lives as long as the object. Pulses keep their
/// ids, and ranges between suits are by the recorder's guess of the clocks, as in a take that was recorded as
/// readings. Adds whole sentences to `warnings`.
Result<Take> measureSound(Take& take, std::vector<SoundOfSuit> suits, const std::string& folder,
                          std::vector<std::string>& warnings, const JobContext& job);

}  // namespace noctule
