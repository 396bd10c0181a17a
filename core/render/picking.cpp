// SPDX-License-Identifier: Apache-2.0
#include "core/render/picking.h"

#include <tuple>

namespace noctule {

std::optional<PointUnderPixel> pointUnderPixel(std::span<const Vector3d> points_m, const ScreenView& view,
                                               const Eigen::Vector2d& at_px, double reach_px) {
    std::optional<PointUnderPixel> best;
    double best_depth_m = 0;
    for (size_t i = 0; i < points_m.size(); ++i) {
        const auto projected = view.camera.project(points_m[i], view.size);
        if (!projected)
            continue;
        const double distance = (projected->head<2>() - at_px).norm();
        if (distance > reach_px * view.ratio)
            continue;
        // Whole pixels: of two markers upon each other the front one is meant.
        const auto rank = std::tuple(std::round(distance / (2 * view.ratio)), projected->z());
        if (!best || rank < std::tuple(std::round(best->distance_px / (2 * view.ratio)), best_depth_m)) {
            best = PointUnderPixel{i, distance};
            best_depth_m = projected->z();
        }
    }
    return best;
}

}  // namespace noctule
