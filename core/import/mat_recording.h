// SPDX-License-Identifier: Apache-2.0
// Finds inertial sensors in the arrays of a MATLAB file by their names and shapes: N x 3 arrays whose names
// hold gyr, acc and mag, one sensor for each struct or prefix. BROAD's trials and qmt's full body are such
// files.
#pragma once

#include "core/import/mat_file.h"
#include "core/import/recording.h"

namespace noctule {

/// The rate comes from `sampling_rate` (or fs, rate) or from `t` (or time); `rate_hz` above 0 replaces it.
/// BROAD's opt_quat, opt_pos (east, north, up) and movement become the reference. kUnreadable: no sensor, no
/// rate, or arrays of different lengths; the message names the arrays.
Result<ImportedRecording> recordingFromMat(const MatArrays& arrays, const std::string& name,
                                           double rate_hz = 0);

}  // namespace noctule
