// SPDX-License-Identifier: Apache-2.0
// The one table of limits on what comes from outside: takes, driver boxes, announcements and documents. A
// value beyond its limit is refused by name, or its row is skipped, counted and named. Larger limits accept
// stranger inputs and cost memory and time; every limit is far beyond what the program itself writes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace noctule::limits {

// Documents (JSON)
inline constexpr int kJsonDepth = 32;           ///< nested lists and objects; a suit needs 5, settings 3
inline constexpr int kBoxJsonDepth = 16;        ///< of a message of a box; what is deeper is left out
inline constexpr size_t kJsonBytes = 16 << 20;  ///< an actor of 256 joints takes 0.2 MB
inline constexpr size_t kJoints = 256;  ///< ours has 21, fingers add 30; the filter grows with the square
inline constexpr size_t kFreedomsOfJoint = 3;  ///< more do not add any rotation
inline constexpr size_t kCapsules = 1024;      ///< lines of sight are tested against each
inline constexpr double kLengthOfBody_m = 10;  ///< bones, capsules and heights; people end at 2.7 m
inline constexpr size_t kSuitsOfTake = 64;     ///< performers and fixed transceivers in one take

// Time
inline constexpr int64_t kLowestRate_hz = 10;             ///< slow trackers send 30 readings a second
inline constexpr int64_t kHighestRate_hz = 10'000'000;    ///< as the link; ultrasound needs 150 kHz
inline constexpr int64_t kLongestTake_s = 7 * 24 * 3600;  ///< a week; hours are usual
/// No pose is carried over a longer hole between two readings; a single row beyond it is damage.
inline constexpr int64_t kLongestHole_s = 600;
inline constexpr int64_t kBeyondTake_ns =
    1'000'000'000;  ///< the last pose may stand so far after the last sample

// Numbers of a row
inline constexpr double kLargestCount = 1e6;                ///< of inertial readings; converters have 16 bits
inline constexpr double kFarthest_m = 100'000;              ///< of positions
inline constexpr double kFarthestHeard_m = 20;              ///< measured distances: sound carries no farther
inline constexpr double kColdest_c = -60, kHottest_c = 90;  ///< air in which a suit is worn, and some more

// Texts, in bytes of UTF-8; longer ones are cut
inline constexpr size_t kName = 200;             ///< names, ids, labels, kinds, dates; a long sentence
inline constexpr size_t kShownName = 60;         ///< of it in tables and at plots
inline constexpr size_t kNote = 64 * 1024;       ///< notes of operators, some pages
inline constexpr size_t kMetaValue = 64 * 1024;  ///< what a reference or x_ entry of `meta` says; JSON too
inline constexpr size_t kBoxText = 300;          ///< what a driver box says of itself and its errors
inline constexpr size_t kListedRows = 10'000;    ///< rows of a table that `inspect --json` lists

// What a driver box may add to a take
inline constexpr int kBoxNotes = 100;              ///< notes at once; then one each kBoxNoteEvery_s
inline constexpr double kBoxNoteEvery_s = 1;       ///< so an hour of errors adds 1 MB at most
inline constexpr size_t kAnnouncedBoxes = 20'000;  ///< of one network; more are not listed

// Work
inline constexpr int64_t kStepsOfRow = 20'000'000'000;  ///< of SQLite's machine until the next row; minutes

/// Rows of a table that are read whole; the rest is skipped. An hour has 450,000 pulses and 3600 status rows.
struct RowLimit {
    std::string_view table;
    int64_t rows;
};
inline constexpr RowLimit kRows[] = {
    {"meta", 10'000},          {"suit", 1000},        {"calibration", 100'000},
    {"actor", 100'000},        {"derived", 100'000},  {"note", 20'000},
    {"marker", 100'000},       {"gap", 200'000},      {"status", 1'000'000},
    {"contact", 1'000'000},    {"pulse", 20'000'000}, {"external_root", 20'000'000},
    {"reference", 20'000'000},
};
inline constexpr int64_t kRowsOfOthers = 1'000'000'000;  ///< walked through one by one, never held

/// `what` may go on after the table's name: "pulse of suit 2".
constexpr int64_t rowsOf(std::string_view what) {
    const std::string_view table = what.substr(0, what.find(' '));
    for (const RowLimit& limit : kRows)
        if (limit.table == table)
            return limit.rows;
    return kRowsOfOthers;
}

}  // namespace noctule::limits
