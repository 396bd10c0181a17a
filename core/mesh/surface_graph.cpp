// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/surface_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <queue>

namespace noctule {
namespace {

/// Sets that grow together.
class Sets {
public:
    explicit Sets(size_t count) : above_(count) { std::iota(above_.begin(), above_.end(), uint32_t{0}); }
    uint32_t find(uint32_t i) {
        while (above_[i] != i)
            i = above_[i] = above_[above_[i]];
        return i;
    }
    void join(uint32_t a, uint32_t b) { above_[find(a)] = find(b); }

private:
    std::vector<uint32_t> above_;
};

using Neighbours = std::vector<std::vector<std::pair<uint32_t, double>>>;

Neighbours neighboursOf(const TriangleMesh& mesh) {
    Neighbours neighbours(mesh.points.size());
    for (const auto& triangle : mesh.triangles)
        for (size_t i = 0; i < 3; ++i) {
            const uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
            const double length = (mesh.points[a] - mesh.points[b]).norm();
            neighbours[a].emplace_back(b, length);
            neighbours[b].emplace_back(a, length);
        }
    return neighbours;
}

/// Where a level crosses an edge.
struct Crossing {
    uint64_t edge;
    Vector3d p;
};

Crossing crossingOf(const TriangleMesh& mesh, const std::vector<double>& value, double level, uint32_t a,
                    uint32_t b) {
    if (a > b)
        std::swap(a, b);
    const double f = (level - value[a]) / (value[b] - value[a]);
    return {(uint64_t{a} << 32) | b, (1 - f) * mesh.points[a] + f * mesh.points[b]};
}

/// The piece of the line within one triangle: both its ends, or nothing.
std::vector<Crossing> crossingsOf(const TriangleMesh& mesh, const std::vector<double>& value, double level,
                                  const std::array<uint32_t, 3>& triangle) {
    std::vector<Crossing> ends;
    for (size_t i = 0; i < 3; ++i) {
        const uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
        if (!std::isfinite(value[a]) || !std::isfinite(value[b]))
            return {};
        if ((value[a] < level) != (value[b] < level))
            ends.push_back(crossingOf(mesh, value, level, a, b));
    }
    return ends;
}

}  // namespace

WeldedSurface welded(const SkinnedMesh& skin) {
    WeldedSurface surface;
    std::map<std::array<float, 3>, uint32_t> point_at;
    for (const SkinnedVertex& vertex : skin.vertices) {
        const std::array<float, 3> place{vertex.p_m.x(), vertex.p_m.y(), vertex.p_m.z()};
        const auto [entry, is_new] =
            point_at.try_emplace(place, static_cast<uint32_t>(surface.mesh.points.size()));
        if (is_new)
            surface.mesh.points.push_back(vertex.p_m.cast<double>());
        surface.point_of.push_back(entry->second);
    }
    for (const auto& corners : skin.triangles) {
        const std::array<uint32_t, 3> triangle{surface.point_of[corners[0]], surface.point_of[corners[1]],
                                               surface.point_of[corners[2]]};
        if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
            surface.mesh.triangles.push_back(triangle);
    }
    return surface;
}

std::vector<int> piecesOf(const TriangleMesh& mesh) {
    Sets sets(mesh.points.size());
    for (const auto& triangle : mesh.triangles) {
        sets.join(triangle[0], triangle[1]);
        sets.join(triangle[0], triangle[2]);
    }
    std::map<uint32_t, int> size;
    for (uint32_t p = 0; p < mesh.points.size(); ++p)
        ++size[sets.find(p)];
    std::vector<std::pair<int, uint32_t>> largest;
    for (const auto& [root, count] : size)
        largest.emplace_back(-count, root);
    std::sort(largest.begin(), largest.end());
    std::map<uint32_t, int> number;
    for (const auto& [count, root] : largest)
        number.try_emplace(root, static_cast<int>(number.size()));
    std::vector<int> pieces;
    for (uint32_t p = 0; p < mesh.points.size(); ++p)
        pieces.push_back(number[sets.find(p)]);
    return pieces;
}

std::vector<double> waysFrom(const TriangleMesh& mesh, uint32_t point) {
    const Neighbours neighbours = neighboursOf(mesh);
    std::vector<double> way(mesh.points.size(), std::numeric_limits<double>::infinity());
    using Visit = std::pair<double, uint32_t>;
    std::priority_queue<Visit, std::vector<Visit>, std::greater<>> open;
    open.emplace(way[point] = 0, point);
    while (!open.empty()) {
        const auto [length, at] = open.top();
        open.pop();
        if (length > way[at])
            continue;
        for (const auto& [next, step] : neighbours[at])
            if (length + step < way[next])
                open.emplace(way[next] = length + step, next);
    }
    return way;
}

std::vector<Ring> ringsAt(const TriangleMesh& mesh, const std::vector<double>& value, double level) {
    struct Piece {
        uint32_t from, to;
        Vector3d a, b;
    };
    std::map<uint64_t, uint32_t> number;
    std::vector<Piece> pieces;
    for (const auto& triangle : mesh.triangles) {
        const auto ends = crossingsOf(mesh, value, level, triangle);
        if (ends.size() != 2)
            continue;
        const auto index = [&](uint64_t edge) {
            return number.try_emplace(edge, static_cast<uint32_t>(number.size())).first->second;
        };
        const uint32_t from = index(ends[0].edge), to = index(ends[1].edge);
        pieces.push_back({from, to, ends[0].p, ends[1].p});
    }
    Sets sets(number.size());
    for (const Piece& piece : pieces)
        sets.join(piece.from, piece.to);
    std::map<uint32_t, Ring> rings;
    for (const Piece& piece : pieces) {
        Ring& ring = rings[sets.find(piece.from)];
        const double length = (piece.b - piece.a).norm();
        ring.centre += 0.5 * length * (piece.a + piece.b);
        ring.length += length;
        ring.box.extend(piece.a).extend(piece.b);
    }
    std::vector<Ring> found;
    for (auto& [root, ring] : rings)
        if (ring.length > 0) {
            ring.centre /= ring.length;
            found.push_back(ring);
        }
    return found;
}

}  // namespace noctule
