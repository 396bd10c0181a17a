// SPDX-License-Identifier: Apache-2.0
// Mistakes of the table of known distances that show in the residuals: another unit, and two labels that
// stand for each other. Both are looked for before any fit, with the thermometer's speed of sound and the
// median offset of each source: a mistake is centimetres, all else millimetres.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/calibration/source_offsets/jig_measurements.h"

namespace noctule {

struct UnitMistake {
    double factor = 1;  ///< known distances over true ones
    const char* words;  ///< "as if millimetres stood under a heading in metres"
};
std::span<const UnitMistake> unitMistakes();
std::optional<UnitMistake> findUnitMistake(const JigData& jig);

/// Finds them one after another, the plainest first, and marks their measurements as mislabelled.
std::vector<SwappedLabels> markSwappedLabels(JigData& jig);

}  // namespace noctule
