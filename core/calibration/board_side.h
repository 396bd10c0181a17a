// SPDX-License-Identifier: Apache-2.0
// One of the six sides of a board: an axis of the board's frame that points up, or down. What the operator
// reads as "+x" is the side whose +x axis points up.
#pragma once

#include <array>
#include <string>

#include "core/math/conventions.h"

namespace noctule {

struct BoardSide {
    int axis = 0;   ///< 0 x, 1 y, 2 z
    int sign = +1;  ///< -1: it points down

    Vector3d up() const { return sign * Vector3d::Unit(axis); }
    BoardSide opposite() const { return {axis, -sign}; }
    /// "+x"
    std::string name() const { return std::string(sign > 0 ? "+" : "-") + "xyz"[axis]; }
    bool operator==(const BoardSide&) const = default;

    /// The side that is closest to a direction in the board's frame, of any length but 0.
    static BoardSide nearest(const Vector3d& direction) {
        Eigen::Index axis = 0;
        direction.cwiseAbs().maxCoeff(&axis);
        return {static_cast<int>(axis), direction[axis] < 0 ? -1 : +1};
    }
};

inline constexpr std::array<BoardSide, 6> kBoardSides{{{0, +1}, {0, -1}, {1, +1}, {1, -1}, {2, +1}, {2, -1}}};

}  // namespace noctule
