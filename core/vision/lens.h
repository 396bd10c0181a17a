// SPDX-License-Identifier: Apache-2.0
// A camera with one focal length and radial distortion: x right, y down, z forward (as OpenCV), pixels as in
// SeenMarker. u = center + focal * (x/z, y/z) * (1 + k1 r^2 + k2 r^4) with r the length of (x/z, y/z).
#pragma once

#include <cmath>

#include "core/math/conventions.h"

namespace noctule {

struct Lens {
    double focal_px = 1000;
    Eigen::Vector2d center_px = Eigen::Vector2d::Zero();
    double k1 = 0, k2 = 0;
    /// How far beyond its place a marker's edge shows, at right angles to it: tones of the camera's own, too
    /// much light and ink that runs move it. project() leaves it out, only the bundle knows edges.
    double edge_px = 0;

    /// Order of its values where they are solved for; the first is ln(focal).
    static constexpr int kValues = 6;
    using Values = Eigen::Vector<double, kValues>;  ///< ln focal, center x, y, k1, k2, edge

    Values values() const { return {std::log(focal_px), center_px.x(), center_px.y(), k1, k2, edge_px}; }
    void add(const Values& step);
};

struct LensJacobians {
    Eigen::Matrix<double, 2, 3> J_pixel_point;
    Eigen::Matrix<double, 2, Lens::kValues> J_pixel_lens;
};

/// Points with z > 0.
Eigen::Vector2d project(const Lens& lens, const Vector3d& p_camera, LensJacobians* jacobians = nullptr);

}  // namespace noctule
