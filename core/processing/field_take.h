// SPDX-License-Identifier: Apache-2.0
// What magnetometers read while a suit was turned, kept as a take of readings: raw counts with their instants
// and nothing else, from which `calibrate magnetometers` makes what the wizard makes. The field of the spot
// stands beside them as meta x_field_spot.
#pragma once

#include <string>
#include <vector>

#include "core/sensor_calibration/field_turn.h"
#include "core/suit/calibration.h"
#include "core/suit/suit.h"

namespace noctule {

struct FieldRecord {
    std::vector<std::vector<FieldReading>> readings;  ///< per board of the suit, in the order of time
    std::optional<SpotField> spot;                    ///< none: it was not looked at yet
};

struct FieldTakePlan {
    std::string path, name, created_utc, software;
    int sample_rate_hz = 0;
    std::optional<Calibration> calibration;  ///< in force while it was turned
};

/// A file that stands at the path is replaced, all or nothing.
Status writeFieldTake(const FieldTakePlan& plan, const Suit& suit, const FieldRecord& record);
/// Of the boards of `suit`, by their ids; boards that the take lacks have no readings.
Result<FieldRecord> readFieldTake(const std::string& path, const Suit& suit);

}  // namespace noctule
