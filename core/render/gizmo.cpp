// SPDX-License-Identifier: Apache-2.0
#include "core/render/gizmo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace noctule {

namespace {

constexpr float kRingSize = 0.72F;  ///< of an arrow's length
constexpr int kRingSteps = 64;
constexpr std::array kMoves{GizmoPart::kMoveX, GizmoPart::kMoveY, GizmoPart::kMoveZ};
constexpr std::array kTurns{GizmoPart::kTurnX, GizmoPart::kTurnY, GizmoPart::kTurnZ};
/// Below this sine the axis points at the eye, or the ring is seen from its edge.
constexpr double kTooSteep = 0.12;

struct Handle {
    GizmoPart part;
    std::vector<Eigen::Vector3f> points_m;
};

float size_m(const SceneGizmo& gizmo, const ScreenView& view) {
    const double px_per_m = view.camera.pixelsPerMetre(gizmo.p_m.cast<double>(), view.size);
    return static_cast<float>(gizmo.size_px * view.ratio / px_per_m);
}

Eigen::Vector3f axisOf(const SceneGizmo& gizmo, int axis) {
    return gizmo.q_world_thing * Eigen::Vector3f::Unit(axis);
}

Handle arrow(const SceneGizmo& gizmo, int axis, float length_m) {
    const Eigen::Vector3f direction = axisOf(gizmo, axis);
    return {kMoves[static_cast<size_t>(axis)],
            {gizmo.p_m + 0.12F * length_m * direction, gizmo.p_m + length_m * direction}};
}

Handle ring(const SceneGizmo& gizmo, int axis, float radius_m) {
    const Eigen::Vector3f u = axisOf(gizmo, (axis + 1) % 3), v = axisOf(gizmo, (axis + 2) % 3);
    Handle handle{kTurns[static_cast<size_t>(axis)], {}};
    for (int i = 0; i <= kRingSteps; ++i) {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kRingSteps;
        handle.points_m.push_back(gizmo.p_m + radius_m * (std::cos(angle) * u + std::sin(angle) * v));
    }
    return handle;
}

std::vector<Handle> handles(const SceneGizmo& gizmo, const ScreenView& view) {
    const float length_m = size_m(gizmo, view);
    std::vector<Handle> all;
    for (int axis = 0; axis < 3; ++axis) {
        if (gizmo.turns)
            all.push_back(ring(gizmo, axis, kRingSize * length_m));
        all.push_back(arrow(gizmo, axis, length_m));
    }
    return all;
}

int axisIndex(GizmoPart part) {
    return part == GizmoPart::kNone ? -1 : (static_cast<int>(part) - 1) % 3;
}

bool isTurn(GizmoPart part) {
    return part >= GizmoPart::kTurnX;
}

Rgba colorOf(const SceneGizmo& gizmo, GizmoPart part) {
    return part == gizmo.hot ? gizmo.active : std::array{gizmo.x, gizmo.y, gizmo.z}[axisIndex(part)];
}

/// The far half of a ring is pale, so that the eye sees which way it turns.
Rgba ringColor(const SceneGizmo& gizmo, const Handle& handle, size_t point, const ScreenView& view) {
    const Vector3d outward = (handle.points_m[point] - gizmo.p_m).cast<double>();
    const bool is_near = outward.dot(view.camera.axes().col(2)) > -1e-3 * outward.norm();
    return colorOf(gizmo, handle.part).faded(is_near ? 1.0F : 0.3F);
}

/// Two short strokes at the end of an arrow.
void appendHead(const Handle& arrow, const LineShape& shaft, const ScreenView& view,
                std::vector<LineShape>& out) {
    const Eigen::Vector3f along = arrow.points_m[1] - arrow.points_m[0];
    const Eigen::Vector3f across =
        along.cross(view.camera.axes().col(2).cast<float>()).normalized() * along.norm() * 0.09F;
    for (const float side : {-1.0F, 1.0F}) {
        LineShape stroke = shaft;
        stroke.from_m = arrow.points_m[1] - 0.16F * along + side * across;
        stroke.to_m = arrow.points_m[1];
        out.push_back(stroke);
    }
}

double distanceToSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const Eigen::Vector2d along = b - a;
    const double t = std::clamp((p - a).dot(along) / std::max(1e-9, along.squaredNorm()), 0.0, 1.0);
    return (p - a - t * along).norm();
}

/// Where along the axis (metres from its origin) a line of sight passes nearest.
std::optional<double> alongAxis(const Eigen::Isometry3d& T_world_thing, const Vector3d& axis,
                                const SightLine& sight) {
    const double cosine = axis.dot(sight.direction);
    const double sine_squared = 1 - cosine * cosine;
    if (sine_squared < kTooSteep * kTooSteep)
        return std::nullopt;
    const Vector3d to_thing = T_world_thing.translation() - sight.origin_m;
    return (cosine * to_thing.dot(sight.direction) - to_thing.dot(axis)) / sine_squared;
}

/// Angle about the axis at which a line of sight meets the ring's plane.
std::optional<double> aroundAxis(const Eigen::Isometry3d& T_world_thing, int axis, const SightLine& sight) {
    const Matrix3d R = T_world_thing.linear();
    const double slope = R.col(axis).dot(sight.direction);
    if (std::abs(slope) < kTooSteep)
        return std::nullopt;
    const double distance = R.col(axis).dot(T_world_thing.translation() - sight.origin_m) / slope;
    const Vector3d p = sight.origin_m + distance * sight.direction - T_world_thing.translation();
    return std::atan2(p.dot(R.col((axis + 2) % 3)), p.dot(R.col((axis + 1) % 3)));
}

/// A ring seen from its edge turns by the way along it on the screen, one radian per half length of an arrow.
double edgeOnTurn(const Eigen::Isometry3d& T_world_thing, int axis, const ScreenView& view,
                  const Eigen::Vector2d& moved_px) {
    const Vector3d axis_camera = view.camera.axes().transpose() * T_world_thing.linear().col(axis);
    const Eigen::Vector2d along_ring(-axis_camera.y(), -axis_camera.x());  // pixels count downwards
    constexpr double kPxPerRadian = 50;
    return -moved_px.dot(along_ring.normalized()) / (kPxPerRadian * view.ratio);
}

}  // namespace

std::vector<LineShape> gizmoLines(const SceneGizmo& gizmo, const ScreenView& view) {
    std::vector<LineShape> lines;
    const auto ratio = static_cast<float>(view.ratio);
    for (const Handle& handle : handles(gizmo, view)) {
        const float width_px = (handle.part == gizmo.hot ? 3.0F : 2.0F) * ratio;
        for (size_t i = 1; i < handle.points_m.size(); ++i) {
            const bool turns = isTurn(handle.part);
            const Rgba plain = colorOf(gizmo, handle.part);
            lines.push_back({handle.points_m[i - 1], handle.points_m[i],
                             turns ? ringColor(gizmo, handle, i - 1, view) : plain,
                             turns ? ringColor(gizmo, handle, i, view) : plain, width_px, 0});
        }
        if (!isTurn(handle.part))
            appendHead(handle, LineShape(lines.back()), view, lines);
    }
    return lines;
}

GizmoPart gizmoPartAt(const SceneGizmo& gizmo, const ScreenView& view, const Eigen::Vector2d& at_px,
                      double reach_px) {
    GizmoPart nearest = GizmoPart::kNone;
    double least = reach_px * view.ratio;
    for (const Handle& handle : handles(gizmo, view)) {
        // An arrow's shaft crosses the rings: where both are in reach the arrow wins.
        const double handicap = isTurn(handle.part) ? 2 * view.ratio : 0;
        for (size_t i = 1; i < handle.points_m.size(); ++i) {
            const auto a = view.camera.project(handle.points_m[i - 1].cast<double>(), view.size);
            const auto b = view.camera.project(handle.points_m[i].cast<double>(), view.size);
            if (!a || !b)
                continue;
            const double distance = distanceToSegment(at_px, a->head<2>(), b->head<2>()) + handicap;
            if (distance < least) {
                least = distance;
                nearest = handle.part;
            }
        }
    }
    return nearest;
}

Eigen::Isometry3d dragGizmo(const Eigen::Isometry3d& T_world_thing, GizmoPart part, const ScreenView& view,
                            const Eigen::Vector2d& from_px, const Eigen::Vector2d& to_px) {
    const int axis = axisIndex(part);
    Eigen::Isometry3d result = T_world_thing;
    if (axis < 0)
        return result;
    const SightLine from = view.camera.sightLine(from_px.x(), from_px.y(), view.size);
    const SightLine to = view.camera.sightLine(to_px.x(), to_px.y(), view.size);
    const Vector3d direction = T_world_thing.linear().col(axis);
    if (!isTurn(part)) {
        const auto a = alongAxis(T_world_thing, direction, from), b = alongAxis(T_world_thing, direction, to);
        if (a && b)
            result.translation() += (*b - *a) * direction;
        return result;
    }
    const auto a = aroundAxis(T_world_thing, axis, from), b = aroundAxis(T_world_thing, axis, to);
    const double turn = a && b ? *b - *a : edgeOnTurn(T_world_thing, axis, view, to_px - from_px);
    result.linear() =
        T_world_thing.linear() * Eigen::AngleAxisd(turn, Vector3d::Unit(axis)).toRotationMatrix();
    return result;
}

}  // namespace noctule
