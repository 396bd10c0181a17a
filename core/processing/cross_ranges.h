// SPDX-License-Identifier: Apache-2.0
// What joins the suits of a take: which of them can be estimated together, and the ranges between them.
#pragma once

#include <optional>
#include <vector>

#include "core/estimation/joint_filter.h"
#include "core/processing/cross_clocks.h"
#include "core/processing/measure_sound.h"
#include "core/processing/take_clocks.h"

namespace noctule {

/// Where three anchors do not agree, nobody can tell which of them are right.
inline constexpr const char* kRoomContradicts =
    "Fewer than three anchors agree with each other: several were moved, or the room was surveyed wrongly. "
    "Places and headings in the room cannot be trusted. Survey the room again.";

/// That one anchor does not agree with the others.
std::string anchorContradicts(const Suit& room, int anchor);

/// The anchors of a take's room.
struct RoomOfTake {
    TakeSubject subject;
    Suit suit;
    Calibration calibration;
    SuitClock clock;
};

/// What is joined by what.
struct Joining {
    bool between = false;
    std::optional<RoomOfTake> room;
    std::vector<SuitClock> guesses;  ///< of the recorder, per subject and then of the room
    std::vector<ClockLine> clocks;   ///< as far as they are known
    std::vector<bool> clock_known;   ///< against the first subject's: joined by transceivers
    bool clocks_shared = false;
    std::vector<JointDistance> distances;
    std::vector<RangeMeasurement> ranges;  ///< as measured, one per distance
    std::optional<Take> measured;          ///< of a take of sound: its readings and ranges

    bool joins() const { return !distances.empty(); }
    /// Where its readings and ranges stand: in the take itself unless that holds sound.
    const Take& dataOf(const Take& take) const { return measured ? *measured : take; }
    /// At least two anchors are heard. One alone leaves the heading free.
    bool roomHoldsWorld() const;
    /// Suit of a member.
    int suitOf(size_t member, const std::vector<Ingredients>& subjects) const {
        return member < subjects.size() ? subjects[member].subject.suit() : room->subject.suit();
    }
};

/// Fails where what was asked for (Wanted::kOn) cannot be; otherwise says in `warnings` what is left out. Of
/// a take of sound, `clocks` and the subjects' clocks become those of what was measured; `folder` is where
/// that is put aside.
Result<Joining> joinSubjects(Take& take, const ProcessRequest& request, std::vector<Ingredients>& subjects,
                             TakeClocks& clocks, const std::string& folder,
                             std::vector<std::string>& warnings, const JobContext& job);

}  // namespace noctule
