// SPDX-License-Identifier: Apache-2.0
// Reads MATLAB files of level 5 (-v6, -v7): real numeric arrays and structs of them, by dotted name. Other
// classes are skipped. Source: MathWorks, "MAT-File Format", level 5.
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <string_view>

#include "core/job/result.h"

namespace noctule {

/// What one file may hold; a larger one is refused. A hundred sensors for an hour at 1 kHz stay far below.
struct MatLimits {
    size_t unpacked_bytes = size_t{2} << 30;
    int nesting = 8;
};

/// Arrays by name: "imu_gyr", or "data.hip.gyr" for members of structs. More than two dimensions are unrolled
/// into the columns. Errors: kUnreadable with the file's name, the offset of what is wrong and the remedy.
using MatArrays = std::map<std::string, Eigen::MatrixXd>;
Result<MatArrays> parseMat(std::string_view bytes, const std::string& name, const MatLimits& limits = {});

}  // namespace noctule
