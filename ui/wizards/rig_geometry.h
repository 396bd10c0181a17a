// SPDX-License-Identifier: Apache-2.0
// Space of the drawings: x to the right, y up, z towards the viewer, one unit is about the width of a slot of
// the plate. Board axes as printed on the plate: x along its long side to the right, y along its short side
// upwards, z out of its face; so edge A is at +y, B at -y, C at -x and D at +x.
#pragma once

#include <QPointF>
#include <QRectF>
#include <vector>

#include "core/math/conventions.h"

namespace noctule::ui {

/// How the plate is turned when the side 0..5 = +x -x +y -y +z -z is up; as +z for any other number.
Matrix3d plateTurn(int side);
bool plateStands(int side);
/// Out of the plate's edge, in the plate's axes.
Vector3d edgeDirection(char edge);
/// 'A' to 'D'; 0 when the plate lies.
char edgeDown(int side);

/// Parallel projection of a camera that stands in front of the scene, to its left and above.
class RigCamera {
public:
    RigCamera(double yaw_deg, double pitch_deg);

    /// Scales and shifts so that all points lie inside and in the middle.
    void fit(const std::vector<Vector3d>& points, const QRectF& rect_px);
    QPointF at(const Vector3d& p) const;
    /// Of a direction, in pixels.
    QPointF along(const Vector3d& v) const;
    /// Larger is nearer to the viewer.
    double nearness(const Vector3d& p) const { return p.dot(to_viewer_); }
    double scale_px() const { return scale_px_; }

private:
    Vector3d right_, up_, to_viewer_;
    double scale_px_ = 1;
    QPointF origin_px_;
};

/// The eight corners.
std::vector<Vector3d> cornersOf(const Vector3d& low, const Vector3d& high);

}  // namespace noctule::ui
