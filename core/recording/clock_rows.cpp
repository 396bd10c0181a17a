// SPDX-License-Identifier: Apache-2.0
// What joins suits: the table `clock`, the ranges from one suit to another, which tell it, and the table
// `relative`.
#include <array>
#include <cmath>

#include "core/job/limits.h"
#include "core/recording/row_reader.h"
#include "core/recording/take.h"
#include "core/recording/take_tables.h"

namespace noctule {
namespace {

bool isShare(std::optional<double> w) {
    return w && *w >= 0 && *w <= 1;
}
/// NULL is unknown: nothing speaks against the range.
std::optional<double> shareOf(const Statement& row, int column) {
    return row.isNull(column) ? std::optional(1.0) : row.real(column);
}

}  // namespace

Status TakeTables::addClock(int64_t run, const ClockRow& row, int suit) {
    auto insert = insertInto("clock");
    if (!insert)
        return insert.error();
    (*insert)->bind(0, run).bind(1, int64_t{seen(suit)}).bind(2, row.time_ns);
    return (*insert)->bind(3, row.offset_ns).bind(4, row.rate).bind(5, row.sigma_ns).run();
}

Result<std::vector<ClockRow>> Take::clocks(int64_t run, int suit) const {
    const std::string filter = schema_->expression("clock", "run") + "=" + std::to_string(run) + " AND " +
                               schema_->expression("clock", "suit") + "=" + std::to_string(seen(suit));
    const std::string sql = schema_->select("clock", {"time_ns", "offset_ns", "rate", "sigma_ns"}) +
                            (schema_->has("clock") ? " WHERE " + filter + " ORDER BY time_ns" : "");
    return collectRows<ClockRow>(*database_, *log_, "clock", sql,
                                 [](const Statement& row, ClockRow& out) -> RowVerdict {
                                     const auto time = row.integer(0);
                                     const auto offset = row.real(1), rate = row.real(2);
                                     if (!time || !offset || !rate || !(*rate > 0.5 && *rate < 2))
                                         return "a number is missing or out of range";
                                     out = {*time, *offset, *rate, row.real(3).value_or(0)};
                                     return "";
                                 });
}

Status TakeTables::addRelative(int64_t run, const RelativeRow& row, int suit) {
    auto insert = insertInto("relative");
    if (!insert)
        return insert.error();
    Statement& into = **insert;
    into.bind(0, run).bind(1, int64_t{seen(suit)}).bind(2, int64_t{row.other_suit});
    into.bind(3, row.joint).bind(4, row.other_joint).bind(5, row.time_ns);
    const Matrix3d& C = row.cov_m2;
    into.bind(6, C(0, 0)).bind(7, C(0, 1)).bind(8, C(0, 2));
    return into.bind(9, C(1, 1)).bind(10, C(1, 2)).bind(11, C(2, 2)).run();
}

Result<std::vector<RelativeRow>> Take::relatives(int64_t run, int suit) const {
    const std::string filter = schema_->expression("relative", "run") + "=" + std::to_string(run) + " AND " +
                               schema_->expression("relative", "suit") + "=" + std::to_string(seen(suit));
    const std::string sql = schema_->select("relative", {"other_suit", "joint", "other_joint", "time_ns",
                                                         "xx", "xy", "xz", "yy", "yz", "zz"}) +
                            (schema_->has("relative") ? " WHERE " + filter + " ORDER BY time_ns" : "");
    return collectRows<RelativeRow>(
        *database_, *log_, "relative", sql, [](const Statement& row, RelativeRow& out) -> RowVerdict {
            const auto other = row.integer(0), time = row.integer(3);
            if (!other || *other < 1 || *other > 1000 || !time)
                return "a number is missing or out of range";
            std::array<double, 6> c{};
            for (int i = 0; i < 6; ++i) {
                const auto value = row.real(4 + i);
                if (!value || std::abs(*value) > limits::kFarthest_m * limits::kFarthest_m)
                    return "a number is missing or out of range";
                c[static_cast<size_t>(i)] = *value;
            }
            out = {static_cast<int>(*other), row.shortened(1, limits::kName), row.shortened(2, limits::kName),
                   *time, Matrix3d::Zero()};
            out.cov_m2 << c[0], c[1], c[2], c[1], c[3], c[4], c[2], c[4], c[5];
            return "";
        });
}

Status Take::forEachCrossRange(int64_t run, int suit,
                               const std::function<bool(const CrossRange&)>& sink) const {
    suit = seen(suit);
    if (!schema_->has("range", "suit") || !schema_->has("pulse", "suit"))
        return Done{};
    const auto boards = boardCount(suit);
    if (!boards)
        return boards.error();
    std::map<int, int> sources;
    for (const int id : suitIds())
        if (const auto count = sourceCount(id))
            sources[id] = *count;
    const std::string sql =
        "SELECT range.pulse,pulse.suit,pulse.sample,pulse.source,range.board,range.arrival_sample,"
        "range.distance_m,range.w_s,range.w_t,range.sigma_m," +
        schema_->expression("range", "w_a") + "," + schema_->expression("range", "fate") + "," +
        schema_->expression("range", "innovation_m") +
        " FROM range JOIN pulse ON pulse.id=range.pulse WHERE range.run=" + std::to_string(run) +
        " AND +range.suit=" + std::to_string(suit) + " AND pulse.suit<>" + std::to_string(suit) +
        " ORDER BY range.pulse,range.suit,range.board";
    return forEachRow<CrossRange>(
        *database_, *log_, rowsOfSuit("range", suit) + " from others", sql,
        [&](const Statement& row, CrossRange& out) -> RowVerdict {
            const auto from = row.integer(1), sample = row.integer(2), source = row.integer(3),
                       board = row.integer(4);
            // A writer that does not know the clocks stores the arrival alone.
            const auto distance = row.isNull(6) ? std::optional(kNoDistance) : row.real(6);
            const auto arrival = row.real(5), w_s = shareOf(row, 7), w_t = shareOf(row, 8),
                       w_a = shareOf(row, 10);
            const auto owner = sources.find(static_cast<int>(from.value_or(-1)));
            if (owner == sources.end() || !source || *source < 0 || *source >= owner->second || !board ||
                *board < 0 || *board >= *boards)
                return "source or board is not in its suit";
            if (!isSample(sample) || !arrival || !distance || !isShare(w_s) || !isShare(w_t))
                return "a number is missing or out of range";
            if (std::abs(*distance) > limits::kFarthestHeard_m)
                return kTooFar;
            out.from_suit = owner->first;
            out.range = {};
            out.range.pulse = row.integer(0).value_or(0);
            out.range.pulse_sample = *sample;
            out.range.source = static_cast<int>(*source);
            out.range.board = static_cast<int>(*board);
            out.range.arrival_sample = *arrival;
            out.range.distance_m = *distance;
            out.range.w_s = *w_s;
            out.range.w_t = *w_t;
            out.range.sigma_m = std::max(0.0, row.real(9).value_or(0));
            out.range.w_a = isShare(w_a) ? *w_a : 1;
            out.range.fate = rangeFateFromName(row.text(11).value_or(""));
            out.range.innovation_m = row.real(12).value_or(0);
            return "";
        },
        [&](CrossRange&& range) { return sink(range); });
}

}  // namespace noctule
