// SPDX-License-Identifier: Apache-2.0
// The table `orientation`: written by TakeTables, read by Take.
#include <array>
#include <cmath>

#include "core/recording/row_reader.h"
#include "core/recording/take.h"
#include "core/recording/take_tables.h"

namespace noctule {

Status TakeTables::addOrientation(int64_t run, const OrientationRow& row, int suit) {
    auto insert = insertInto("orientation");
    if (!insert)
        return insert.error();
    const Quaterniond& q = row.q_world_board;
    (*insert)->bind(0, run).bind(1, int64_t{seen(suit)}).bind(2, int64_t{row.board}).bind(3, row.time_ns);
    (*insert)->bind(4, q.w()).bind(5, q.x()).bind(6, q.y()).bind(7, q.z());
    return (*insert)->bind(8, row.heading_sigma_rad).run();
}

Result<std::vector<OrientationRow>> Take::orientations(int64_t run, int board, int suit) const {
    const std::string filter = schema_->expression("orientation", "run") + "=" + std::to_string(run) +
                               " AND " + schema_->expression("orientation", "board") + "=" +
                               std::to_string(board) + " AND " + schema_->expression("orientation", "suit") +
                               "=" + std::to_string(seen(suit));
    const std::string sql =
        schema_->select("orientation", {"time_ns", "qw", "qx", "qy", "qz", "heading_sigma_rad"}) +
        (schema_->has("orientation") ? " WHERE " + filter + " ORDER BY time_ns" : "");
    return collectRows<OrientationRow>(
        *database_, *log_, "orientation", sql,
        [board](const Statement& row, OrientationRow& out) -> RowVerdict {
            const auto time = row.integer(0);
            std::array<double, 4> q{};
            for (int i = 0; i < 4; ++i)
                q[size_t(i)] = row.real(1 + i).value_or(0);
            const double norm = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
            if (!time || std::abs(norm - 1) > 0.01)
                return "time or quaternion is missing";
            out = {board, *time, Quaterniond(q[0], q[1], q[2], q[3]).normalized(), row.real(5).value_or(0)};
            return "";
        });
}

}  // namespace noctule
