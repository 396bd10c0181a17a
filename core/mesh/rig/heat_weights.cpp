// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/rig/heat_weights.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "core/mesh/rig/sight.h"

namespace noctule {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Where a point gets its warmth from.
struct Warmth {
    int bone = 0;
    double strength = 0;
};

Vector3d nearestOn(const BoneLine& line, const Vector3d& p_m) {
    const Vector3d along = line.to_m - line.from_m;
    const double length_squared = along.squaredNorm();
    const double f = length_squared > 0 ? (p_m - line.from_m).dot(along) / length_squared : 0;
    return line.from_m + std::clamp(f, 0.0, 1.0) * along;
}

std::vector<Vector3d> outwards(const TriangleMesh& mesh) {
    std::vector<Vector3d> normals(mesh.points.size(), Vector3d::Zero());
    for (const auto& t : mesh.triangles) {
        const Vector3d normal =
            (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]);
        for (const uint32_t corner : t)
            normals[corner] += normal;
    }
    return normals;
}

/// The nearest bone that the point sees through the body; what sees none (within a mouth) has the nearest.
Warmth warmthOf(const TriangleMesh& mesh, const Sight& sight, const std::vector<BoneLine>& lines,
                uint32_t point, const Vector3d& outward, const HeatSettings& settings) {
    constexpr size_t kTries = 6;
    std::vector<std::pair<double, size_t>> nearest;
    for (size_t l = 0; l < lines.size(); ++l)
        nearest.emplace_back((nearestOn(lines[l], mesh.points[point]) - mesh.points[point]).norm(), l);
    std::sort(nearest.begin(), nearest.end());
    const double least = 1e-3 * (nearest.front().first + 1e-6);
    for (size_t i = 0; i < std::min(kTries, nearest.size()); ++i) {
        const BoneLine& line = lines[nearest[i].second];
        const Vector3d at = nearestOn(line, mesh.points[point]);
        const double distance = std::max(nearest[i].first, least);
        if (outward.dot(at - mesh.points[point]) <= 0 && sight.isClear(point, at))
            return {line.bone, settings.warmth / (distance * distance)};
    }
    const double distance = std::max(nearest.front().first, least);
    return {lines[nearest.front().second].bone, settings.warmth / (distance * distance)};
}

/// Cotangent of the angle at a; limited, so that slivers do not rule.
double cotangent(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const Vector3d u = b - a, v = c - a;
    return std::clamp(u.dot(v) / std::max(1e-12, u.cross(v).norm()), -2.0, 20.0);
}

struct HeatSystem {
    std::vector<Eigen::Triplet<double>> spread;
    Eigen::VectorXd area;
};

HeatSystem heatSystem(const TriangleMesh& mesh) {
    HeatSystem system;
    system.area = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(mesh.points.size()));
    for (const auto& t : mesh.triangles) {
        const auto p = [&](size_t i) -> const Vector3d& { return mesh.points[t[i % 3]]; };
        const double area = (p(1) - p(0)).cross(p(2) - p(0)).norm() / 2;
        for (size_t i = 0; i < 3; ++i) {
            // The edge opposite to corner i; kept above zero, so that weights stay between 0 and 1.
            const double w = std::max(1e-3, 0.5 * cotangent(p(i), p(i + 1), p(i + 2)));
            const auto a = static_cast<int>(t[(i + 1) % 3]), b = static_cast<int>(t[(i + 2) % 3]);
            system.spread.insert(system.spread.end(), {{a, a, w}, {b, b, w}, {a, b, -w}, {b, a, -w}});
            system.area[t[i]] += area / 3;
        }
    }
    return system;
}

}  // namespace

Result<Eigen::MatrixXd> heatWeights(const TriangleMesh& mesh, const std::vector<BoneLine>& lines, int bones,
                                    const HeatSettings& settings, const JobContext& job) {
    require(!lines.empty() && bones > 0, "heatWeights() needs bones");
    const Sight sight(mesh);
    const std::vector<Vector3d> outward = outwards(mesh);
    HeatSystem system = heatSystem(mesh);
    const auto count = static_cast<Eigen::Index>(mesh.points.size());
    Eigen::MatrixXd warm = Eigen::MatrixXd::Zero(count, bones);
    const double least_area = std::max(1e-300, 1e-9 * system.area.sum());
    for (uint32_t p = 0; p < mesh.points.size(); ++p) {
        if (p % 1024 == 0) {
            if (job.cancelled())
                return JobContext::cancelledError();
            job.progress(0.5 * p / static_cast<double>(mesh.points.size()), "Looking for each point's bone");
        }
        const Warmth warmth = warmthOf(mesh, sight, lines, p, outward[p], settings);
        const double strength = warmth.strength * std::max(least_area, system.area[p]);
        warm(p, warmth.bone) = strength;
        system.spread.emplace_back(static_cast<int>(p), static_cast<int>(p), strength);
    }
    Sparse matrix(count, count);
    matrix.setFromTriplets(system.spread.begin(), system.spread.end());
    job.progress(0.5, "Spreading heat");
    const Eigen::SimplicialLDLT<Sparse> solver(matrix);
    if (solver.info() != Eigen::Success)
        return Error{ErrorKind::kUnusable, "Weights cannot be found: the surface has no area",
                     "Repair the mesh: it must be the closed surface of a body"};
    Eigen::MatrixXd weights(count, bones);
    for (int b = 0; b < bones; ++b) {
        if (job.cancelled())
            return JobContext::cancelledError();
        weights.col(b) = solver.solve(warm.col(b));
        job.progress(0.6 + 0.4 * (b + 1) / bones, "Spreading heat");
    }
    weights = weights.cwiseMax(0);
    const Eigen::VectorXd sums = weights.rowwise().sum();
    if (!sums.allFinite() || sums.minCoeff() <= 0)
        return Error{ErrorKind::kUnusable, "Weights cannot be found: parts of the surface stay cold",
                     "Repair the mesh: it must be the closed surface of a body"};
    return Eigen::MatrixXd(sums.cwiseInverse().asDiagonal() * weights);
}

}  // namespace noctule
