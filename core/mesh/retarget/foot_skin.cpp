// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/retarget/foot_skin.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr int kDirections = 96;  ///< in which the lowest vertex is looked for
constexpr int kSteps = 32;       ///< in which a turn is tried

/// Spread evenly over the half below the horizon (a spiral of golden angles).
Vector3d downwards(int i) {
    const double y = -(i + 0.5) / kDirections, turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const double level = std::sqrt(1 - y * y);
    return {level * std::cos(turn), y, level * std::sin(turn)};
}

}  // namespace

std::vector<Vector3d> lowestSkin(const RiggedMesh& mesh, const std::vector<bool>& nodes, const Vector3d& up) {
    std::vector<Vector3d> points;
    for (const SkinnedVertex& vertex : mesh.skin.vertices) {
        float share = 0;
        for (size_t i = 0; i < vertex.bones.size(); ++i)
            if (vertex.weights[i] > 0 && nodes[static_cast<size_t>(mesh.node_of_bone[vertex.bones[i]])])
                share += vertex.weights[i];
        if (share > 0.49F)  // a seam belongs to both sides
            points.push_back(vertex.p_m.cast<double>());
    }
    const Quaterniond turned = smallestRotation(Vector3d::UnitY(), up);
    std::set<size_t> chosen;
    for (int i = 0; i < kDirections && !points.empty(); ++i) {
        const Vector3d direction = turned * downwards(i);
        const auto lowest =
            std::ranges::max_element(points, {}, [&](const Vector3d& p) { return p.dot(direction); });
        chosen.insert(static_cast<size_t>(lowest - points.begin()));
    }
    std::vector<Vector3d> lowest;
    for (const size_t i : chosen)
        lowest.push_back(points[i]);
    return lowest;
}

double turnAboveFloor(const std::vector<Vector3d>& points, const Vector3d& centre, const Vector3d& axis,
                      double floor_m, double most_rad) {
    std::vector<Eigen::Vector2d> arms;  // at right angles to the axis: up, and whither a turn takes that
    for (const Vector3d& p : points)
        arms.emplace_back(p.y() - centre.y(), axis.cross(p - centre).y());
    const auto lowest = [&](double turn) {
        const Eigen::Vector2d up(std::cos(turn), std::sin(turn));
        double low_m = 1e9;
        for (const Eigen::Vector2d& arm : arms)
            low_m = std::min(low_m, arm.dot(up));
        return centre.y() + low_m - floor_m;
    };
    double best = 0, best_m = lowest(0), before_m = best_m;
    for (int step = 1; step <= kSteps && best_m < 0; ++step) {
        const double turn = most_rad * step / kSteps, low_m = lowest(turn);
        if (low_m > best_m) {
            const double needed = low_m > 0 ? before_m / (before_m - low_m) : 1;
            best = most_rad * (step - 1 + needed) / kSteps;
            best_m = low_m;
        }
        before_m = low_m;
    }
    return best;
}

}  // namespace noctule
