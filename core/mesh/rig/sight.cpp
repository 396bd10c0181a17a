// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/rig/sight.h"

#include <algorithm>
#include <cmath>

namespace noctule {
namespace {

constexpr int kBoxesAlong = 64;  ///< of the longest side

}  // namespace

Sight::Sight(const TriangleMesh& mesh) : mesh_(mesh) {
    Eigen::AlignedBox3d box;
    for (const Vector3d& p : mesh.points)
        box.extend(p);
    min_m_ = box.min();
    box_m_ = std::max(1e-9, box.sizes().maxCoeff() / kBoxesAlong);
    boxes_ = (box.sizes() / box_m_).cast<int>() + Eigen::Vector3i::Ones();
    triangles_.resize(static_cast<size_t>(boxes_.prod()));
    for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        Eigen::AlignedBox3d around;
        for (const uint32_t corner : mesh.triangles[t])
            around.extend(mesh.points[corner]);
        const Eigen::Vector3i first = ((around.min() - min_m_) / box_m_).cast<int>();
        const Eigen::Vector3i last = ((around.max() - min_m_) / box_m_).cast<int>();
        for (int x = first.x(); x <= last.x(); ++x)
            for (int y = first.y(); y <= last.y(); ++y)
                for (int z = first.z(); z <= last.z(); ++z)
                    triangles_[boxOf(min_m_ + box_m_ * Vector3d(x + 0.5, y + 0.5, z + 0.5))].push_back(t);
    }
}

size_t Sight::boxOf(const Vector3d& p_m) const {
    const Eigen::Vector3i box =
        ((p_m - min_m_) / box_m_).cast<int>().cwiseMax(0).cwiseMin(boxes_ - Eigen::Vector3i::Ones());
    return static_cast<size_t>((box.x() * boxes_.y() + box.y()) * boxes_.z() + box.z());
}

/// Moeller & Trumbore 1997, "Fast, minimum storage ray/triangle intersection".
bool Sight::crosses(size_t triangle, const Vector3d& from_m, const Vector3d& to_m) const {
    const auto& corners = mesh_.triangles[triangle];
    const Vector3d& a = mesh_.points[corners[0]];
    const Vector3d ab = mesh_.points[corners[1]] - a, ac = mesh_.points[corners[2]] - a, ray = to_m - from_m;
    const Vector3d h = ray.cross(ac);
    const double det = ab.dot(h);
    if (std::abs(det) < 1e-18)
        return false;
    const Vector3d s = (from_m - a) / det;
    const double u = s.dot(h);
    const Vector3d q = s.cross(ab);
    const double v = ray.dot(q), t = ac.dot(q);
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 && t < 1;
}

bool Sight::isClear(uint32_t point, const Vector3d& to_m) const {
    const Vector3d& from_m = mesh_.points[point];
    const int steps = std::max(1, static_cast<int>(2 * (to_m - from_m).norm() / box_m_));
    size_t last = triangles_.size();
    for (int i = 0; i <= steps; ++i) {
        const size_t box = boxOf(from_m + (to_m - from_m) * i / steps);
        if (box == last)
            continue;
        last = box;
        for (const uint32_t t : triangles_[box]) {
            const auto& corners = mesh_.triangles[t];
            if (std::find(corners.begin(), corners.end(), point) == corners.end() && crosses(t, from_m, to_m))
                return false;
        }
    }
    return true;
}

}  // namespace noctule
