// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/rig_geometry.h"

#include <algorithm>
#include <cmath>

namespace noctule::ui {

Matrix3d plateTurn(int side) {
    const Vector3d right = Vector3d::UnitX(), up = Vector3d::UnitY(), near = Vector3d::UnitZ();
    Matrix3d turn;
    switch (side) {
        case 0:
            turn << up, -right, near;
            break;
        case 1:
            turn << -up, right, near;
            break;
        case 2:
            turn << right, up, near;
            break;
        case 3:
            turn << -right, -up, near;
            break;
        case 5:
            turn << right, near, -up;
            break;
        default:
            turn << right, -near, up;
    }
    return turn;
}

bool plateStands(int side) {
    return side >= 0 && side < 4;
}

Vector3d edgeDirection(char edge) {
    switch (edge) {
        case 'A':
            return Vector3d::UnitY();
        case 'B':
            return -Vector3d::UnitY();
        case 'C':
            return -Vector3d::UnitX();
        default:
            return Vector3d::UnitX();
    }
}

char edgeDown(int side) {
    for (const char edge : {'A', 'B', 'C', 'D'})
        if ((plateTurn(side) * edgeDirection(edge)).y() < -0.5)
            return edge;
    return 0;
}

RigCamera::RigCamera(double yaw_deg, double pitch_deg) {
    const double yaw = radians(yaw_deg), pitch = radians(pitch_deg);
    right_ = {std::cos(yaw), 0, std::sin(yaw)};
    to_viewer_ = {-std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
    up_ = to_viewer_.cross(right_);
}

void RigCamera::fit(const std::vector<Vector3d>& points, const QRectF& rect_px) {
    double left = 1e9, right = -1e9, low = 1e9, high = -1e9;
    for (const Vector3d& p : points) {
        left = std::min(left, p.dot(right_)), right = std::max(right, p.dot(right_));
        low = std::min(low, p.dot(up_)), high = std::max(high, p.dot(up_));
    }
    scale_px_ = std::max(1.0, std::min(rect_px.width() / (right - left), rect_px.height() / (high - low)));
    origin_px_ = rect_px.center() + scale_px_ * QPointF(-(left + right) / 2, (low + high) / 2);
}

QPointF RigCamera::along(const Vector3d& v) const {
    return scale_px_ * QPointF(v.dot(right_), -v.dot(up_));
}

QPointF RigCamera::at(const Vector3d& p) const {
    return origin_px_ + along(p);
}

std::vector<Vector3d> cornersOf(const Vector3d& low, const Vector3d& high) {
    std::vector<Vector3d> corners;
    for (int i = 0; i < 8; ++i)
        corners.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                             i & 4 ? high.z() : low.z());
    return corners;
}

}  // namespace noctule::ui
