// SPDX-License-Identifier: Apache-2.0
// Linear and dual quaternion blending: the same where one bone rules, and what each is known for where two
// do.
#include "core/mesh/skinning.h"

#include <gtest/gtest.h>

#include <random>

#include "core/math/rotation.h"
#include "tests/support/shared_meshes.h"

namespace noctule {
namespace {

Eigen::Matrix4f moved(const Quaterniond& q, const Vector3d& t_m, double scale = 1) {
    Eigen::Affine3d T = Eigen::Affine3d::Identity();
    T.linear() = scale * q.toRotationMatrix();
    T.translation() = t_m;
    return T.matrix().cast<float>();
}

/// Points on a circle of radius 1 about X, half way between two bones.
SkinnedMesh ring() {
    SkinnedMesh mesh;
    mesh.bones = {{"a", Eigen::Matrix4f::Identity()}, {"b", Eigen::Matrix4f::Identity()}};
    for (int i = 0; i < 12; ++i) {
        const Eigen::Vector3f out(0, std::cos(0.5F * static_cast<float>(i)),
                                  std::sin(0.5F * static_cast<float>(i)));
        mesh.vertices.push_back({out, out, {0, 1, 0, 0}, {0.5F, 0.5F, 0, 0}});
    }
    return mesh;
}

TEST(Skinning, OneBoneMovesRigidlyWithBoth) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    SkinnedMesh mesh = ring();
    for (SkinnedVertex& vertex : mesh.vertices)
        vertex.weights = {1, 0, 0, 0};
    for (int i = 0; i < 50; ++i) {
        const Quaterniond q = expQuaternion(2 * Vector3d{normal(random), normal(random), normal(random)});
        const Vector3d t_m{normal(random), normal(random), normal(random)};
        const double scale = i % 2 ? 1 : 0.4;
        const std::vector<Eigen::Matrix4f> matrices = {moved(q, t_m, scale), Eigen::Matrix4f::Identity()};
        for (const Blending blending : {Blending::kLinear, Blending::kDualQuaternion}) {
            const PosedSurface surface = skinned(mesh, matrices, blending);
            for (size_t v = 0; v < mesh.vertices.size(); ++v) {
                const Vector3d expected = scale * (q * mesh.vertices[v].p_m.cast<double>()) + t_m;
                EXPECT_LT((surface.points_m[v].cast<double>() - expected).norm(), 2e-6 * (1 + t_m.norm()));
                EXPECT_LT(
                    (surface.normals[v].cast<double>() - q * mesh.vertices[v].normal.cast<double>()).norm(),
                    1e-5);
            }
        }
    }
}

TEST(Skinning, ATwistKeepsItsRadiusWithDualQuaternionsOnly) {
    const SkinnedMesh mesh = ring();
    for (const double twist_deg : {60.0, 120.0, 170.0}) {
        const std::vector<Eigen::Matrix4f> matrices = {
            Eigen::Matrix4f::Identity(), moved(axisAngle(Vector3d::UnitX(), radians(twist_deg)), {0, 0, 0})};
        for (const auto& p : skinned(mesh, matrices, Blending::kDualQuaternion).points_m)
            EXPECT_NEAR(p.norm(), 1, 1e-5);
        for (const auto& p : skinned(mesh, matrices, Blending::kLinear).points_m)
            EXPECT_NEAR(p.norm(), std::cos(radians(twist_deg / 2)), 1e-5);  // the candy wrapper
    }
}

TEST(Skinning, QuaternionsOfEitherSignGoTheShortWay) {
    const SkinnedMesh mesh = ring();
    // Half way between the two; the quaternions of the second pair come out of their matrices with opposite
    // signs.
    for (const auto& [first_deg, second_deg] : {std::pair{175.0, 185.0}, {-110.0, -160.0}}) {
        const std::vector<Eigen::Matrix4f> matrices = {
            moved(axisAngle(Vector3d::UnitX(), radians(first_deg)), {1, 0, 0}),
            moved(axisAngle(Vector3d::UnitX(), radians(second_deg)), {1, 0, 0})};
        const Quaterniond half = axisAngle(Vector3d::UnitX(), radians((first_deg + second_deg) / 2));
        const PosedSurface surface = skinned(mesh, matrices, Blending::kDualQuaternion);
        for (size_t v = 0; v < mesh.vertices.size(); ++v) {
            const Vector3d expected = half * mesh.vertices[v].p_m.cast<double>() + Vector3d::UnitX();
            EXPECT_LT((surface.points_m[v].cast<double>() - expected).norm(), 1e-5);
        }
    }
}

TEST(Skinning, ScaledBonesBlendTheirScale) {
    SkinnedMesh mesh = ring();
    const Vector3d centre_m(0.2, 0, 0);
    const std::vector<Eigen::Matrix4f> matrices = {
        Eigen::Matrix4f::Identity(), moved(Quaterniond::Identity(), -1.0 * centre_m, 2)};  // about centre_m
    for (const Blending blending : {Blending::kLinear, Blending::kDualQuaternion}) {
        const PosedSurface surface = skinned(mesh, matrices, blending);
        for (size_t v = 0; v < mesh.vertices.size(); ++v) {
            const Vector3d expected = centre_m + 1.5 * (mesh.vertices[v].p_m.cast<double>() - centre_m);
            EXPECT_LT((surface.points_m[v].cast<double>() - expected).norm(), 1e-5);
        }
    }
}

TEST(Skinning, BothAgreeOnAFigureInMotionWithinAHandsBreadth) {
    if (!test::isShared(test::kCesiumMan))
        GTEST_SKIP() << test::sayMissing(test::kCesiumMan);
    const RiggedMesh mesh = test::sharedMesh(test::kCesiumMan);
    const auto matrices = skinMatrices(mesh, posed(mesh, mesh.clips.front(), 0.7));
    const PosedSurface linear = skinned(mesh.skin, matrices),
                       dual = skinned(mesh.skin, matrices, Blending::kDualQuaternion);
    float worst = 0;
    for (size_t v = 0; v < linear.points_m.size(); ++v)
        worst = std::max(worst, (linear.points_m[v] - dual.points_m[v]).norm());
    EXPECT_LT(worst, 0.08F);
    EXPECT_GT(worst, 1e-4F);
}

}  // namespace
}  // namespace noctule
