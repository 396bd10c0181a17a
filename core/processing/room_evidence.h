// SPDX-License-Identifier: Apache-2.0
// What a take holds for a survey of its room: ranges between the anchors, and ranges between them and one
// performer whose poses are estimated without the room.
#pragma once

#include "core/processing/cross_ranges.h"
#include "core/room_survey/evidence.h"

namespace noctule {

struct RoomEvidence {
    room_survey::Evidence evidence;
    RoomOfTake room;
    std::vector<std::pair<int, int>>
        parts;                          ///< per anchor its board and its source in the room's suit; -1: none
    std::vector<std::string> warnings;  ///< whole sentences
};

/// `performer` empty: the one whom most ranges to anchors concern. Fails (kUsage) for a take without anchors
/// and for a name that nobody has.
Result<RoomEvidence> gatherRoom(Take& take, const std::string& performer, const JobContext& job);

/// Its anchors with the calibration in force; kUsage when there are none.
Result<RoomOfTake> roomOfTake(const Take& take);

/// Board and source of every housing of a room's suit.
std::vector<std::pair<int, int>> anchorParts(const Suit& room);

}  // namespace noctule
