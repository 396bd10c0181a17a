// SPDX-License-Identifier: Apache-2.0
// Joint positions as a table: `time_s,JOINT.x,JOINT.y,JOINT.z,...`, world, metres, one row per frame. What
// export writes and what attach reads.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/job/job.h"
#include "core/motion/clip.h"

namespace noctule {

/// Joints in the skeleton's order, then with `angles` a column JOINT.FREEDOM in degrees for every named
/// degree of freedom (projectOntoJoint without limits). Metres and degrees to 1e-6, time to 1 ns.
/// `begin_s`: time of the first row.
std::string formatPositionsCsv(const MotionClip& clip, bool angles, double begin_s = 0);
/// kUnusable when a value is not finite.
Status writePositionsCsv(const std::string& path, const MotionClip& clip, bool angles, bool overwrite,
                         double begin_s = 0);

struct PositionTable {
    std::vector<double> time_s;  ///< strictly rising
    std::vector<std::string> joints;
    std::vector<Vector3d> p_world_m;    ///< row after row, one per joint
    std::vector<std::string> warnings;  ///< whole sentences: the clock jumps

    const Vector3d& at(size_t row, size_t joint) const { return p_world_m[row * joints.size() + joint]; }
};

/// Columns in any order, comma, semicolon or tab between them; columns that are neither time nor JOINT.x, .y
/// or .z are ignored. Time: time_s, time_ms, time_us or time_ns, in any case and with the unit in brackets
/// too. Decimals with a point, or with a comma in cells that are not cut at it. UTF-8 or UTF-16. kUnreadable
/// with line and column.
Result<PositionTable> readPositionsCsv(const std::string& path, const CancelFlag* cancel = nullptr);
Result<PositionTable> parsePositionsCsv(std::string_view text, const std::string& where);

/// Other columns of such a table by their names (the angles, say): row after row, in the order of `names`.
/// kUnreadable when one is missing or holds something that is not a finite number.
Result<std::vector<double>> readNumberColumns(const std::string& path, const std::vector<std::string>& names);

}  // namespace noctule
