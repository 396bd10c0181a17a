// SPDX-License-Identifier: Apache-2.0
// A run of kind `orientation` as a table: each sensor's attitude in the world, and relative to the sensor on
// the nearest segment before it in the body (Miller 2004, equation 16), as quaternions and Euler angles.
#pragma once

#include <string>

#include "core/job/job.h"
#include "core/math/euler_sequence.h"

namespace noctule {

struct OrientationCsvRequest {
    std::string take_path, run_name;  ///< empty name: the last run of the kind
    std::string csv_path;
    EulerSequence sequence;  ///< of the angles
    bool overwrite = false;
};

/// One row per sensor and reading, in order of time within each sensor. Angles in degrees, without jumps of a
/// turn. Cells of the relative attitude are empty where no sensor sits before, or it has a gap of 0.1 s.
/// kUnusable: no such run.
Status writeOrientationCsv(const OrientationCsvRequest& request, const JobContext& job);

}  // namespace noctule
