// SPDX-License-Identifier: Apache-2.0
// The survey of a take's room from file to file, and how its result comes into force.
#pragma once

#include "core/processing/calibrate_takes.h"
#include "core/room_survey/room_survey.h"

namespace noctule {

struct RoomRequest {
    std::string take_path;
    std::string performer;                                  ///< who walked; empty: whom most ranges concern
    std::vector<std::pair<std::string, double>> heights_m;  ///< of anchors by id, as measured
    std::string created_utc;
};

/// The result's `room` has the places found; anchors that could not be placed are left out of it.
Result<CalibrationResult> calibrateRoom(const RoomRequest& request, const JobContext& job);

/// Puts the places of a room's file in force in a take. Fails (kUsage) when the take has no room, or when
/// none of its anchors is in the file; anchors that the file lacks are named in `warnings`.
Status placeAnchors(const std::string& take_path, const Suit& room, const std::string& created_utc,
                    std::vector<std::string>& warnings);

}  // namespace noctule
