// SPDX-License-Identifier: Apache-2.0
#include "core/render/camera.h"

#include <algorithm>
#include <cmath>

namespace noctule {

namespace {

constexpr double kSteepest_rad = std::numbers::pi / 2;
constexpr double kFar_m = 120;

double halfHeight(const Camera& camera) {
    return std::tan(camera.fov_y_rad / 2);
}

/// Into -pi..pi.
double wrapped(double angle_rad) {
    return std::remainder(angle_rad, 2 * std::numbers::pi);
}

}  // namespace

double SightLine::distanceTo(const Vector3d& p_m) const {
    const Vector3d to_point = p_m - origin_m;
    return (to_point - to_point.dot(direction) * direction).norm();
}

Matrix3d Camera::axes() const {
    const double ca = std::cos(azimuth_rad), sa = std::sin(azimuth_rad);
    const double ce = std::cos(elevation_rad), se = std::sin(elevation_rad);
    const Vector3d towards_viewer(sa * ce, se, ca * ce);
    const Vector3d right(ca, 0, -sa);
    Matrix3d axes;
    axes << right, towards_viewer.cross(right), towards_viewer;
    return axes;
}

Vector3d Camera::eye_m() const {
    return target_m + distance_m * axes().col(2);
}

Eigen::Matrix4d Camera::viewMatrix() const {
    const Matrix3d turn = axes().transpose();
    Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
    view.topLeftCorner<3, 3>() = turn;
    view.topRightCorner<3, 1>() = -(turn * eye_m());
    return view;
}

Eigen::Matrix4d Camera::projectionMatrix(const PictureSize& size) const {
    const double half_height = halfHeight(*this), half_width = half_height * size.aspect();
    Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
    if (parallel) {
        projection(0, 0) = 1 / (distance_m * half_width);
        projection(1, 1) = 1 / (distance_m * half_height);
        projection(2, 2) = -1 / (distance_m + kFar_m);  // what lies behind the eye is seen as well
        projection(3, 3) = 1;
        return projection;
    }
    const double near_m = std::max(0.01, distance_m / 50), far_m = distance_m + kFar_m;
    projection(0, 0) = 1 / half_width;
    projection(1, 1) = 1 / half_height;
    projection(2, 2) = -(far_m + near_m) / (far_m - near_m);
    projection(2, 3) = -2 * far_m * near_m / (far_m - near_m);
    projection(3, 2) = -1;
    return projection;
}

void Camera::orbit(double by_azimuth_rad, double by_elevation_rad) {
    azimuth_rad = wrapped(azimuth_rad + by_azimuth_rad);
    elevation_rad = std::clamp(elevation_rad + by_elevation_rad, -kSteepest_rad, kSteepest_rad);
    parallel = false;
}

void Camera::pan(double right_px, double down_px, const PictureSize& size) {
    const double metres_per_px = 2 * distance_m * halfHeight(*this) / size.height_px;
    const Matrix3d R_world_camera = axes();
    target_m += metres_per_px * (down_px * R_world_camera.col(1) - right_px * R_world_camera.col(0));
}

void Camera::zoom(double factor) {
    distance_m = std::clamp(distance_m / factor, kMinDistance_m, kMaxDistance_m);
}

void Camera::frame(const Eigen::AlignedBox3d& box, const PictureSize& size, double margin) {
    if (box.isEmpty())
        return;
    target_m = box.center();
    const double usable = 1 - 2 * margin;
    const double half_height = halfHeight(*this) * usable, half_width = half_height * size.aspect();
    const Matrix3d R_camera_world = axes().transpose();
    double distance = kMinDistance_m;
    for (int corner = 0; corner < 8; ++corner) {
        const Vector3d p =
            R_camera_world * (box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)) - target_m);
        const double needed = std::max(std::abs(p.x()) / half_width, std::abs(p.y()) / half_height);
        distance = std::max(distance, parallel ? needed : needed + p.z());
    }
    distance_m = std::min(distance, kMaxDistance_m);
}

void Camera::setView(CameraView view) {
    parallel = view != CameraView::kFree;
    if (view == CameraView::kFree)
        return;
    azimuth_rad = view == CameraView::kSide ? std::numbers::pi / 2 : 0;
    elevation_rad = view == CameraView::kTop ? kSteepest_rad : 0;
}

std::optional<Vector3d> Camera::project(const Vector3d& p_m, const PictureSize& size) const {
    const Vector3d p_camera = axes().transpose() * (p_m - eye_m());
    const double depth = -p_camera.z();
    if (!parallel && depth <= 1e-6)
        return std::nullopt;
    const double scale = size.height_px / (2 * halfHeight(*this) * (parallel ? distance_m : depth));
    return Vector3d(size.width_px / 2.0 + scale * p_camera.x(), size.height_px / 2.0 - scale * p_camera.y(),
                    depth);
}

double Camera::pixelsPerMetre(const Vector3d& p_m, const PictureSize& size) const {
    const double depth = parallel ? distance_m : std::max(1e-6, axes().col(2).dot(eye_m() - p_m));
    return size.height_px / (2 * halfHeight(*this) * depth);
}

SightLine Camera::sightLine(double x_px, double y_px, const PictureSize& size) const {
    const double half_height = halfHeight(*this);
    const double x = (2 * x_px / size.width_px - 1) * half_height * size.aspect();
    const double y = (1 - 2 * y_px / size.height_px) * half_height;
    const Matrix3d R_world_camera = axes();
    if (parallel)
        return {eye_m() + distance_m * (R_world_camera * Vector3d(x, y, 0)), -R_world_camera.col(2)};
    return {eye_m(), (R_world_camera * Vector3d(x, y, -1)).normalized()};
}

Camera Camera::between(const Camera& a, const Camera& b, double fraction) {
    if (fraction >= 1)
        return b;
    Camera camera = a;
    camera.target_m += fraction * (b.target_m - a.target_m);
    camera.distance_m = a.distance_m * std::pow(b.distance_m / a.distance_m, fraction);
    camera.azimuth_rad = wrapped(a.azimuth_rad + fraction * wrapped(b.azimuth_rad - a.azimuth_rad));
    camera.elevation_rad += fraction * (b.elevation_rad - a.elevation_rad);
    camera.fov_y_rad += fraction * (b.fov_y_rad - a.fov_y_rad);
    camera.parallel = a.parallel && b.parallel;
    return camera;
}

}  // namespace noctule
