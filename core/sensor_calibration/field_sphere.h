// SPDX-License-Identifier: Apache-2.0
// Directions that the Earth's field was seen from, in a sensor's own axes, on a sphere of 100 cells of equal
// solid angle. Cells lie in eight bands about the sensor's y axis, from its upper pole down.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/math/conventions.h"

namespace noctule {

/// Where a cell lies: heights are of the unit sphere's y, azimuths run from z towards x.
struct FieldCell {
    double top = 1, bottom = -1;
    double from_rad = 0, to_rad = 0;

    Vector3d middle() const;
};

/// A side of a sensor: its axes, the upper side is +y, the front +z, the right +x.
enum class FieldSide { kRight, kLeft, kUpper, kLower, kFront, kBack };
Vector3d directionOf(FieldSide side);

class FieldSphere {
public:
    static constexpr int kCells = 100;
    static const std::vector<FieldCell>& cells();
    /// Of a direction of any length above zero.
    static int cellOf(const Vector3d& direction);

    void add(const Vector3d& direction) { ++counts_[static_cast<size_t>(cellOf(direction))]; }
    int count(int cell) const { return counts_[static_cast<size_t>(cell)]; }
    int seen() const;
    double share() const { return static_cast<double>(seen()) / kCells; }
    /// The side about which most is missing; none: every cell was seen.
    std::optional<FieldSide> emptySide() const;
    /// The lesser count of each cell.
    void keepLesser(const FieldSphere& other);

private:
    std::array<int, kCells> counts_{};
};

}  // namespace noctule
