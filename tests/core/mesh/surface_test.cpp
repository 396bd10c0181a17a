// SPDX-License-Identifier: Apache-2.0
// From an implicit surface to few triangles, on shapes whose answer is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/body/actor.h"
#include "core/mesh/mannequin/decimation.h"
#include "core/mesh/mannequin/surface_nets.h"

namespace noctule {
namespace {

constexpr double kRadius_m = 0.2;
const Vector3d kCentre_m(0, 1.0, 0);

/// A ball about the middle of the body; the default actor's root stands 0.97 m high.
ImplicitBody ball() {
    const Part part = ellipsoid("Hips", kCentre_m - Vector3d(0, 0.97, 0), Vector3d::Constant(kRadius_m), 0,
                                Vector3d::Zero(), false);
    return ImplicitBody({part}, defaultActor().skeleton, 0.97);
}

double volume_m3(const TriangleMesh& mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        sum += mesh.points[a].dot(mesh.points[b].cross(mesh.points[c])) / 6;
    return sum;
}

bool isClosed(const TriangleMesh& mesh) {
    std::map<std::pair<uint32_t, uint32_t>, int> edges;
    for (const auto& t : mesh.triangles)
        for (size_t i = 0; i < 3; ++i)
            ++edges[{t[i], t[(i + 1) % 3]}];
    return std::all_of(edges.begin(), edges.end(), [&](const auto& entry) {
        return entry.second == 1 && edges.contains({entry.first.second, entry.first.first});
    });
}

constexpr double kBall_m3 = 4.0 / 3 * std::numbers::pi * kRadius_m * kRadius_m * kRadius_m;

TEST(ImplicitBody, DistanceAndNormalOfABallAreExact) {
    for (const Vector3d& direction : {Vector3d(1, 0, 0), Vector3d(0, -1, 0), Vector3d(0.6, 0, -0.8)})
        for (const double r_m : {0.15, 0.2, 0.26}) {
            const Vector3d p_m = kCentre_m + r_m * direction;
            EXPECT_NEAR(ball().distance_m(p_m), r_m - kRadius_m, 1e-9);
            EXPECT_LT((ball().normal(p_m, 1e-4) - direction).norm(), 1e-3);
        }
}

TEST(ImplicitBody, IsTheSameOnBothSides) {
    const std::vector<Part> legs = legParts();
    const ImplicitBody body(legs, defaultActor().skeleton, 0.97);
    for (const Vector3d& p_m :
         {Vector3d(0.03, 0.8, 0.02), Vector3d(0.1, 0.5, -0.05), Vector3d(0.004, 0.83, 0)})
        EXPECT_EQ(body.distance_m(p_m), body.distance_m({-p_m.x(), p_m.y(), p_m.z()}));
}

TEST(SurfaceNets, ABallIsClosedAndHasItsVolume) {
    const TriangleMesh mesh = mirrored(polygoniseHalf(ball(), 0.008));
    EXPECT_TRUE(isClosed(mesh));
    EXPECT_NEAR(volume_m3(mesh), kBall_m3, 0.01 * kBall_m3);
    for (const Vector3d& p_m : mesh.points)
        ASSERT_NEAR((p_m - kCentre_m).norm(), kRadius_m, 0.001);
}

TEST(Decimation, KeepsTheShapeAndTheBorder) {
    const TriangleMesh fine = polygoniseHalf(ball(), 0.008);
    const TriangleMesh coarse = decimated(fine, 400, [](const Vector3d&) { return 1.0; });
    EXPECT_LE(coarse.triangles.size(), 400U);
    EXPECT_TRUE(isClosed(mirrored(coarse)));
    EXPECT_NEAR(volume_m3(mirrored(coarse)), kBall_m3, 0.03 * kBall_m3);
}

TEST(Decimation, LeavesMoreTrianglesWhereErrorsCountMore) {
    const TriangleMesh fine = polygoniseHalf(ball(), 0.008);
    const TriangleMesh coarse =
        decimated(fine, 400, [](const Vector3d& p_m) { return p_m.y() > kCentre_m.y() ? 20.0 : 1.0; });
    const auto above = std::count_if(coarse.points.begin(), coarse.points.end(),
                                     [](const Vector3d& p_m) { return p_m.y() > kCentre_m.y(); });
    EXPECT_GT(static_cast<double>(above), 0.65 * static_cast<double>(coarse.points.size()));
}

}  // namespace
}  // namespace noctule
