// SPDX-License-Identifier: Apache-2.0
// Whether two places see each other or a surface stands between them; a grid of boxes finds the triangles.
#pragma once

#include <vector>

#include "core/mesh/triangle_mesh.h"

namespace noctule {

class Sight {
public:
    explicit Sight(const TriangleMesh& mesh);

    /// Triangles around `point` of the mesh do not count.
    bool isClear(uint32_t point, const Vector3d& to_m) const;

private:
    size_t boxOf(const Vector3d& p_m) const;
    bool crosses(size_t triangle, const Vector3d& from_m, const Vector3d& to_m) const;

    const TriangleMesh& mesh_;
    Vector3d min_m_;
    double box_m_ = 1;
    Eigen::Vector3i boxes_;
    std::vector<std::vector<uint32_t>> triangles_;  ///< per box
};

}  // namespace noctule
