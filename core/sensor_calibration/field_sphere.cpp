// SPDX-License-Identifier: Apache-2.0
#include "core/sensor_calibration/field_sphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace noctule {
namespace {

/// Cells of each band. A band as high as its share of the cells has cells of equal area (Archimedes).
constexpr std::array<int, 8> kBands = {4, 10, 16, 20, 20, 16, 10, 4};
constexpr double kFullTurn_rad = 2 * std::numbers::pi;

std::vector<FieldCell> makeCells() {
    std::vector<FieldCell> cells;
    int above = 0;
    for (const int band : kBands) {
        const double top = 1 - 2.0 * above / FieldSphere::kCells;
        above += band;
        const double bottom = 1 - 2.0 * above / FieldSphere::kCells;
        for (int i = 0; i < band; ++i)
            cells.push_back({top, bottom, kFullTurn_rad * i / band, kFullTurn_rad * (i + 1) / band});
    }
    return cells;
}

}  // namespace

Vector3d FieldCell::middle() const {
    const double y = (top + bottom) / 2, across = std::sqrt(std::max(0.0, 1 - y * y));
    const double azimuth_rad = (from_rad + to_rad) / 2;
    return {across * std::sin(azimuth_rad), y, across * std::cos(azimuth_rad)};
}

Vector3d directionOf(FieldSide side) {
    const int index = static_cast<int>(side);
    return (index % 2 == 0 ? 1.0 : -1.0) * Vector3d::Unit(index / 2);
}

const std::vector<FieldCell>& FieldSphere::cells() {
    static const std::vector<FieldCell> cells = makeCells();
    return cells;
}

int FieldSphere::cellOf(const Vector3d& direction) {
    const Vector3d unit = direction.normalized();
    double azimuth_rad = std::atan2(unit.x(), unit.z());
    if (azimuth_rad < 0)
        azimuth_rad += kFullTurn_rad;
    int above = 0;
    for (const int band : kBands) {
        const bool is_last = above + band == kCells;
        if (is_last || unit.y() > 1 - 2.0 * (above + band) / kCells)
            return above + std::min(band - 1, static_cast<int>(azimuth_rad / kFullTurn_rad * band));
        above += band;
    }
    return kCells - 1;
}

int FieldSphere::seen() const {
    return static_cast<int>(std::ranges::count_if(counts_, [](int count) { return count > 0; }));
}

std::optional<FieldSide> FieldSphere::emptySide() const {
    std::array<double, 6> per_side{};
    for (int cell = 0; cell < kCells; ++cell) {
        if (count(cell) > 0)
            continue;
        const Vector3d middle = cells()[static_cast<size_t>(cell)].middle();
        for (int side = 0; side < 6; ++side)
            per_side[static_cast<size_t>(side)] +=
                std::pow(std::max(0.0, middle.dot(directionOf(static_cast<FieldSide>(side)))), 2);
    }
    if (seen() == kCells)
        return std::nullopt;
    return static_cast<FieldSide>(std::ranges::max_element(per_side) - per_side.begin());
}

void FieldSphere::keepLesser(const FieldSphere& other) {
    for (size_t cell = 0; cell < counts_.size(); ++cell)
        counts_[cell] = std::min(counts_[cell], other.counts_[cell]);
}

}  // namespace noctule
