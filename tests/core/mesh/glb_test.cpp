// SPDX-License-Identifier: Apache-2.0
// Skinned meshes in files: what is written reads back the same; other programs' bone names; damaged files.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/body/actor.h"
#include "core/formats/glb_writer.h"
#include "core/job/atomic_file.h"
#include "core/mesh/import/glb_reader.h"

namespace noctule {
namespace {

namespace fs = std::filesystem;

class Glb : public testing::Test {
protected:
    void SetUp() override {
        folder_ =
            fs::temp_directory_path() /
            ("noctule_glb_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    fs::path folder_;
};

/// A tetrahedron per joint, blended with its parent.
SkinnedMesh tetrahedra(const Skeleton& skeleton) {
    SkinnedMesh mesh;
    mesh.bones = bonesOf(skeleton);
    for (uint16_t j = 0; j < skeleton.size(); ++j) {
        const Eigen::Vector3f centre = -mesh.bones[j].bind_inverse.topRightCorner<3, 1>();
        const auto first = static_cast<uint32_t>(mesh.vertices.size());
        const auto parent = static_cast<uint16_t>(std::max(0, skeleton.joint(j).parent));
        for (const Eigen::Vector3f& corner :
             {Eigen::Vector3f(0, 0, 0), {0.03F, 0, 0}, {0, 0.04F, 0}, {0, 0, 0.05F}})
            mesh.vertices.push_back({centre + corner,
                                     (corner + Eigen::Vector3f(0.1F, -0.2F, 0.01F)).normalized(),
                                     {j, parent, 0, 0},
                                     {j == parent ? 1.0F : 0.7F, j == parent ? 0.0F : 0.3F, 0, 0}});
        for (const auto& [a, b, c] :
             {std::array{0U, 2U, 1U}, std::array{0U, 1U, 3U}, std::array{0U, 3U, 2U}, std::array{1U, 2U, 3U}})
            mesh.triangles.push_back({first + a, first + b, first + c});
    }
    return mesh;
}

std::map<std::string, float> weightsByJoint(const SkinnedMesh& mesh, const SkinnedVertex& vertex) {
    std::map<std::string, float> weights;
    for (size_t i = 0; i < 4; ++i)
        if (vertex.weights[i] > 0)
            weights[mesh.bones[vertex.bones[i]].joint] += vertex.weights[i];
    return weights;
}

void expectSame(const SkinnedMesh& read, const SkinnedMesh& written) {
    ASSERT_EQ(read.vertices.size(), written.vertices.size());
    EXPECT_EQ(read.triangles, written.triangles);
    ASSERT_EQ(read.bones.size(), written.bones.size());
    for (size_t b = 0; b < written.bones.size(); ++b) {
        EXPECT_EQ(read.bones[b].joint, written.bones[b].joint);
        EXPECT_LT((read.bones[b].bind_inverse - written.bones[b].bind_inverse).norm(), 1e-5F);
    }
    for (size_t v = 0; v < written.vertices.size(); ++v) {
        EXPECT_LT((read.vertices[v].p_m - written.vertices[v].p_m).norm(), 1e-5F);
        EXPECT_LT((read.vertices[v].normal - written.vertices[v].normal).norm(), 1e-5F);
        const auto expected = weightsByJoint(written, written.vertices[v]);
        const auto actual = weightsByJoint(read, read.vertices[v]);
        ASSERT_EQ(actual.size(), expected.size()) << v;
        for (const auto& [joint, weight] : expected)
            EXPECT_NEAR(actual.at(joint), weight, 1e-5) << joint;
    }
}

TEST_F(Glb, WhatIsWrittenReadsBackTheSame) {
    const Skeleton skeleton = defaultActor().skeleton;
    const SkinnedMesh mesh = tetrahedra(skeleton);
    ASSERT_TRUE(writeSkinnedMesh(path("a.glb"), mesh, skeleton, false));
    const auto read = readSkinnedMesh(path("a.glb"));
    ASSERT_TRUE(read) << read.error().text();
    expectSame(*read, mesh);
}

TEST_F(Glb, AnExistingFileIsKept) {
    const Skeleton skeleton = defaultActor().skeleton;
    ASSERT_TRUE(writeFileAtomically(path("a.glb"), "mine", false));
    const auto refused = writeSkinnedMesh(path("a.glb"), tetrahedra(skeleton), skeleton, false);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
    EXPECT_EQ(*readWholeFile(path("a.glb")), "mine");
}

/// The same skeleton under other names; the tree of nodes stays.
std::pair<SkinnedMesh, Skeleton> renamed(const std::map<std::string, std::string>& names,
                                         const std::string& prefix) {
    const Skeleton canonical = defaultActor().skeleton;
    SkinnedMesh mesh = tetrahedra(canonical);
    std::vector<Joint> joints = canonical.joints();
    for (size_t j = 0; j < joints.size(); ++j) {
        const auto found = names.find(joints[j].name);
        joints[j].name = prefix + (found == names.end() ? joints[j].name : found->second);
        mesh.bones[j].joint = joints[j].name;
    }
    return {mesh, Skeleton::make(joints).value()};
}

TEST_F(Glb, MixamoNamesAreKnown) {
    const auto [mesh, skeleton] = renamed({{"Chest", "Spine2"}}, "mixamorig:");
    ASSERT_TRUE(writeSkinnedMesh(path("m.glb"), mesh, skeleton, false));
    const auto read = readSkinnedMesh(path("m.glb"));
    ASSERT_TRUE(read) << read.error().text();
    expectSame(*read, tetrahedra(defaultActor().skeleton));
}

TEST_F(Glb, FinerBonesFoldIntoTheJointAboveThem) {
    const auto [mesh, skeleton] = renamed({{"LeftToeBase", "LeftBigToe"}}, "");
    ASSERT_TRUE(writeSkinnedMesh(path("t.glb"), mesh, skeleton, false));
    const auto read = readSkinnedMesh(path("t.glb"));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->bones.size(), mesh.bones.size() - 1);
    const size_t toe = static_cast<size_t>(skeleton.find("LeftBigToe")), foot = toe - 1;
    EXPECT_NEAR(weightsByJoint(*read, read->vertices[4 * toe]).at("LeftFoot"), 1, 1e-6);
    EXPECT_LT((read->bones[foot].bind_inverse - mesh.bones[foot].bind_inverse).norm(), 1e-5F);
}

TEST_F(Glb, UnknownBonesAreNamed) {
    const auto [mesh, skeleton] = renamed({{"Hips", "Bone.001"}}, "");
    ASSERT_TRUE(writeSkinnedMesh(path("u.glb"), mesh, skeleton, false));
    const auto read = readSkinnedMesh(path("u.glb"));
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(read.error().message.find("Bone.001"), std::string::npos) << read.error().message;
    EXPECT_NE(read.error().message.find("u.glb"), std::string::npos);
}

TEST_F(Glb, AMissingFileAndOneThatIsNoMeshAreUnreadable) {
    const auto missing = readSkinnedMesh(path("none.glb"));
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, ErrorKind::kUnreadable);
    ASSERT_TRUE(writeFileAtomically(path("text.glb"), "this is a letter, not a mesh", false));
    const auto text = readSkinnedMesh(path("text.glb"));
    ASSERT_FALSE(text);
    EXPECT_EQ(text.error().kind, ErrorKind::kUnreadable);
    EXPECT_NE(text.error().message.find("text.glb"), std::string::npos);
}

TEST_F(Glb, AMeshWithoutASkinIsNotUsable) {
    ASSERT_TRUE(writeFileAtomically(path("box.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", false));
    const auto read = readSkinnedMesh(path("box.obj"));
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().kind, ErrorKind::kUnusable);
    EXPECT_NE(read.error().message.find("skin"), std::string::npos);
}

TEST_F(Glb, ATruncatedFileIsRefused) {
    const Skeleton skeleton = defaultActor().skeleton;
    ASSERT_TRUE(writeSkinnedMesh(path("a.glb"), tetrahedra(skeleton), skeleton, false));
    const std::string whole = *readWholeFile(path("a.glb"));
    for (const double share : {0.0, 0.1, 0.5, 0.9}) {
        const auto length = static_cast<size_t>(share * static_cast<double>(whole.size()));
        ASSERT_TRUE(writeFileAtomically(path("cut.glb"), whole.substr(0, length), true));
        const auto read = readSkinnedMesh(path("cut.glb"));
        ASSERT_FALSE(read) << share;
        EXPECT_EQ(read.error().kind, ErrorKind::kUnreadable) << share;
    }
}

}  // namespace
}  // namespace noctule
