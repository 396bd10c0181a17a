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
    std::vector<std::string> without{};  ///< anchors that are left out, by id or number from 1
};

struct SurveyedTake {
    CalibrationResult result;  ///< its `room` has the places found of the anchors that are used
    room_survey::RoomSurvey survey;
    Suit before{};  ///< the room as its places are in force in the take
};
/// Of a take that is still being recorded, what has been recorded so far.
Result<SurveyedTake> calibrateRoom(const RoomRequest& request, const JobContext& job);

/// The same without some of its anchors, by index. Fails (kUsage) when too few would be left.
Result<SurveyedTake> withoutAnchors(SurveyedTake surveyed, const std::vector<size_t>& anchors);

/// Places of anchors, changed by an operator.
struct RoomChange {
    Suit before{}, after{};
    std::string created_utc{};

    RoomChange reversed() const { return {after, before, created_utc}; }
};

/// Puts the places of a room's file in force in a take. Fails (kUsage) when the take has no room, or when
/// none of its anchors is in the file; anchors that the file lacks are named in `warnings`.
Status placeAnchors(const std::string& take_path, const Suit& room, const std::string& created_utc,
                    std::vector<std::string>& warnings);

}  // namespace noctule
