// SPDX-License-Identifier: Apache-2.0
// Inertial readings and ranges of a run, one after the other: hours of them do not fit in memory. Pull them
// to merge both by time. A cursor is valid while its Take lives.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/acoustics/range.h"
#include "core/inertial/reading.h"
#include "core/recording/row_reader.h"
#include "core/recording/schema.h"

namespace noctule {

/// What a cursor needs of its take.
struct RunOfTake {
    const Database* database = nullptr;
    const TakeSchema* schema = nullptr;
    SkipLog* log = nullptr;
    int64_t run = 0;
    int suit = 0;  ///< counts from 1
    int board_count = 0;
    int source_count = 0;
    double sample_rate_hz = 0;
    std::optional<std::pair<int64_t, int64_t>> pulses{};  ///< only ranges of pulses with these ids
};

/// All boards' readings in the order of their instants, lost frames among them.
class ReadingCursor {
public:
    static Result<ReadingCursor> open(const RunOfTake& run);
    Result<std::optional<InertialReading>> next();

private:
    struct Lane {
        int board = 0;
        Statement rows;
        std::optional<InertialReading> head, ahead;  ///< the one after it, where that had to be looked at
        double last_sample = 0;                      ///< of the heads so far
    };
    explicit ReadingCursor(const RunOfTake& run) : run_(run) {}
    Status advance(Lane& lane);
    Result<std::optional<InertialReading>> readOn(Lane& lane);

    RunOfTake run_;
    std::vector<Lane> lanes_;  ///< one per board: the primary key keeps a board's frames in order
};

/// Ranges in the order of their pulses' ids, which is the order of time in takes of ours; pulse_sample tells.
/// sigma_m 0: not stated.
class RangeCursor {
public:
    static Result<RangeCursor> open(const RunOfTake& run);
    /// What open() asks the database: rows come in the order of the primary key, nothing is sorted.
    static std::string query(const RunOfTake& run);
    Result<std::optional<RangeMeasurement>> next();
    /// That measured the last range that next() gave.
    const std::string& detector() const { return detector_; }

private:
    RangeCursor(const RunOfTake& run, Statement rows) : run_(run), rows_(std::move(rows)) {}

    RunOfTake run_;
    Statement rows_;
    std::string detector_;
    bool at_end_ = false;  ///< SQLite would start again
    int64_t good_ = 0, too_far_ = 0;
};

}  // namespace noctule
