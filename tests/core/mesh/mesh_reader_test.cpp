// SPDX-License-Identifier: Apache-2.0
// Meshes from outside, read by a process of its own: what it reads is what we would have read, and nothing
// that it meets harms us.
#include "core/mesh/mesh_reader.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "core/body/actor.h"
#include "core/formats/glb_writer.h"
#include "core/mesh/rigged_mesh_bytes.h"
#include "tests/support/files.h"
#include "tests/support/fuzzing.h"
#include "tests/support/shared_meshes.h"

namespace noctule {
namespace {

const char* const kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1.7 0\nf 1 2 3\n";

std::string triangleFile(const test::Folder& folder) {
    test::writeBytes(folder.file("triangle.obj"), kTriangle);
    return folder.file("triangle.obj");
}

TEST(MeshReader, ReadsWhatTheLibraryReads) {
    const test::Folder folder;
    const std::string path = triangleFile(folder);
    const auto apart = importMeshApart(path), here = importMesh(path);
    ASSERT_TRUE(apart) << apart.error().text();
    EXPECT_EQ(toBytes(*apart), toBytes(*here));
    const auto tall = importMeshApart(path, {2.0});
    ASSERT_TRUE(tall);
    EXPECT_FLOAT_EQ(tall->skin.vertices[2].p_m.y(), 3.4F);
}

TEST(MeshReader, PassesErrorsOn) {
    const auto missing = importMeshApart("missing.glb");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().text(), importMesh("missing.glb").error().text());
}

TEST(MeshReader, AReaderThatIsNotThereIsSaid) {
    const test::Folder folder;
    const auto mesh = importMeshApart(triangleFile(folder), {}, {}, folder.file("no-reader"));
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().kind, ErrorKind::kInternal);
    EXPECT_NE(mesh.error().message.find("no-reader"), std::string::npos);
}

/// A reader that does something else.
std::string script(const test::Folder& folder, const std::string& commands) {
    const std::string path = folder.file("reader");
    test::writeBytes(path, "#!/bin/sh\n" + commands + "\n");
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path;
}

TEST(MeshReader, CrashesFloodsAndLiesCostAnErrorOnly) {
    const test::Folder folder;
    const std::string path = triangleFile(folder);
    const std::pair<const char*, const char*> readers[] = {
        {"kill -SEGV $$", "broke down"},
        {"exit 0", "broke off"},
        {"exit 12", "memory"},
        {"kill -ALRM $$", "longer than"},
        {"printf 'NCRM\\001\\000\\000\\000\\377\\377\\377\\377\\377\\377\\377\\377'", "broke off"},
        {"yes NCRM", ""},
    };
    for (const auto& [commands, words] : readers) {
        const auto mesh = importMeshApart(path, {}, {}, script(folder, commands), {.result_mb = 8});
        ASSERT_FALSE(mesh) << commands;
        EXPECT_EQ(mesh.error().kind, ErrorKind::kUnreadable) << commands;
        EXPECT_NE(mesh.error().message.find(path), std::string::npos);
        EXPECT_NE(mesh.error().message.find(words), std::string::npos) << mesh.error().text();
    }
}

TEST(MeshReader, GetsNothingOfOursAndEndsWithACancel) {
    const test::Folder folder;
    const std::string path = triangleFile(folder), seen = folder.file("seen");
    const int open_here = open(path.c_str(), O_RDONLY);
    setenv("NOCTULE_SECRET", "secret", 1);
    EXPECT_FALSE(importMeshApart(
        path, {}, {}, script(folder, "env > " + seen + "; ls -l /proc/self/fd >> " + seen + "; exit 0")));
    close(open_here);
    unsetenv("NOCTULE_SECRET");
    const std::string words = test::readBytes(seen);
    EXPECT_NE(words.find("/dev/null"), std::string::npos) << words;
    EXPECT_EQ(words.find("NOCTULE_SECRET"), std::string::npos) << words;
    EXPECT_EQ(words.find("triangle.obj"), std::string::npos) << words;
    CancelFlag flag;
    flag.cancel();
    const auto mesh = importMeshApart(path, {}, {nullptr, &flag}, script(folder, "sleep 100"));
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().kind, ErrorKind::kCancelled);
}

TEST(MeshReader, HasLimitsOfMemory) {
#ifdef NOCTULE_SANITIZED
    GTEST_SKIP() << "sanitizers reserve all addresses";
#endif
    const test::Folder folder;
    std::string text;
    for (int i = 0; i < 200'000; ++i)
        text += "v " + std::to_string(i) + " 0 0\nv 0 " + std::to_string(i) + " 1\nf -1 -2 1\n";
    test::writeBytes(folder.file("large.obj"), text);
    EXPECT_TRUE(importMeshApart(folder.file("large.obj")));
    const auto mesh =
        importMeshApart(folder.file("large.obj"), {}, {}, meshReaderProgram(), {.memory_mb = 120});
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().kind, ErrorKind::kUnreadable) << mesh.error().text();
}

/// Examples for the fuzzer: a small figure of ours, text formats with a rig, and what others made.
std::vector<std::pair<std::string, std::string>> examples(const test::Folder& folder) {
    std::vector<std::pair<std::string, std::string>> found = {{".obj", kTriangle}};
    found.emplace_back(".ply",
                       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                       "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                       "end_header\n0 0 0\n1 0 0\n0 1.7 0\n3 0 1 2\n");
    const Skeleton skeleton = defaultActor().skeleton;
    SkinnedMesh mesh;
    mesh.bones = bonesOf(skeleton);
    for (const Eigen::Vector3f& p : {Eigen::Vector3f(0, 0, 0), {1, 0, 0}, {0, 1.7F, 0}})
        mesh.vertices.push_back({p, {0, 0, 1}, {0, 1, 0, 0}, {0.5F, 0.5F, 0, 0}});
    mesh.triangles.push_back({0, 1, 2});
    if (writeSkinnedMesh(folder.file("ours.glb"), mesh, skeleton, true))
        found.emplace_back(".glb", test::readBytes(folder.file("ours.glb")));
    for (const std::string name :
         {"mesh/gltf/simple_skin.gltf", "mesh/gltf/quad_skin.glb", "mesh/gltf/RiggedSimple.glb",
          "fbx/maya_game_sausage_7500_binary_spin.fbx", "fbx/blender_279_sausage_6100_ascii.fbx"})
        if (test::isShared(name))
            found.emplace_back(std::filesystem::path(name).extension().string(),
                               test::readBytes(test::sharedPath(name)));
    return found;
}

TEST(FuzzMesh, DamagedFilesGiveAMeshOrAnError) {
    const test::Folder folder;
    const auto good = examples(folder);
    std::vector<std::string> bytes;
    for (const auto& [suffix, text] : good)
        bytes.push_back(text);
    int64_t read = 0, refused = 0, broke = 0, slow = 0;
    test::feedDamaged(bytes, 60, 64 * 1024, [&](const std::string& damaged, int64_t number) {
        // The suffix of the example that it came from; other kinds are met by chance through the splices.
        const std::string& suffix =
            good[test::Mutator(static_cast<uint64_t>(number), bytes).below(good.size())].first;
        const std::string path = folder.file("damaged" + suffix);
        test::writeBytes(path, damaged);
        const auto mesh =
            importMeshApart(path, {}, {}, meshReaderProgram(), {.seconds = 5, .memory_mb = 1024});
        if (mesh) {
            ++read;
            EXPECT_TRUE(checkRiggedMesh(*mesh, path));
            return;
        }
        ++refused;
        broke += mesh.error().message.find("broke down") != std::string::npos;
        slow += mesh.error().message.find("longer than") != std::string::npos;
        EXPECT_NE(mesh.error().message.find(path), std::string::npos) << mesh.error().text();
        EXPECT_FALSE(mesh.error().remedy.empty());
    });
    std::printf(
        "%lld could be opened, %lld refused, the reader broke down over %lld of them, %lld took too long\n",
        static_cast<long long>(read), static_cast<long long>(refused), static_cast<long long>(broke),
        static_cast<long long>(slow));
}

}  // namespace
}  // namespace noctule
