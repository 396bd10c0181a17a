// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/mannequin/decimation.h"

#include <algorithm>
#include <iterator>
#include <queue>
#include <tuple>

namespace noctule {
namespace {

/// Price of an edge's length to the fourth power, beside the quadric's area times squared distance.
constexpr double kLengthPrice = 2e-4;
/// A collapse may not turn a triangle further than this cosine.
constexpr double kLeastCosine = 0.3;

using Triangle = std::array<uint32_t, 3>;
using Matrix4 = Eigen::Matrix4d;

Vector3d areaNormal(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    return (b - a).cross(c - a);
}

struct Collapse {
    double cost;
    uint32_t keep, drop;
    uint32_t keep_version, drop_version;
    Vector3d place;
    bool operator<(const Collapse& other) const {  // the cheapest on top, ties in one order everywhere
        return std::tie(other.cost, other.keep, other.drop) < std::tie(cost, keep, drop);
    }
};

class Decimation {
public:
    Decimation(const TriangleMesh& mesh, const Importance& importance)
        : points_(mesh.points),
          triangles_(mesh.triangles),
          triangles_of_(mesh.points.size()),
          quadrics_(mesh.points.size(), Matrix4::Zero()),
          versions_(mesh.points.size(), 0),
          importance_(importance) {
        for (uint32_t t = 0; t < triangles_.size(); ++t)
            for (const uint32_t p : triangles_[t]) {
                triangles_of_[p].push_back(t);
                quadrics_[p] += quadricOf(triangles_[t]);
            }
        for (uint32_t p = 0; p < points_.size(); ++p)
            if (points_[p].x() == 0)
                quadrics_[p] += mirrorImage(quadrics_[p]);
        for (uint32_t p = 0; p < points_.size(); ++p)
            for (const uint32_t neighbour : neighbours(p))
                if (p < neighbour)
                    offer(p, neighbour);
    }

    TriangleMesh run(size_t target) {
        size_t count = triangles_.size();
        while (count > target && !queue_.empty()) {
            const Collapse collapse = queue_.top();
            queue_.pop();
            if (collapse.keep_version != versions_[collapse.keep] ||
                collapse.drop_version != versions_[collapse.drop] || !allowed(collapse))
                continue;
            count -= apply(collapse);
        }
        return compacted();
    }

private:
    Matrix4 quadricOf(const Triangle& t) const {
        const Vector3d n = areaNormal(points_[t[0]], points_[t[1]], points_[t[2]]);
        const double twice_area = n.norm();
        if (twice_area < 1e-15)
            return Matrix4::Zero();
        Eigen::Vector4d plane;
        plane << n / twice_area, -n.dot(points_[t[0]]) / twice_area;
        return twice_area / 2 * plane * plane.transpose();
    }

    /// What the other half of a symmetric body adds at a point of the border.
    static Matrix4 mirrorImage(const Matrix4& quadric) {
        const Eigen::DiagonalMatrix<double, 4> flip(-1, 1, 1, 1);
        return flip * quadric * flip;
    }

    std::vector<uint32_t> neighbours(uint32_t point) const {
        std::vector<uint32_t> found;
        for (const uint32_t t : triangles_of_[point])
            for (const uint32_t other : triangles_[t])
                if (other != point)
                    found.push_back(other);
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

    bool onBorder(uint32_t point) const { return points_[point].x() == 0; }

    void offer(uint32_t a, uint32_t b) {
        const Matrix4 quadric = quadrics_[a] + quadrics_[b];
        const double length2 = (points_[a] - points_[b]).squaredNorm();
        Collapse best{1e9, a, b, versions_[a], versions_[b], points_[a]};
        const bool anywhere = onBorder(a) == onBorder(b);
        for (const Vector3d& place : {points_[a], points_[b], Vector3d((points_[a] + points_[b]) / 2)}) {
            if (!anywhere && place.x() != 0)
                continue;
            const double cost = place.homogeneous().dot(quadric * place.homogeneous());
            if (cost < best.cost) {
                best.cost = cost;
                best.place = place;
            }
        }
        best.cost += kLengthPrice * length2 * length2;
        best.cost *= importance_(best.place);
        queue_.push(best);
    }

    bool allowed(const Collapse& c) const {
        const auto of_keep = neighbours(c.keep), of_drop = neighbours(c.drop);
        std::vector<uint32_t> common;
        std::set_intersection(of_keep.begin(), of_keep.end(), of_drop.begin(), of_drop.end(),
                              std::back_inserter(common));
        const bool both_on_border = onBorder(c.keep) && onBorder(c.drop);
        return common.size() == (both_on_border ? 1 : 2) && keepsBorder(c.keep, of_keep, common) &&
               keepsBorder(c.drop, of_drop, common) && keepsDirections(c.keep, c.drop, c.place) &&
               keepsDirections(c.drop, c.keep, c.place);
    }

    /// Points of the border may be neighbours along the border only: the mirror image shares them.
    bool keepsBorder(uint32_t moved, const std::vector<uint32_t>& of_moved,
                     const std::vector<uint32_t>& common) const {
        const auto bordering = [&](const std::vector<uint32_t>& points) {
            return std::count_if(points.begin(), points.end(), [&](uint32_t p) { return onBorder(p); });
        };
        return onBorder(moved) || bordering(of_moved) <= bordering(common) + 1;
    }

    /// No triangle of `moved` that stays may turn over or become a sliver when the point moves to `place`.
    bool keepsDirections(uint32_t moved, uint32_t other, const Vector3d& place) const {
        for (const uint32_t t : triangles_of_[moved]) {
            Triangle corners = triangles_[t];
            if (std::find(corners.begin(), corners.end(), other) != corners.end())
                continue;
            while (corners[0] != moved)
                std::rotate(corners.begin(), corners.begin() + 1, corners.end());
            const Vector3d &b = points_[corners[1]], &c = points_[corners[2]];
            const Vector3d before = areaNormal(points_[moved], b, c), after = areaNormal(place, b, c);
            const double longest2 =
                std::max({(b - c).squaredNorm(), (b - place).squaredNorm(), (c - place).squaredNorm()});
            if (after.dot(before) < kLeastCosine * after.norm() * before.norm() ||
                after.norm() < 0.1 * longest2)
                return false;
        }
        return true;
    }

    /// Returns how many triangles went.
    size_t apply(const Collapse& c) {
        size_t gone = 0;
        for (const uint32_t t : std::vector<uint32_t>(triangles_of_[c.drop])) {
            Triangle& corners = triangles_[t];
            if (std::find(corners.begin(), corners.end(), c.keep) != corners.end()) {
                for (const uint32_t corner : corners)
                    std::erase(triangles_of_[corner], t);
                ++gone;
            } else {
                std::replace(corners.begin(), corners.end(), c.drop, c.keep);
                triangles_of_[c.keep].push_back(t);
            }
        }
        triangles_of_[c.drop].clear();
        points_[c.keep] = c.place;
        quadrics_[c.keep] += quadrics_[c.drop];
        ++versions_[c.drop];
        ++versions_[c.keep];
        for (const uint32_t neighbour : neighbours(c.keep))
            offer(c.keep, neighbour);
        return gone;
    }

    TriangleMesh compacted() const {
        TriangleMesh result;
        std::vector<uint32_t> index(points_.size());
        for (uint32_t p = 0; p < points_.size(); ++p)
            if (!triangles_of_[p].empty()) {
                index[p] = static_cast<uint32_t>(result.points.size());
                result.points.push_back(points_[p]);
            }
        for (uint32_t t = 0; t < triangles_.size(); ++t) {
            const auto& used = triangles_of_[triangles_[t][0]];
            if (std::find(used.begin(), used.end(), t) != used.end())
                result.triangles.push_back(
                    {index[triangles_[t][0]], index[triangles_[t][1]], index[triangles_[t][2]]});
        }
        return result;
    }

    std::vector<Vector3d> points_;
    std::vector<Triangle> triangles_;
    std::vector<std::vector<uint32_t>> triangles_of_;
    std::vector<Matrix4> quadrics_;
    std::vector<uint32_t> versions_;
    const Importance& importance_;
    std::priority_queue<Collapse> queue_;
};

}  // namespace

TriangleMesh decimated(const TriangleMesh& mesh, size_t target, const Importance& importance) {
    return Decimation(mesh, importance).run(target);
}

}  // namespace noctule
