// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/mannequin/surface_nets.h"

#include <cmath>

namespace noctule {
namespace {

constexpr int kBlock = 4;  ///< cells along a block that is sampled in whole or not at all
constexpr uint32_t kNone = 0xffffffff;
/// Points are rounded to this, so that the last bit of a library function never decides which edge decimation
/// takes first: the same triangles on every processor.
constexpr double kGrain_m = 1e-7;

using Index3 = std::array<int, 3>;

Index3 stepped(Index3 c, int axis, int by) {
    c[static_cast<size_t>(axis)] += by;
    return c;
}

/// Cells that the surface may pass.
template <class Grid, class Visit>
void forEachCell(const Grid& grid, const Visit& visit) {
    for (int k = 1; k + 1 < grid.size()[2]; ++k)
        for (int j = 1; j + 1 < grid.size()[1]; ++j)
            for (int i = 0; i + 1 < grid.size()[0]; ++i)
                if (grid.isNear({i, j, k}))
                    visit(Index3{i, j, k});
}

/// Signed distances at the corners of a box of cells. The first layer of cells straddles x = 0.
class Grid {
public:
    Grid(const ImplicitBody& body, double cell_m) : cell_m_(cell_m) {
        const Vector3d low(-cell_m / 2, -5 * cell_m, -0.25), high(1.0, 1.85, 0.30);
        origin_m_ = low;
        for (size_t axis = 0; axis < 3; ++axis) {
            const double extent_m = high[static_cast<int>(axis)] - low[static_cast<int>(axis)];
            size_[axis] = kBlock * static_cast<int>(std::ceil(extent_m / cell_m / kBlock));
        }
        values_.assign(static_cast<size_t>(size_[0]) * size_[1] * size_[2], 1.0F);
        for (int k = 0; k < size_[2]; k += kBlock)
            for (int j = 0; j < size_[1]; j += kBlock)
                for (int i = 0; i < size_[0]; i += kBlock)
                    sampleBlock(body, {i, j, k});
        while (closePinches()) {
        }
    }

    const Index3& size() const { return size_; }
    size_t at(const Index3& c) const {
        return (static_cast<size_t>(c[2]) * size_[1] + c[1]) * size_[0] + c[0];
    }
    float value(const Index3& c) const { return values_[at(c)]; }
    /// False for cells that the surface cannot pass, distances being about right.
    bool isNear(const Index3& c) const { return std::abs(value(c)) < 4 * cell_m_; }
    Vector3d corner(const Index3& c) const { return origin_m_ + cell_m_ * Vector3d(c[0], c[1], c[2]); }

private:
    /// Distances are only about right: a block counts as far from the surface at 1.7 times its half diagonal.
    void sampleBlock(const ImplicitBody& body, const Index3& first) {
        const Vector3d centre_m = corner(first) + Vector3d::Constant(cell_m_ * (kBlock - 1) / 2.0);
        const double far_m = 1.7 * std::sqrt(3.0) * cell_m_ * kBlock / 2;
        const double d = body.distance_m(centre_m);
        for (int k = first[2]; k < first[2] + kBlock; ++k)
            for (int j = first[1]; j < first[1] + kBlock; ++j)
                for (int i = first[0]; i < first[0] + kBlock; ++i)
                    values_[at({i, j, k})] =
                        static_cast<float>(std::abs(d) > far_m ? d : body.distance_m(corner({i, j, k})));
    }

    /// A face whose corners are inside and outside crosswise would make an edge of four triangles; the corner
    /// outside that is nearest to the surface goes inside. True when there was such a face.
    bool closePinches() {
        bool found = false;
        forEachCell(*this, [&](const Index3& cell) {
            for (int axis = 0; axis < 3; ++axis) {
                const int u = (axis + 1) % 3, v = (axis + 2) % 3;
                float &a = values_[at(cell)], &d = values_[at(stepped(stepped(cell, u, 1), v, 1))];
                float &b = values_[at(stepped(cell, u, 1))], &c = values_[at(stepped(cell, v, 1))];
                if ((a < 0) != (d < 0) || (b < 0) != (c < 0) || (a < 0) == (b < 0))
                    continue;
                float& nearest = a < 0 ? (b < c ? b : c) : (a < d ? a : d);
                nearest = -1e-6F;
                found = true;
            }
        });
        return found;
    }

    double cell_m_;
    Vector3d origin_m_;
    Index3 size_{};
    std::vector<float> values_;
};

/// The mean of the places where the surface crosses the cell's edges; nothing when it crosses none.
bool cellPoint(const Grid& grid, const Index3& cell, Vector3d& point) {
    Vector3d sum = Vector3d::Zero();
    int crossings = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (int corner = 0; corner < 4; ++corner) {
            Index3 a = stepped(cell, (axis + 1) % 3, corner & 1);
            a = stepped(a, (axis + 2) % 3, corner >> 1);
            const Index3 b = stepped(a, axis, 1);
            const double from = grid.value(a), to = grid.value(b);
            if ((from < 0) == (to < 0))
                continue;
            sum += grid.corner(a) + from / (from - to) * (grid.corner(b) - grid.corner(a));
            ++crossings;
        }
    if (crossings)
        point = (sum / crossings / kGrain_m).array().round() * kGrain_m;
    return crossings > 0;
}

/// The quadrangle around the grid edge that leaves `corner` along `axis`, of the four cells about it.
void addQuad(const Grid& grid, const std::vector<uint32_t>& point_of_cell, const Index3& corner, int axis,
             TriangleMesh& mesh) {
    const bool leaves = grid.value(corner) < 0;
    if (leaves == (grid.value(stepped(corner, axis, 1)) < 0))
        return;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    if ((axis != 0) && corner[0] == 0)
        return;  // its cells would lie beyond the border
    const Index3 cells[4] = {stepped(stepped(corner, u, -1), v, -1), stepped(corner, v, -1), corner,
                             stepped(corner, u, -1)};
    std::array<uint32_t, 4> quad{};
    for (size_t i = 0; i < 4; ++i)
        quad[i] = point_of_cell[grid.at(cells[leaves ? i : 3 - i])];
    const auto length = [&](size_t a, size_t b) {
        return (mesh.points[quad[a]] - mesh.points[quad[b]]).squaredNorm();
    };
    const size_t first = length(0, 2) <= length(1, 3) ? 0 : 1;
    mesh.triangles.push_back({quad[first], quad[first + 1], quad[first + 2]});
    mesh.triangles.push_back({quad[first], quad[first + 2], quad[(first + 3) % 4]});
}

}  // namespace

TriangleMesh polygoniseHalf(const ImplicitBody& body, double cell_m) {
    const Grid grid(body, cell_m);
    TriangleMesh mesh;
    std::vector<uint32_t> point_of_cell(grid.at({0, 0, grid.size()[2]}), kNone);
    forEachCell(grid, [&](const Index3& cell) {
        Vector3d point;
        if (!cellPoint(grid, cell, point))
            return;
        if (cell[0] == 0)
            point.x() = 0;
        point_of_cell[grid.at(cell)] = static_cast<uint32_t>(mesh.points.size());
        mesh.points.push_back(point);
    });
    forEachCell(grid, [&](const Index3& corner) {
        for (int axis = 0; axis < 3; ++axis)
            addQuad(grid, point_of_cell, corner, axis, mesh);
    });
    return mesh;
}

TriangleMesh mirrored(const TriangleMesh& half) {
    TriangleMesh whole = half;
    std::vector<uint32_t> image(half.points.size());
    for (uint32_t i = 0; i < half.points.size(); ++i) {
        const Vector3d& p = half.points[i];
        image[i] = p.x() == 0 ? i : static_cast<uint32_t>(whole.points.size());
        if (p.x() != 0)
            whole.points.emplace_back(-p.x(), p.y(), p.z());
    }
    for (const auto& [a, b, c] : half.triangles)
        whole.triangles.push_back({image[a], image[c], image[b]});
    return whole;
}

}  // namespace noctule
