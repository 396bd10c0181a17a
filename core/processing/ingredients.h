// SPDX-License-Identifier: Apache-2.0
// What processing needs of a take, read and checked before the long work begins.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/live/suit_decoder.h"
#include "core/processing/process_take.h"
#include "core/suit/calibration_lack.h"

namespace noctule {

struct Ingredients {
    Suit suit;
    Calibration calibration;
    CalibrationLack lack;  ///< of it
    Actor actor;
    std::optional<int64_t> calibration_id, actor_id;
    DecoderSettings decoder;
    std::optional<std::pair<int64_t, int64_t>> rest;
    int64_t first_sample = 0;  ///< of the readings, where it is wanted
    /// For a tracker: where nothing is marked, the motion begins with the first reading, not hours before it.
    std::optional<std::pair<int64_t, int64_t>> restOrBegin() const {
        const bool is_late = !rest && static_cast<double>(first_sample) > decoder.train.sample_rate_hz;
        return is_late ? std::pair(first_sample, first_sample) : rest;
    }
    std::vector<ExternalRootRow> roots;
    std::optional<std::vector<FootContacts>> contacts;  ///< as an operator has set them
    int64_t sample_count = 0;
    TakeSubject subject{"", {1}, false};
    SuitClock clock;  ///< poses are written on take time
};

/// Of the suit in view. Fails when the take cannot be processed as asked (its suit and sound contradict each
/// other, the calibration is another suit's, the root is to be given and is not there) and adds whole
/// sentences to `warnings` where a default stands in for something that is missing.
Result<Ingredients> gatherIngredients(const Take& take, const ProcessRequest& request,
                                      std::vector<std::string>& warnings);

/// What a filter needs: without rates or distances its poses would be guesses, as they are of boards that sit
/// on nobody. Sensors that lack otherwise become a warning. Takes of sound or of several suits always pass:
/// their pulses tell later.
Status checkSensors(const Take& take, const TrackerSettings& tracker, const Suit& suit,
                    std::vector<std::string>& warnings);

/// What the take lacks with that calibration; one that holds readings needs no source offsets, for its ranges
/// are distances already.
CalibrationLack lackOfTake(const Take& take, const Suit& suit, const Calibration& calibration);

/// kUnusable, with the take's file in front.
Error unusableTake(const Take& take, const std::string& what, const std::string& remedy);

}  // namespace noctule
