// SPDX-License-Identifier: Apache-2.0
// Meshes of other programs, posed: what we make of file, animation and weights equals what the program that
// made the file drew.
#include "core/mesh/import/mesh_import.h"

#include <gtest/gtest.h>

#include "core/mesh/import/rigged_mesh_bytes.h"
#include "core/mesh/skinning.h"
#include "tests/support/files.h"
#include "tests/support/painted_surface.h"
#include "tests/support/shared_meshes.h"

namespace noctule {
namespace {

using test::sharedPath;

const RigClip* clipNamed(const RiggedMesh& mesh, const std::string& name) {
    for (const RigClip& clip : mesh.clips)
        if (clip.name == name)
            return &clip;
    return nullptr;
}

double farthest(const std::vector<Vector3d>& from, const std::vector<Vector3d>& to) {
    double worst = 0;
    for (const Vector3d& p : from) {
        double nearest = 1e18;
        for (const Vector3d& q : to)
            nearest = std::min(nearest, (p - q).squaredNorm());
        worst = std::max(worst, std::sqrt(nearest));
    }
    return worst;
}

/// Largest distance, both ways, between our vertices and those of the OBJ, in the file's unit.
double difference(const RiggedMesh& mesh, const RigPose& pose, const std::string& obj, double unit_m) {
    std::vector<Vector3d> ours;
    for (const Eigen::Vector3f& p : skinned(mesh.skin, skinMatrices(mesh, pose)).points_m)
        ours.push_back(p.cast<double>() / unit_m);
    const std::vector<Vector3d> theirs = test::objPoints(sharedPath(obj));
    return std::max(farthest(ours, theirs), farthest(theirs, ours));
}

struct DrawnPose {
    const char *mesh, *clip;
    int frame;
    const char* obj;
    double unit_m;
};

void PrintTo(const DrawnPose& drawn, std::ostream* out) {
    *out << std::filesystem::path(drawn.mesh).stem().string() << "_" << drawn.frame;
}

class DrawnPoses : public testing::TestWithParam<DrawnPose> {};

TEST_P(DrawnPoses, AreReproduced) {
    const DrawnPose& drawn = GetParam();
    if (!test::isShared(drawn.mesh))
        GTEST_SKIP() << test::sayMissing(drawn.mesh);
    const RiggedMesh mesh = test::sharedMesh(drawn.mesh);
    const RigClip* clip = clipNamed(mesh, drawn.clip);
    ASSERT_TRUE(clip);
    constexpr double kFrame_s = 1.0 / 24;
    EXPECT_LT(difference(mesh, posed(mesh, *clip, drawn.frame * kFrame_s), drawn.obj, drawn.unit_m), 1e-3);
    // The frame beside it is another pose: the comparison can fail.
    EXPECT_GT(difference(mesh, posed(mesh, *clip, (drawn.frame - 1) * kFrame_s), drawn.obj, drawn.unit_m),
              0.1);
}

// Blender numbers the frames of "Wiggle" from 1; its file begins at time 0.
INSTANTIATE_TEST_SUITE_P(MeshImport, DrawnPoses,
                         testing::Values(DrawnPose{"fbx/maya_kenney_character_7700_binary.fbx", "Take 001", 4,
                                                   "fbx/maya_kenney_character_4.obj", 0.01},
                                         DrawnPose{"fbx/maya_kenney_character_7700_binary.fbx", "Take 001", 9,
                                                   "fbx/maya_kenney_character_9.obj", 0.01},
                                         DrawnPose{"fbx/maya_game_sausage_7500_binary_spin.fbx", "spin", 7,
                                                   "fbx/maya_game_sausage_spin_7.obj", 0.01},
                                         DrawnPose{"fbx/maya_game_sausage_7500_binary_combined.fbx", "spin",
                                                   15, "fbx/maya_game_sausage_spin_15.obj", 0.01},
                                         DrawnPose{"fbx/blender_279_sausage_7400_binary.fbx", "Skeleton|Spin",
                                                   15, "fbx/blender_279_sausage_spin_15.obj", 1},
                                         DrawnPose{"fbx/blender_279_sausage_7400_binary.fbx",
                                                   "Skeleton|Wiggle", 19,
                                                   "fbx/blender_279_sausage_wiggle_20.obj", 1}));

TEST(MeshImport, AFileWithoutDrawnMotionEqualsItsRestPose) {
    const std::string name = "fbx/blender_279_sausage_7400_binary.fbx";
    if (!test::isShared(name))
        GTEST_SKIP() << test::sayMissing(name);
    const RiggedMesh mesh = test::sharedMesh(name);
    EXPECT_LT(difference(mesh, restPose(mesh), "fbx/blender_279_sausage_base_0.obj", 1), 1e-4);
}

TEST(MeshImport, AxesOfAnyProgramStandUpright) {
    const std::string first = "fbx/axes_pypz_7400_binary.fbx";
    if (!test::isShared(first))
        GTEST_SKIP() << test::sayMissing(first);
    for (const char* axes : {"nzpy", "pxpz", "pypz", "pzny", "pzpy"}) {
        const RiggedMesh mesh = test::sharedMesh("fbx/axes_" + std::string(axes) + "_7400_binary.fbx");
        Eigen::AlignedBox3f box;
        for (const SkinnedVertex& vertex : mesh.skin.vertices)
            box.extend(vertex.p_m);
        EXPECT_LT((box.min() - Eigen::Vector3f(1, 3, -2)).norm(), 1e-5F) << axes;
        EXPECT_LT((box.max() - Eigen::Vector3f(2, 4, -1)).norm(), 1e-5F) << axes;
    }
}

double heightOf(const RiggedMesh& mesh) {
    Eigen::AlignedBox3f box;
    for (const SkinnedVertex& vertex : mesh.skin.vertices)
        box.extend(vertex.p_m);
    return static_cast<double>(box.sizes().y());
}

TEST(MeshImport, FiguresHaveTheirTrueSize) {
    if (!test::isShared(test::kCesiumMan))
        GTEST_SKIP() << test::sayMissing(test::kCesiumMan);
    EXPECT_NEAR(heightOf(test::sharedMesh(test::kCesiumMan)), 1.507, 0.001);
    EXPECT_NEAR(heightOf(test::sharedMesh(test::kKenney)), 3.765, 0.001);  // 376 cm: a toy's measures
    EXPECT_NEAR(heightOf(test::sharedMesh(test::kMakeHuman + "base.obj")), 1.69, 0.01);  // from decimetres
}

TEST(MeshImport, NormalsPointOutOfTheSurface) {
    if (!test::isShared(test::kKenney))
        GTEST_SKIP() << test::sayMissing(test::kKenney);
    // Kenney's file holds normals of another pose: an eighth of the triangles would be lit from behind.
    for (const std::string& name : {test::kKenney, test::kCesiumMan, test::kMakeHuman + "base.obj"}) {
        const SkinnedMesh skin = test::sharedMesh(name).skin;
        size_t against = 0;
        for (const auto& [a, b, c] : skin.triangles) {
            const auto& v = skin.vertices;
            const Eigen::Vector3f normal = (v[b].p_m - v[a].p_m).cross(v[c].p_m - v[a].p_m);
            against += normal.dot(v[a].normal + v[b].normal + v[c].normal) < 0;
        }
        EXPECT_LE(static_cast<double>(against), 0.01 * static_cast<double>(skin.triangles.size())) << name;
    }
}

TEST(MeshImport, TheUnitMayBeGiven) {
    if (!test::isShared(test::kCesiumMan))
        GTEST_SKIP() << test::sayMissing(test::kCesiumMan);
    const auto mesh = importMesh(sharedPath(test::kCesiumMan), {0.01});
    ASSERT_TRUE(mesh);
    EXPECT_NEAR(heightOf(*mesh), 0.01507, 1e-5);
    const RigPose pose = posed(*mesh, mesh->clips.front(), 0.5);
    EXPECT_LT((pose[static_cast<size_t>(mesh->node_of_bone[0])].translation()).norm(), 0.02);
    for (const Eigen::Vector3f& p : skinned(mesh->skin, skinMatrices(*mesh, pose)).points_m)
        EXPECT_LT(p.norm(), 0.02F);
}

TEST(MeshImport, ColourAndTextureComeAlong) {
    if (!test::isShared(test::kCesiumMan))
        GTEST_SKIP() << test::sayMissing(test::kCesiumMan);
    const auto paint = [](SurfaceTexture& texture, int) {
        texture.width_px = texture.height_px = 1;
        texture.rgba = {1, 2, 3, 255};
    };
    const auto mesh = importMesh(test::sharedPath(test::kCesiumMan), {std::nullopt, paint});
    ASSERT_TRUE(mesh && mesh->skin.surface.size() == 1 && mesh->skin.surface[0].look);
    EXPECT_EQ(mesh->skin.surface[0].triangles, mesh->skin.triangles.size());
    const SurfaceLook& look = *mesh->skin.surface[0].look;
    ASSERT_TRUE(look.texture);
    EXPECT_TRUE(look.base_color.isOnes()) << look.base_color;
    EXPECT_TRUE(look.texture->file.starts_with("\xff\xd8\xff") || look.texture->file.starts_with("\x89PNG"));
    Eigen::AlignedBox2f places;
    for (const SkinnedVertex& vertex : mesh->skin.vertices)
        places.extend(vertex.uv);
    EXPECT_GT(places.sizes().minCoeff(), 0.3F) << "spread over the texture";
    const auto again = meshFromBytes(toBytes(*mesh), "x");
    ASSERT_TRUE(again && again->skin.surface.size() == 1 && again->skin.surface[0].look->texture);
    EXPECT_EQ(again->skin.surface[0].look->texture->file, look.texture->file);
    EXPECT_EQ(again->skin.surface[0].look->texture->rgba, look.texture->rgba);
    RiggedMesh wrong = *mesh;
    SurfaceTexture larger = *look.texture;
    larger.width_px = 7;
    wrong.skin.surface[0].look->texture = std::make_shared<const SurfaceTexture>(larger);
    EXPECT_FALSE(meshFromBytes(toBytes(wrong), "x")) << "more pixels than there are";
}

/// One triangle per line at x = 0, 10, 20...; materials come and go as the file likes.
std::string paintedObj(const std::vector<std::string>& materials) {
    std::string text = "mtllib looks.mtl\nvt 0.1 0.2\nvt 0.3 0.2\nvt 0.3 0.8\n";
    for (size_t m = 0; m < materials.size(); ++m) {
        const std::string x = std::to_string(10 * m), number = std::to_string(3 * m);
        text += "o part_" + std::to_string(m) + "\nusemtl " + materials[m] + "\n";
        for (const char* at : {" 0 0", " 1 0", " 0 1"})
            text += "v " + x + at + "\n";
        text += "f " + std::to_string(3 * m + 1) + "/1 " + std::to_string(3 * m + 2) + "/2 " +
                std::to_string(3 * m + 3) + "/3\n";
    }
    return text;
}

const char* const kMaterials =
    "newmtl skin\nKd 0.9 0.5 0.4\nnewmtl eyes\nKd 0.1 0.2 0.9\n"
    "newmtl coat\nKd 1 1 1\nmap_Kd cloth.png\nnewmtl hat\nKd 1 1 1\nmap_Kd same_cloth.png\n"
    "newmtl shoes\nKd 1 1 1\nmap_Kd leather.png\nnewmtl cheek\nKd 0.9 0.5 0.4\n";

class MeshOfManyLooks : public testing::Test {
protected:
    void SetUp() override {
        test::writeBytes(folder_.file("looks.mtl"), kMaterials);
        for (const char* name : {"cloth.png", "same_cloth.png"})
            test::writeBytes(folder_.file(name), test::kRedPng);
        test::writeBytes(folder_.file("leather.png"), test::kBluePng);
    }
    RiggedMesh imported(const std::vector<std::string>& materials, TextureDecoder decode = nullptr) const {
        test::writeBytes(folder_.file("body.obj"), paintedObj(materials));
        auto mesh = importMesh(folder_.file("body.obj"), {1.0, decode});
        EXPECT_TRUE(mesh) << mesh.error().text();
        return mesh ? std::move(*mesh) : RiggedMesh();
    }

    test::Folder folder_;
};

/// Which of the file's triangles a part has, by their places.
std::vector<int> trianglesOf(const SkinnedMesh& skin, const SurfacePart& part) {
    std::vector<int> found;
    for (uint32_t t = part.first_triangle; t < part.first_triangle + part.triangles; ++t)
        found.push_back(static_cast<int>(std::lround(skin.vertices[skin.triangles[t][0]].p_m.x() / 10)));
    return found;
}

TEST_F(MeshOfManyLooks, KeepsEach) {
    const RiggedMesh mesh = imported({"skin", "eyes", "coat", "skin", "hat", "shoes", "cheek"});
    const std::vector<SurfacePart>& surface = mesh.skin.surface;
    ASSERT_EQ(surface.size(), 4U) << "coat and hat, skin and cheek come to the same";
    const std::vector<std::vector<int>> triangles = {{0, 3, 6}, {1}, {2, 4}, {5}};
    for (size_t p = 0; p < surface.size(); ++p)
        EXPECT_EQ(trianglesOf(mesh.skin, surface[p]), triangles[p]) << p;
    EXPECT_EQ(surface[0].look->base_color, Eigen::Vector3f(0.9F, 0.5F, 0.4F));
    EXPECT_EQ(surface[1].look->base_color, Eigen::Vector3f(0.1F, 0.2F, 0.9F));
    EXPECT_EQ(surface[2].look->texture->file, test::kRedPng);
    EXPECT_EQ(surface[3].look->texture->file, test::kBluePng);
    EXPECT_FALSE(surface[0].look->texture);
    for (size_t p = 0; p < surface.size(); ++p) {
        const SkinnedVertex& corner = mesh.skin.vertices[mesh.skin.triangles[surface[p].first_triangle][1]];
        EXPECT_FLOAT_EQ(corner.uv.x(), p < 2 ? 0 : 0.3F) << "a place where there is a texture";
    }
    for (const MeshPart& part : mesh.parts)
        EXPECT_EQ(part.name, "part_" + std::to_string(trianglesOf(
                                           mesh.skin, {part.first_triangle, part.triangles, {}})[0]));
}

TEST_F(MeshOfManyLooks, KeepsThemWhenPartsGo) {
    const RiggedMesh mesh = imported({"skin", "eyes", "coat", "skin", "hat"});
    std::vector<bool> keep;
    for (const MeshPart& part : mesh.parts)
        keep.push_back(part.name == "part_3" || part.name == "part_2");
    const RiggedMesh kept = withParts(mesh, keep);
    ASSERT_TRUE(checkRiggedMesh(kept, "kept"));
    ASSERT_EQ(kept.skin.surface.size(), 2U) << "nothing has the eyes' look any more";
    EXPECT_EQ(trianglesOf(kept.skin, kept.skin.surface[0]), std::vector<int>{3});
    EXPECT_EQ(trianglesOf(kept.skin, kept.skin.surface[1]), std::vector<int>{2});
    EXPECT_EQ(kept.skin.surface[0].look->base_color, Eigen::Vector3f(0.9F, 0.5F, 0.4F));
    ASSERT_TRUE(kept.skin.surface[1].look->texture);
    EXPECT_EQ(kept.skin.surface[1].look->texture->file, test::kRedPng);
}

/// What is decoded is no larger than all textures together may be.
TEST_F(MeshOfManyLooks, ManyTexturesAreMadeSmaller) {
    static std::vector<int> sides;
    sides.clear();
    std::vector<std::string> names;
    std::string materials;
    for (int i = 0; i < 40; ++i) {
        names.push_back("m" + std::to_string(i));
        test::writeBytes(folder_.file(names.back() + ".png"), test::kRedPng + names.back());
        materials += "newmtl " + names.back() + "\nKd 1 1 1\nmap_Kd " + names.back() + ".png\n";
    }
    test::writeBytes(folder_.file("looks.mtl"), materials);
    const auto decode = [](SurfaceTexture&, int side_px) { sides.push_back(side_px); };
    EXPECT_EQ(imported(names, decode).skin.surface.size(), 40U);
    EXPECT_EQ(sides, std::vector<int>(40, 1024));
    sides.clear();
    imported({names[0], names[1]}, decode);
    EXPECT_EQ(sides, std::vector<int>(2, MeshLimits::kTextureSide_px));
}

TEST(MeshImport, SameThroughBytes) {
    if (!test::isShared(test::kKenney))
        GTEST_SKIP() << test::sayMissing(test::kKenney);
    const RiggedMesh mesh = test::sharedMesh(test::kKenney);
    const std::string bytes = toBytes(mesh);
    const auto again = meshFromBytes(bytes, "kenney");
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(toBytes(*again), bytes);
    EXPECT_EQ(again->nodes.size(), mesh.nodes.size());
    EXPECT_EQ(again->clips.front().tracks.size(), mesh.clips.front().tracks.size());
}

TEST(MeshImport, BytesCutShortOrChangedAreNoMesh) {
    RiggedMesh mesh;
    mesh.nodes.push_back({"root", -1});
    mesh.skin.bones.push_back({"root", Eigen::Matrix4f::Identity()});
    mesh.node_of_bone.push_back(0);
    for (const float x : {0.0F, 1.0F, 2.0F})
        mesh.skin.vertices.push_back({{x, x * x, 0}, {0, 0, 1}, {0, 0, 0, 0}, {1, 0, 0, 0}});
    mesh.skin.triangles.push_back({0, 1, 2});
    mesh.parts.push_back({"all", 0, 1});
    const std::string bytes = toBytes(mesh);
    ASSERT_TRUE(meshFromBytes(bytes, "x"));
    for (size_t length = 0; length < bytes.size(); ++length)
        EXPECT_FALSE(meshFromBytes(bytes.substr(0, length), "x")) << length;
    EXPECT_FALSE(meshFromBytes(bytes + "x", "x"));
    mesh.skin.vertices[1].weights[0] = std::nanf("");
    EXPECT_FALSE(meshFromBytes(toBytes(mesh), "x"));
    mesh.skin.vertices[1].weights[0] = 1;
    mesh.nodes[0].parent = 0;
    EXPECT_FALSE(meshFromBytes(toBytes(mesh), "x"));
}

TEST(MeshImport, WhatIsNoMeshIsRefusedByName) {
    const test::Folder folder;
    test::writeBytes(folder.file("empty.glb"), "");
    test::writeBytes(folder.file("points.obj"), "v 0 0 0\nv 1 0 0\n");
    test::writeBytes(folder.file("notes.txt"), "hello");
    for (const char* name : {"missing.fbx", "empty.glb", "points.obj", "notes.txt"}) {
        const auto mesh = importMesh(folder.file(name));
        ASSERT_FALSE(mesh) << name;
        EXPECT_NE(mesh.error().message.find(name), std::string::npos) << mesh.error().text();
        EXPECT_FALSE(mesh.error().remedy.empty());
    }
}

}  // namespace
}  // namespace noctule
