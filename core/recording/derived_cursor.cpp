// SPDX-License-Identifier: Apache-2.0
#include "core/recording/derived_cursor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/job/limits.h"

namespace noctule {

namespace {

std::string whereRun(const RunOfTake& run, const std::string& table) {
    return " WHERE " + run.schema->expression(table, "run") + "=" + std::to_string(run.run);
}

std::string isOfSuit(const RunOfTake& run, const std::string& table) {
    return run.schema->expression(table, "suit") + "=" + std::to_string(run.suit);
}

/// A value that is there but is no number makes the row bad; NULL is a value that was not sent.
template <size_t N>
bool readCounts(const Statement& row, int first_column, std::array<std::optional<double>, N>& counts) {
    for (size_t i = 0; i < N; ++i) {
        const int column = first_column + static_cast<int>(i);
        counts[i] = row.real(column);
        if ((!counts[i] && !row.isNull(column)) || std::abs(counts[i].value_or(0)) > limits::kLargestCount)
            return false;
    }
    return true;
}

RowVerdict readReading(const Statement& row, int board, InertialReading& reading) {
    const auto frame = row.integer(0);
    const auto sample = row.real(1);
    if (!frame || *frame < 0)
        return "frame is not a count";
    if (!sample || *sample < 0 || *sample > static_cast<double>(kLastSample))
        return "sample is missing or out of range";
    reading.board = board;
    reading.frame = *frame;
    reading.sample = *sample;
    if (!readCounts(row, 2, reading.counts) || !readCounts(row, 8, reading.magnetometer_counts))
        return "a count is not a number or out of range";
    const auto corrected = row.integer(11);
    if (corrected)
        reading.corrected_bits = static_cast<int>(std::clamp<int64_t>(*corrected, 0, 1 << 20));
    return "";
}

/// Readings of boards that the suit does not have.
Status countStrangers(const RunOfTake& run) {
    const auto count = run.database->queryInteger(
        "SELECT count(*) FROM inertial" + whereRun(run, "inertial") + " AND " + isOfSuit(run, "inertial") +
        " AND (board<0 OR board IS NULL OR board>=" + std::to_string(run.board_count) + ")");
    if (!count)
        return count.error();
    if (count->value_or(0) > 0)
        run.log->add(rowsOfSuit("inertial", run.suit), "of another board", "board is not in the suit",
                     **count);
    return Done{};
}

bool isConfidence(std::optional<double> w) {
    return w && *w >= 0 && *w <= 1;
}

/// NULL is unknown: nothing speaks against the range.
std::optional<double> confidence(const Statement& row, int column) {
    return row.isNull(column) ? std::optional(1.0) : row.real(column);
}

constexpr double kNearlyAll = 0.9;

RowVerdict readRange(const Statement& row, const RunOfTake& run, RangeMeasurement& range) {
    const auto pulse_sample = row.integer(1);
    const auto source = row.integer(2);
    const auto board = row.integer(3);
    const auto arrival = row.real(4);
    const auto distance = row.real(5);
    const auto w_s = confidence(row, 6), w_t = confidence(row, 7), w_a = confidence(row, 8),
               sigma = row.real(9);
    if (!isSample(pulse_sample) || !source)
        return "its pulse is missing or out of range";
    if (*source < 0 || *source >= run.source_count || !board || *board < 0 || *board >= run.board_count)
        return "source or board is not in the suit";
    if (!arrival || !distance || !isConfidence(w_s) || !isConfidence(w_t) || !isConfidence(w_a))
        return "a number is missing or out of range";
    if (*distance < 0)
        return "the distance is below 0";
    if (*distance > limits::kFarthestHeard_m)
        return kTooFar;
    range.pulse = row.integer(0).value_or(0);
    range.pulse_sample = *pulse_sample;
    range.source = static_cast<int>(*source);
    range.board = static_cast<int>(*board);
    range.arrival_sample = *arrival;
    range.distance_m = *distance;
    range.w_s = *w_s;
    range.w_t = *w_t;
    range.w_a = *w_a;
    range.sigma_m = std::max(0.0, sigma.value_or(0));
    return "";
}

}  // namespace

Result<ReadingCursor> ReadingCursor::open(const RunOfTake& run) {
    ReadingCursor cursor(run);
    run.log->restart(rowsOfSuit("inertial", run.suit));
    if (!run.schema->has("inertial"))
        return cursor;
    if (const Status counted = countStrangers(run); !counted)
        return counted.error();
    const std::string sql = run.schema->select("inertial", {"frame", "sample", "gx", "gy", "gz", "ax", "ay",
                                                            "az", "mx", "my", "mz", "corrected"}) +
                            whereRun(run, "inertial") + " AND " + isOfSuit(run, "inertial") +
                            " AND board=? ORDER BY frame";
    for (int board = 0; board < run.board_count; ++board) {
        Result<Statement> rows = run.database->prepare(sql);
        if (!rows)
            return rows.error();
        rows->bind(0, int64_t{board});
        Lane lane{board, std::move(*rows), {}, {}, 0};
        if (const Status first = cursor.advance(lane); !first)
            return first.error();
        cursor.lanes_.push_back(std::move(lane));
    }
    return cursor;
}

Status ReadingCursor::advance(Lane& lane) {
    lane.head.reset();
    const double hole = static_cast<double>(limits::kLongestHole_s) * run_.sample_rate_hz;
    while (true) {
        auto reading = lane.ahead ? std::exchange(lane.ahead, {}) : readOn(lane);
        if (!reading)
            return reading.error();
        if (!*reading)
            return Done{};
        const bool is_far = lane.last_sample > 0 && (*reading)->sample > lane.last_sample + hole;
        if (is_far) {
            auto after = readOn(lane);
            if (!after)
                return after.error();
            lane.ahead = *after;
        }
        if (!is_far || (lane.ahead && lane.ahead->sample >= (*reading)->sample)) {
            lane.head = *reading;
            lane.last_sample = (*reading)->sample;
            return Done{};
        }
        run_.log->add(rowsOfSuit("inertial", run_.suit),
                      "board " + std::to_string(lane.board) + " frame " + std::to_string((*reading)->frame),
                      "sample lies far beyond those around it");
    }
}

/// The next row that can be read.
Result<std::optional<InertialReading>> ReadingCursor::readOn(Lane& lane) {
    while (true) {
        const Result<bool> row = lane.rows.step();
        if (!row)
            return row.error();
        if (!*row)
            return std::optional<InertialReading>();
        InertialReading reading;
        const RowVerdict verdict = readReading(lane.rows, lane.board, reading);
        if (verdict.empty())
            return std::optional(reading);
        run_.log->add(rowsOfSuit("inertial", run_.suit),
                      "board " + std::to_string(lane.board) + " frame " +
                          std::to_string(lane.rows.integer(0).value_or(-1)),
                      verdict);
    }
}

Result<std::optional<InertialReading>> ReadingCursor::next() {
    Lane* earliest = nullptr;
    for (Lane& lane : lanes_)
        if (lane.head && (!earliest || lane.head->sample < earliest->head->sample))
            earliest = &lane;
    if (!earliest)
        return std::optional<InertialReading>();
    const std::optional<InertialReading> reading = earliest->head;
    if (const Status advanced = advance(*earliest); !advanced)
        return advanced.error();
    return reading;
}

std::string RangeCursor::query(const RunOfTake& run) {
    const TakeSchema& schema = *run.schema;
    if (!schema.has("range") || !schema.has("pulse"))
        return "SELECT 1 WHERE 0";
    // Left join, with the range outside: its primary key gives the order, and a range without its pulse
    // shows. The plus keeps SQLite from taking the suit for a constant: it would no longer see that the key
    // (run, pulse, suit, board) has the order that is asked for, and sort.
    std::string sql = "SELECT range.pulse,pulse.sample,pulse.source,range.board";
    for (const char* column :
         {"arrival_sample", "distance_m", "w_s", "w_t", "w_a", "sigma_m", "detector", "fate", "innovation_m"})
        sql += "," + schema.expression("range", column);
    sql += " FROM range LEFT JOIN pulse ON pulse.id=range.pulse" + whereRun(run, "range") + " AND +" +
           isOfSuit(run, "range");
    // What the suit's boards heard of other suits has other sources and another clock.
    sql += " AND (pulse.id IS NULL OR " + isOfSuit(run, "pulse") + ")";
    if (run.pulses)
        sql += " AND range.pulse BETWEEN " + std::to_string(run.pulses->first) + " AND " +
               std::to_string(run.pulses->second);
    return sql + " ORDER BY range.pulse," + schema.expression("range", "suit") + ",range.board";
}

Result<RangeCursor> RangeCursor::open(const RunOfTake& run) {
    run.log->restart(rowsOfSuit("range", run.suit));
    Result<Statement> rows = run.database->prepare(query(run));
    if (!rows)
        return rows.error();
    return RangeCursor(run, std::move(*rows));
}

Result<std::optional<RangeMeasurement>> RangeCursor::next() {
    while (!at_end_) {
        const Result<bool> row = rows_.step();
        if (!row)
            return row.error();
        at_end_ = !*row;
        if (at_end_)
            break;
        RangeMeasurement range;
        const RowVerdict verdict = readRange(rows_, run_, range);
        if (verdict.empty()) {
            detector_ = rows_.text(10).value_or("");
            range.fate = rangeFateFromName(rows_.text(11).value_or(""));
            range.innovation_m = rows_.real(12).value_or(0);
            ++good_;
            return std::optional(range);
        }
        too_far_ += verdict == kTooFar;
        run_.log->add(rowsOfSuit("range", run_.suit),
                      "pulse " + std::to_string(rows_.integer(0).value_or(-1)), verdict);
    }
    if (static_cast<double>(too_far_) > kNearlyAll * static_cast<double>(too_far_ + good_))
        run_.log->explain(rowsOfSuit("range", run_.suit), "nearly all are: they look like millimetres");
    too_far_ = 0;
    return std::optional<RangeMeasurement>();
}

}  // namespace noctule
