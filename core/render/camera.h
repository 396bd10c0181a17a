// SPDX-License-Identifier: Apache-2.0
// A camera that orbits a target, as in animation programs: plain values and pure maths. Y is up. At azimuth 0
// it stands before the performer (on +Z), at 90 degrees on the performer's left (+X); elevation lifts it.
// Pixels count from the top left corner of the picture.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "core/math/conventions.h"
#include "core/media/picture.h"

namespace noctule {

enum class CameraView { kFree, kFront, kSide, kTop };

/// A half-line from the eye into the scene.
struct SightLine {
    Vector3d origin_m, direction;
    /// Distance of a point from the line.
    double distanceTo(const Vector3d& p_m) const;
};

struct Camera {
    Vector3d target_m{0, 0.95, 0};
    double distance_m = 4;
    double azimuth_rad = 0.45;
    double elevation_rad = 0.12;
    double fov_y_rad = radians(32);  ///< vertical opening; the parallel view is as high at the target
    bool parallel = false;           ///< orthographic: lengths can be compared

    static constexpr double kMinDistance_m = 0.15, kMaxDistance_m = 60;

    Matrix3d axes() const;  ///< columns: right, up, towards the viewer
    Vector3d eye_m() const;
    Eigen::Matrix4d viewMatrix() const;
    Eigen::Matrix4d projectionMatrix(const PictureSize& size) const;

    /// A turn about the target; elevation stays within straight up and down. Leaves the parallel view.
    void orbit(double azimuth_rad, double elevation_rad);
    /// Moves so that the target's depth follows the mouse.
    void pan(double right_px, double down_px, const PictureSize& size);
    /// Factor above 1: nearer.
    void zoom(double factor);
    /// Target and distance such that the box fits with a margin (fraction of the picture).
    void frame(const Eigen::AlignedBox3d& box, const PictureSize& size, double margin = 0.08);
    /// Direction and projection of a preset; kFree changes only the projection.
    void setView(CameraView view);

    /// x, y in pixels and distance along the view; nothing behind the eye.
    std::optional<Vector3d> project(const Vector3d& p_m, const PictureSize& size) const;
    double pixelsPerMetre(const Vector3d& p_m, const PictureSize& size) const;
    SightLine sightLine(double x_px, double y_px, const PictureSize& size) const;

    /// On the way from a to b, fraction 0..1; the azimuth takes the short way.
    static Camera between(const Camera& a, const Camera& b, double fraction);
};

}  // namespace noctule
