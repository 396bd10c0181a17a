// SPDX-License-Identifier: Apache-2.0
// Bodies after public reports of trouble, and damaged files: read right or refused in words.
#include "tests/core/formats/body_dialects.h"

namespace noctule {
namespace {

std::string fieldPath(const std::string& name) {
    return test::sharedPath("field/" + name);
}

/// ../shared/data/field/README.md: one person of 1.81 m in many dialects. percent_uri.gltf is the plain one.
TEST_F(BodyDialects, BodiesOfTheField) {
    if (!test::isShared("field/percent_uri.gltf"))
        GTEST_SKIP() << test::sayMissing("field/percent_uri.gltf");
    const auto plain_body = bodyOf(fieldPath("percent_uri.gltf"));
    ASSERT_TRUE(plain_body) << plain_body.error().text();
    std::vector<Vector3d> rest;
    std::map<int, double> nearest_m;
    for (const SkinnedVertex& vertex : plain_body->mesh.skin.vertices) {
        rest.push_back(vertex.p_m.cast<double>());
        const int node = plain_body->mesh.node_of_bone[vertex.bones[0]];
        const Vector3d joint = plain_body->mesh.nodes[static_cast<size_t>(node)].T_world_rest.translation();
        const auto known = nearest_m.try_emplace(node, 1e9).first;
        known->second = std::min(known->second, (rest.back() - joint).norm());
    }
    EXPECT_NEAR(heightOfPoints(rest), 1.81, 0.005);
    EXPECT_EQ(nearest_m.size(), 22U);
    for (const auto& [node, distance_m] : nearest_m)
        EXPECT_LT(distance_m, 0.2) << "a prism lies on its bone " << node;
    const PointsOfFrames as = exported(fieldPath("percent_uri.gltf"), SceneFormat::kGlb);
    for (const char* name :
         {"percent_uri.gltf", "mesh_below_armature_001.glb", "no_inverse_bind_matrices.glb",
          "mesh_named_head.glb", "vrm_japanese_skirt.glb", "names_hips_spine_thigh_skirt.glb"})
        expectSameAs(as, fieldPath(name), name);
}

TEST_F(BodyDialects, AVertebraOf8MmOfTheField) {
    if (!test::isShared("field/bone_of_8_mm.glb"))
        GTEST_SKIP() << test::sayMissing("field/bone_of_8_mm.glb");
    const PointsOfFrames points = exported(fieldPath("bone_of_8_mm.glb"), SceneFormat::kGlb);
    ASSERT_EQ(points.size(), kDialectFrames);
    EXPECT_LT(largestGap(points, exported(fieldPath("bone_of_8_mm.glb"), SceneFormat::kFbx)), 1e-4);
    const auto again = importMesh(folder_.file("out.glb"));
    ASSERT_TRUE(again);
    const auto at = [&](const char* bone) {
        return Vector3d(again->nodes[static_cast<size_t>(again->find(bone))].T_world_rest.translation());
    };
    EXPECT_NEAR((at("Spine2") - at("Spine1")).norm(), 0.008, 1e-6);
}

TEST_F(BodyDialects, TwoPeopleOfTheField) {
    if (!test::isShared("field/partners.glb"))
        GTEST_SKIP() << test::sayMissing("field/partners.glb");
    const PointsOfFrames as = exported(fieldPath("percent_uri.gltf"), SceneFormat::kGlb);
    for (const char* name : {"partners.glb", "twins_share_a_mesh.glb"})
        for (const SceneFormat format : {SceneFormat::kGlb, SceneFormat::kFbx}) {
            const PointsOfFrames points = exported(fieldPath(name), format);
            ASSERT_EQ(points.size(), kDialectFrames);
            ASSERT_EQ(points[0].size(), 2 * as[0].size());
            const auto half = static_cast<std::ptrdiff_t>(as[0].size());
            for (size_t f = 0; f < kDialectFrames; ++f) {
                const std::vector<Vector3d> moving(points[f].begin(), points[f].begin() + half);
                EXPECT_LT(largestGap(PointsOfFrames{moving}, PointsOfFrames{as[f]}), 2e-4) << name;
                const std::vector<Vector3d> first(points[0].begin() + half, points[0].end());
                const std::vector<Vector3d> now(points[f].begin() + half, points[f].end());
                EXPECT_LT(largestGap(first, now), 2e-4) << name << ": the other one stands";
            }
        }
}

/// No part of a damaged file is believed, and none of it ends the program.
TEST_F(BodyDialects, DamagedFilesAreRefusedOrRead) {
    const std::string whole = GlbBody().glb();
    for (size_t length = 0; length < whole.size(); length += 1 + whole.size() / 97)
        EXPECT_FALSE(importMesh(written(whole.substr(0, length)))) << length;
    uint32_t random = 1;
    for (int round = 0; round < 400; ++round) {
        std::string changed = whole;
        for (int byte = 0; byte < 3; ++byte) {
            random = random * 1664525U + 1013904223U;
            changed[random % changed.size()] = static_cast<char>(random >> 24);
        }
        const auto mesh = importMesh(written(changed));
        EXPECT_TRUE(mesh || !mesh.error().message.empty());
    }
}

}  // namespace
}  // namespace noctule
