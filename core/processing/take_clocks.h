// SPDX-License-Identifier: Apache-2.0
// The clocks of the suits of one take, joined by the ranges between them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/cooperative/clock_estimator.h"
#include "core/job/job.h"
#include "core/recording/take.h"

namespace noctule {

inline constexpr int kTakeTimeSuit = 1;  ///< its clock is take time

struct TakeClocks {
    std::map<int, cooperative::ClockTrack> tracks;  ///< of the suits that could be joined, but suit 1
    std::map<int, SuitClock> lines;                 ///< the same as one line, for poses
    std::vector<std::string> warnings;  ///< whole sentences; a suit that cannot be joined is named

    bool knows(int suit) const { return suit == kTakeTimeSuit || lines.contains(suit); }
    /// The suit's line; where there is none, the recorder's guess.
    SuitClock best(int suit, const SuitClock& guess) const {
        const auto line = lines.find(suit);
        return line == lines.end() ? guess : line->second;
    }
};

/// Meta `clock_shared`: all boxes sample by one clock.
bool clocksAreShared(const Take& take);

/// From the primary ranges between suits. Empty for a take of one suit or without such ranges; of shared
/// clocks all lines are take time.
Result<TakeClocks> joinClocks(const Take& take, const JobContext& job);

/// Rows of the table `clock`.
std::vector<ClockRow> clockRows(const cooperative::ClockTrack& track);

}  // namespace noctule
