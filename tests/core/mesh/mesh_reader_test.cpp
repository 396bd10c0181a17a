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

/// A PNG of two by one pixels as far as its signature tells.
const std::string kPicture = std::string("\x89PNG\r\n\x1a\n", 8) + "not looked at";

/// With everything that a reader can hand over, and unrigged.
RiggedMesh texturedTriangle() {
    RiggedMesh mesh;
    for (const Eigen::Vector3f& p : {Eigen::Vector3f(0, 0, 0), {1, 0, 0}, {0, 1.7F, 0}})
        mesh.skin.vertices.push_back({p, {0, 0, 1}, {}, {}, {0.5F, -1.5F}});
    mesh.skin.triangles.push_back({0, 1, 2});
    mesh.parts.push_back({"triangle", 0, 1});
    mesh.skin.look = SurfaceLook{
        {0.2F, 0.4F, 1},
        std::make_shared<const SurfaceTexture>(SurfaceTexture{kPicture, 2, 1, std::vector<uint8_t>(8, 200)})};
    return mesh;
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
    mesh.look = texturedTriangle().skin.look;
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

using Lie = std::pair<const char*, std::function<void(RiggedMesh&)>>;

/// What a reader that somebody has taken over could say of the look.
std::vector<Lie> lies() {
    const auto texture = [](std::function<void(SurfaceTexture&)> change) {
        return [change](RiggedMesh& mesh) {
            auto changed = std::make_shared<SurfaceTexture>(*mesh.skin.look->texture);
            change(*changed);
            mesh.skin.look->texture = changed;
        };
    };
    std::vector<Lie> lies;
    for (const float odd : {NAN, INFINITY, -INFINITY, 3e38F, -2e4F}) {
        lies.emplace_back("uv", [=](RiggedMesh& mesh) { mesh.skin.vertices[1].uv.y() = odd; });
        lies.emplace_back("colour", [=](RiggedMesh& mesh) { mesh.skin.look->base_color.z() = odd; });
    }
    lies.emplace_back("brighter", [](RiggedMesh& mesh) { mesh.skin.look->base_color.x() = 1.01F; });
    lies.emplace_back("gif", texture([](SurfaceTexture& t) { t.file = "GIF89a"; }));
    lies.emplace_back("script", texture([](SurfaceTexture& t) { t.file = "#!/bin/sh"; }));
    lies.emplace_back("no pixels", texture([](SurfaceTexture& t) { t.rgba.pop_back(); }));
    lies.emplace_back("many pixels", texture([](SurfaceTexture& t) { t.rgba.resize(1000); }));
    lies.emplace_back("negative", texture([](SurfaceTexture& t) { t.width_px = t.height_px = -1; }));
    lies.emplace_back("wide", texture([](SurfaceTexture& t) { t.width_px = 1 << 30; }));
    lies.emplace_back("wide, undecoded", texture([](SurfaceTexture& t) {
                          t.width_px = 1 << 30;
                          t.rgba.clear();
                      }));
    return lies;
}

TEST(MeshReader, ALookThatIsNoneIsRefused) {
    ASSERT_TRUE(meshFromBytes(toBytes(texturedTriangle()), "lie.glb"));
    for (const auto& [what, tell] : lies()) {
        RiggedMesh mesh = texturedTriangle();
        tell(mesh);
        const auto read = meshFromBytes(toBytes(mesh), "lie.glb");
        ASSERT_FALSE(read) << what;
        EXPECT_EQ(read.error().kind, ErrorKind::kUnreadable) << what;
        EXPECT_NE(read.error().message.find("lie.glb"), std::string::npos);
    }
    RiggedMesh mesh = texturedTriangle();
    mesh.skin.look->texture = std::make_shared<const SurfaceTexture>(
        SurfaceTexture{kPicture + std::string(MeshLimits::kTextureBytes, ' ')});
    const auto large = checkRiggedMesh(mesh, "large.glb");
    ASSERT_FALSE(large);
    EXPECT_EQ(large.error().kind, ErrorKind::kUnusable);
}

/// What may be drawn and written into files; in words of its own, not checkRiggedMesh()'s.
bool looksHarmless(const RiggedMesh& mesh) {
    const auto within = [](double value, double low, double high) { return low <= value && value <= high; };
    for (const SkinnedVertex& vertex : mesh.skin.vertices)
        for (const float part : vertex.uv)
            if (!within(part, -1e4, 1e4))
                return false;
    if (!mesh.skin.look)
        return true;
    for (const float part : mesh.skin.look->base_color)
        if (!within(part, 0, 1))
            return false;
    const auto& texture = mesh.skin.look->texture;
    return !texture || ((texture->file.starts_with("\x89PNG") || texture->file.starts_with("\xff\xd8")) &&
                        texture->file.size() <= 64'000'000 && within(texture->width_px, 0, 2048) &&
                        within(texture->height_px, 0, 2048) &&
                        (texture->rgba.empty() || static_cast<int64_t>(texture->rgba.size()) ==
                                                      int64_t{4} * texture->width_px * texture->height_px));
}

TEST(FuzzMesh, DamagedAnswersOfTheReaderAreHarmless) {
    std::vector<std::string> answers(8, toBytes(texturedTriangle()));
    for (const auto& [what, tell] : lies()) {
        RiggedMesh mesh = texturedTriangle();
        tell(mesh);
        answers.push_back(toBytes(mesh));
    }
    int64_t read = 0, refused = 0;
    test::feedDamaged(answers, 20'000, 64 * 1024, [&](const std::string& damaged, int64_t) {
        const auto mesh = meshFromBytes(damaged, "damaged.glb");
        mesh ? ++read : ++refused;
        EXPECT_TRUE(!mesh || looksHarmless(*mesh));
    });
    EXPECT_GT(read, 0) << "wounds that change nothing that matters";
    std::printf("%lld answers were meshes, %lld refused\n", static_cast<long long>(read),
                static_cast<long long>(refused));
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
            EXPECT_TRUE(looksHarmless(*mesh));
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
