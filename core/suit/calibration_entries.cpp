// SPDX-License-Identifier: Apache-2.0
#include "core/suit/calibration_entries.h"

#include <algorithm>

namespace noctule {

BoardCalibration& entryOf(Calibration& calibration, const Board& board) {
    const auto found = std::ranges::find(calibration.boards, board.id, &BoardCalibration::id);
    if (found != calibration.boards.end())
        return *found;
    Suit suit;
    suit.boards = {board};
    return calibration.boards.emplace_back(nominalCalibration(suit).boards.front());
}

SourceCalibration& entryOf(Calibration& calibration, const Source& source) {
    const auto found = std::ranges::find(calibration.sources, source.id, &SourceCalibration::id);
    if (found != calibration.sources.end())
        return *found;
    SourceCalibration& added = calibration.sources.emplace_back();
    added.id = source.id;
    return added;
}

}  // namespace noctule
