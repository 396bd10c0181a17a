// SPDX-License-Identifier: Apache-2.0
// How a board rides on its flesh: tilt and shift in the segment's frame, from zero in the rest pose, linear
// in half the sines of the turns (halfSines) of the joints at both ends of the segment.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/job/result.h"
#include "core/math/conventions.h"

namespace noctule {

using Matrix36 = Eigen::Matrix<double, 3, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

struct BoardFlesh {
    /// The joint that turns the segment, and the first one that turns below it; empty: none there.
    std::array<std::string, 2> joints;
    /// Per unit of a feature: x, y, z of the first joint, then of the second.
    Matrix36 tilt_rad = Matrix36::Zero(), shift_m = Matrix36::Zero();
};

nlohmann::json toJson(const BoardFlesh& flesh);
/// Empty for an empty object. Errors name `where` and go to `first_error`.
std::optional<BoardFlesh> fleshFromJson(const nlohmann::json& json, const std::string& where,
                                        std::optional<Error>& first_error);

}  // namespace noctule
