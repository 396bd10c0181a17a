// SPDX-License-Identifier: Apache-2.0
// Points over time as CSV: one row per point and instant. Columns: time_s (take time), subject, suit, device
// (id of a board, or of a source that is in no board's housing), x_m, y_m, z_m in the world, sigma_m per
// axis.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "core/processing/track_points.h"

namespace noctule {

class PointsTableWriter {
public:
    PointsTableWriter();
    /// Fills text(); must live as long as the sink is used.
    PointsSink sink();
    const std::string& text() const { return text_; }

private:
    std::string text_;
    std::vector<std::string> names_;  ///< of each point, as cells
};

/// One point of a table.
struct PointTrack {
    std::vector<double> time_s, sigma_m;
    std::vector<Vector3d> p_m;
};
/// By suit and device.
using PointsTable = std::map<std::pair<int, std::string>, PointTrack>;

/// kUnreadable names the file, the line and what is wrong there.
Result<PointsTable> readPointsTable(const std::string& path);

}  // namespace noctule
