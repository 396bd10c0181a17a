// SPDX-License-Identifier: Apache-2.0
#include "core/render/screen_shapes.h"

#include <algorithm>
#include <cmath>

namespace noctule {

namespace {

constexpr float kDash_px = 4;
/// Markers lie on the skin; this much nearer, the skin does not hide them.
constexpr double kShapeInFrontOfSkin_m = 0.04;

float smooth(float t) {
    t = std::clamp(t, 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

/// One line of the grid in pieces of a step, each end faded by its distance from the centre.
void appendGridLine(const SceneGrid& grid, const Rgba& color, bool along_x, float across, float centre_across,
                    float centre_along, std::vector<LineShape>& out) {
    const auto faded = [&](float along) {
        const float r = std::hypot(along - centre_along, across - centre_across) / grid.radius_m;
        return color.faded(1 - smooth((r - 0.15F) / 0.85F));
    };
    const int steps = static_cast<int>(grid.radius_m / grid.step_m);
    for (int i = -steps; i < steps; ++i) {
        const float a = centre_along + static_cast<float>(i) * grid.step_m, b = a + grid.step_m;
        LineShape line;
        line.from_m = along_x ? Eigen::Vector3f(a, 0, across) : Eigen::Vector3f(across, 0, a);
        line.to_m = along_x ? Eigen::Vector3f(b, 0, across) : Eigen::Vector3f(across, 0, b);
        line.from_color = faded(a);
        line.to_color = faded(b);
        if (line.from_color.a > 0 || line.to_color.a > 0)
            out.push_back(line);
    }
}

float ndcDepth(const ScreenView& view, const Vector3d& p_m) {
    const Vector3d nearer = p_m + kShapeInFrontOfSkin_m * view.camera.axes().col(2);
    const Eigen::Vector4d clip =
        view.camera.projectionMatrix(view.size) * view.camera.viewMatrix() * nearer.homogeneous();
    return static_cast<float>(clip.z() / clip.w());
}

/// A marker's place; nothing when it is behind the eye.
std::optional<MarkerShape> markerAt(const Eigen::Vector3f& p_m, const ScreenView& view) {
    const Vector3d p = p_m.cast<double>();
    const auto projected = view.camera.project(p, view.size);
    if (!projected)
        return std::nullopt;
    MarkerShape marker;
    marker.centre_px = projected->head<2>().cast<float>();
    marker.distance_m = static_cast<float>(projected->z());
    marker.depth = ndcDepth(view, p);
    return marker;
}

std::optional<MarkerShape> boardMarker(const SceneBoard& board, const ScreenView& view) {
    auto marker = markerAt(board.p_m, view);
    if (!marker)
        return marker;
    const auto ratio = static_cast<float>(view.ratio);
    const auto px_per_m = static_cast<float>(view.camera.pixelsPerMetre(board.p_m.cast<double>(), view.size));
    const float enlarged = std::max(1.0F, board.min_px * ratio / (board.size_m.maxCoeff() * px_per_m));
    // A rounded box is a flat rectangle rolled over by a ball; so is its contour. Seen from its edge it is
    // still a board, not a stroke.
    const float scale = enlarged * px_per_m;
    marker->radius_px = std::max(board.min_px * ratio / 4, board.size_m.z() / 2 * scale);
    const Eigen::Vector2f half_px =
        (0.5F * scale * board.size_m.head<2>()).array().max(marker->radius_px) - marker->radius_px;
    const Eigen::Matrix3f R_camera_board =
        view.camera.axes().transpose().cast<float>() * board.q_world_board.toRotationMatrix();
    constexpr std::array<std::array<float, 2>, 4> kCorners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (size_t i = 0; i < 4; ++i) {
        const Eigen::Vector3f p =
            R_camera_board * Eigen::Vector3f(kCorners[i][0] * half_px.x(), kCorners[i][1] * half_px.y(), 0);
        marker->corner[i] = {p.x(), -p.y()};
    }
    marker->fill = board.fill;
    marker->edge = board.edge;
    marker->edge_px = board.edge_px * ratio;
    return marker;
}

std::optional<MarkerShape> sourceMarker(const SceneSource& source, const ScreenView& view) {
    auto marker = markerAt(source.p_m, view);
    if (!marker)
        return marker;
    const auto ratio = static_cast<float>(view.ratio);
    const auto px_per_m =
        static_cast<float>(view.camera.pixelsPerMetre(source.p_m.cast<double>(), view.size));
    const float radius_px = std::max(source.min_px * ratio / 2, source.radius_m * px_per_m);
    const Eigen::Vector3f normal = view.camera.axes().transpose().cast<float>() * source.normal;
    const float tilt = normal.head<2>().norm();
    const Eigen::Vector2f along =
        tilt > 1e-4F ? Eigen::Vector2f(normal.y() / tilt, normal.x() / tilt) : Eigen::Vector2f(1, 0);
    marker->half_axis_px = along * radius_px;
    marker->minor_px = radius_px * std::max(0.5F, std::abs(normal.z()));  // never a mere stroke
    marker->fill = source.fill;
    marker->edge = source.edge;
    marker->edge_px = source.edge_px * ratio;
    return marker;
}

void makeRound(MarkerShape& marker, float radius_px) {
    marker.half_axis_px = {radius_px, 0};
    marker.minor_px = radius_px;
}

void farthestFirst(std::vector<MarkerShape>& markers) {
    std::stable_sort(markers.begin(), markers.end(),
                     [](const auto& a, const auto& b) { return a.distance_m > b.distance_m; });
}

}  // namespace

std::vector<LineShape> gridLines(const SceneGrid& grid) {
    std::vector<LineShape> lines;
    const float cx = std::round(grid.centre_m.x() / grid.step_m) * grid.step_m;
    const float cz = std::round(grid.centre_m.z() / grid.step_m) * grid.step_m;
    const int steps = static_cast<int>(grid.radius_m / grid.step_m);
    for (int i = -steps; i <= steps; ++i) {
        const float x = cx + static_cast<float>(i) * grid.step_m;
        const float z = cz + static_cast<float>(i) * grid.step_m;
        const auto isAxis = [&](float across) { return std::abs(across) < grid.step_m / 4; };
        appendGridLine(grid, isAxis(z) ? grid.axis_x : grid.line, true, z, cz, cx, lines);
        appendGridLine(grid, isAxis(x) ? grid.axis_z : grid.line, false, x, cx, cz, lines);
    }
    return lines;
}

void appendLine(const SceneLine& line, double ratio, std::vector<LineShape>& out) {
    const auto scale = static_cast<float>(ratio);
    out.push_back({line.from_m, line.to_m, line.color, line.color, line.width_px * scale,
                   line.dashed ? kDash_px * scale : 0});
}

void appendTrail(const SceneTrail& trail, double ratio, std::vector<LineShape>& out) {
    const size_t count = trail.points_m.size();
    for (size_t i = 1; i < count; ++i) {
        const auto faded = [&](size_t k) {
            const float t = static_cast<float>(k) / static_cast<float>(count - 1);
            return trail.color.faded(t * t);
        };
        out.push_back({trail.points_m[i - 1], trail.points_m[i], faded(i - 1), faded(i),
                       trail.width_px * static_cast<float>(ratio), 0});
    }
}

std::vector<MarkerShape> deviceMarkers(const Scene& scene, const ScreenView& view) {
    std::vector<MarkerShape> markers;
    for (const SceneBoard& board : scene.boards)
        if (const auto marker = boardMarker(board, view))
            markers.push_back(*marker);
    for (const SceneSource& source : scene.sources)
        if (const auto marker = sourceMarker(source, view))
            markers.push_back(*marker);
    farthestFirst(markers);
    return markers;
}

std::vector<MarkerShape> jointMarkers(const Scene& scene, const ScreenView& view) {
    std::vector<MarkerShape> markers;
    for (const SceneJoint& joint : scene.joints)
        if (auto marker = markerAt(joint.p_m, view)) {
            makeRound(*marker, joint.radius_px * static_cast<float>(view.ratio));
            marker->fill = marker->edge = joint.color;
            markers.push_back(*marker);
        }
    return markers;
}

std::vector<MarkerShape> ringMarkers(const Scene& scene, const ScreenView& view) {
    std::vector<MarkerShape> markers;
    const auto ratio = static_cast<float>(view.ratio);
    for (const SceneRing& ring : scene.rings)
        if (auto marker = markerAt(ring.p_m, view)) {
            makeRound(*marker, (ring.radius_px + ring.width_px / 2) * ratio);
            marker->fill = ring.color.faded(0);
            marker->edge = ring.color;
            marker->edge_px = ring.width_px * ratio;
            markers.push_back(*marker);
        }
    return markers;
}

}  // namespace noctule
