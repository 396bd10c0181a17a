// SPDX-License-Identifier: Apache-2.0
// Walks through the rows of a query, passes the good ones on and counts the bad ones, so that one damaged row
// does not cost the rest of a take.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/job/limits.h"
#include "core/recording/database.h"
#include "core/recording/rows.h"

namespace noctule {

/// Bad rows met so far; reading the same thing again starts its count again.
class SkipLog {
public:
    void restart(const std::string& what) { rows_.erase(what); }
    void add(const std::string& what, const std::string& row, const std::string& why, int64_t count = 1);
    /// What all of them together tell, behind the reason of the first.
    void explain(const std::string& what, const std::string& why);
    std::vector<SkippedRows> all() const;

private:
    std::map<std::string, SkippedRows> rows_;
};

/// Why a row cannot be used; empty: it can.
using RowVerdict = std::string;
/// Of a distance, among the ranges of a suit and those between suits.
inline constexpr const char* kTooFar = "the distance is beyond 20 m, farther than sound carries";
static_assert(limits::kFarthestHeard_m == 20);

/// Calls `read` for every row of the query. Column 0 names the row in the log. A Row that `read` finds good
/// goes to `sink`, which stops the walk by false; the log then knows of the rows up to there. Rows beyond the
/// table's limit are bad ones. Fails only when the database does, or when cancelled.
template <class Row>
Status forEachRow(const Database& database, SkipLog& log, const std::string& what, const std::string& sql,
                  const std::function<RowVerdict(const Statement&, Row&)>& read,
                  const std::function<bool(Row&&)>& sink) {
    log.restart(what);
    Result<Statement> statement = database.prepare(sql);
    if (!statement)
        return statement.error();
    const int64_t limit = limits::rowsOf(what);
    for (int64_t number = 1;; ++number) {
        const Result<bool> there = statement->step();
        if (!there)
            return there.error();
        if (!*there)
            return Done{};
        Row row;
        const RowVerdict verdict = number > limit
                                       ? "the table has more than " + std::to_string(limit) + " rows"
                                       : read(*statement, row);
        if (!verdict.empty())
            log.add(what, std::to_string(statement->integer(0).value_or(-1)), verdict);
        else if (!sink(std::move(row)))
            return Done{};
    }
}

/// All good rows.
template <class Row>
Result<std::vector<Row>> collectRows(const Database& database, SkipLog& log, const std::string& what,
                                     const std::string& sql,
                                     const std::function<RowVerdict(const Statement&, Row&)>& read) {
    std::vector<Row> rows;
    const Status walked = forEachRow<Row>(database, log, what, sql, read, [&rows](Row&& row) {
        rows.push_back(std::move(row));
        return true;
    });
    if (!walked)
        return walked.error();
    return rows;
}

/// "adc_block" or, of a later suit, "adc_block of suit 2": what the log calls the rows of a suit.
std::string rowsOfSuit(const std::string& table, int suit);

bool isSample(std::optional<int64_t> sample);

}  // namespace noctule
