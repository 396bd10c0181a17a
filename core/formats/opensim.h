// SPDX-License-Identifier: Apache-2.0
// Motions for OpenSim's full-body models (Rajagopal et al. 2016 and its kin): joint angles as .mot, which its
// tools play and analyse at once, and segment orientations as .sto, from which OpenSense computes angles on a
// scaled model. Both stand in OpenSim's axes: X forward, Y up, Z to the right; their zero pose stands
// with hanging arms, palms forward (pro_sup is 90 where our palms look down or to the body). Angles of a
// joint are taken in the order of the model: about Z (flexion), X (adduction), Y (rotation), mirrored on the
// left; what a joint of the model cannot do is left out.
#pragma once

#include <string>
#include <vector>

#include "core/job/result.h"
#include "core/motion/clip.h"

namespace noctule {

/// Rows of numbers under names; the first column is time in seconds.
struct OpenSimTable {
    std::vector<std::string> header;   ///< the lines before "endheader"
    std::vector<std::string> columns;  ///< with "time"
    size_t width = 0;            ///< numbers per row: a quaternion is one column and four numbers w,x,y,z
    std::vector<double> values;  ///< row after row

    size_t rows() const { return width ? values.size() / width : 0; }
};

/// Coordinates in degrees, the pelvis' place in metres. Joints that the skeleton lacks have no columns;
/// kUnusable when there is no pelvis or no frame, or when something is not finite.
Result<OpenSimTable> openSimAngles(const MotionClip& clip);
/// Columns "<body>_imu" with q_ground_body.
Result<OpenSimTable> openSimOrientations(const MotionClip& clip);

/// What cells that say "NaN" are.
enum class MissingCells { kRefused, kNan };

/// kUnreadable with line.
Result<OpenSimTable> parseOpenSimTable(const std::string& text, const std::string& where,
                                       MissingCells missing = MissingCells::kRefused);

/// Writes aside, reads back, compares and only then gives the file its name.
Status writeOpenSimTable(const std::string& path, const OpenSimTable& table, bool overwrite);

}  // namespace noctule
