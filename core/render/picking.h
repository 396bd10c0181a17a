// SPDX-License-Identifier: Apache-2.0
// Which of several points in a scene lies under a pixel. Pure.
#pragma once

#include <optional>
#include <span>

#include "core/render/screen_shapes.h"

namespace noctule {

/// Distance on the screen; of equally near points the one nearer to the eye. `reach_px` is multiplied by the
/// view's ratio.
struct PointUnderPixel {
    size_t index = 0;
    double distance_px = 0;
};
std::optional<PointUnderPixel> pointUnderPixel(std::span<const Vector3d> points_m, const ScreenView& view,
                                               const Eigen::Vector2d& at_px, double reach_px);

}  // namespace noctule
