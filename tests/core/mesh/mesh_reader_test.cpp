// SPDX-License-Identifier: Apache-2.0
// Meshes from outside, read by a process of its own: what it reads is what we would have read, and nothing
// that it meets harms us.
#include "core/mesh/import/mesh_reader.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <map>

#include "core/body/actor.h"
#include "core/formats/glb_writer.h"
#include "core/mesh/import/rigged_mesh_bytes.h"
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
    mesh.skin.triangles = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}};
    mesh.parts.push_back({"triangle", 0, 3});
    const SurfaceLook look{
        {0.2F, 0.4F, 1},
        std::make_shared<const SurfaceTexture>(SurfaceTexture{kPicture, 2, 1, std::vector<uint8_t>(8, 200)})};
    mesh.skin.surface = {{0, 1, look}, {1, 1, std::nullopt}, {2, 1, SurfaceLook{{0, 1, 0}, look.texture}}};
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
    mesh.surface = {{0, 1, texturedTriangle().skin.surface[0].look}};
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
            SurfaceLook& look = *mesh.skin.surface[2].look;
            auto changed = std::make_shared<SurfaceTexture>(*look.texture);
            change(*changed);
            look.texture = changed;
        };
    };
    std::vector<Lie> lies;
    for (const float odd : {NAN, INFINITY, -INFINITY, 3e38F, -2e4F}) {
        lies.emplace_back("uv", [=](RiggedMesh& mesh) { mesh.skin.vertices[1].uv.y() = odd; });
        lies.emplace_back("colour",
                          [=](RiggedMesh& mesh) { mesh.skin.surface[0].look->base_color.z() = odd; });
    }
    lies.emplace_back("brighter",
                      [](RiggedMesh& mesh) { mesh.skin.surface[2].look->base_color.x() = 1.01F; });
    const auto surface = [&](const char* what, std::function<void(std::vector<SurfacePart>&)> change) {
        lies.emplace_back(what, [change](RiggedMesh& mesh) { change(mesh.skin.surface); });
    };
    surface("overlap", [](auto& parts) { parts[1].first_triangle = 0; });
    surface("gap", [](auto& parts) { parts[2].first_triangle = 3; });
    surface("beyond the last", [](auto& parts) { parts[2].triangles = 2; });
    surface("far beyond the last", [](auto& parts) { parts[2].triangles = UINT32_MAX; });
    surface("around", [](auto& parts) { parts[0].triangles = parts[1].first_triangle = UINT32_MAX; });
    surface("not to the last", [](auto& parts) { parts.pop_back(); });
    surface("out of order", [](auto& parts) { std::swap(parts[0].first_triangle, parts[2].first_triangle); });
    surface("nothing", [](auto& parts) { parts.insert(parts.begin(), SurfacePart{0, 0, {}}); });
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
}

TEST(MeshReader, ATextureThatIsNotThereIsRefused) {
    const std::string bytes = toBytes(texturedTriangle());
    const float color[] = {0.2F, 0.4F, 1};  // what texture the part has stands behind it
    const size_t at = bytes.find(std::string_view(reinterpret_cast<const char*>(color), sizeof color));
    ASSERT_NE(at, std::string::npos);
    for (const auto& [texture, is_read] : std::map<int32_t, bool>{
             {0, true}, {-1, true}, {1, false}, {-2, false}, {INT32_MAX, false}, {INT32_MIN, false}}) {
        std::string told = bytes;
        std::memcpy(told.data() + at + sizeof color, &texture, sizeof texture);
        EXPECT_EQ(static_cast<bool>(meshFromBytes(told, "lie.glb")), is_read) << texture;
    }
}

TEST(MeshReader, LooksHaveLimits) {
    const auto expectTooLarge = [](const std::vector<std::shared_ptr<const SurfaceTexture>>& textures) {
        RiggedMesh mesh = texturedTriangle();
        mesh.skin.triangles.assign(textures.size(), {0, 1, 2});
        mesh.skin.surface.clear();
        for (uint32_t t = 0; t < textures.size(); ++t)
            mesh.skin.surface.push_back({t, 1, SurfaceLook{{1, 1, 1}, textures[t]}});
        mesh.parts = {{"all", 0, static_cast<uint32_t>(textures.size())}};
        const auto large = checkRiggedMesh(mesh, "large.glb");
        ASSERT_FALSE(large);
        EXPECT_EQ(large.error().kind, ErrorKind::kUnusable) << large.error().text();
    };
    const auto file = [](size_t more) {
        return std::make_shared<const SurfaceTexture>(SurfaceTexture{kPicture + std::string(more, ' ')});
    };
    expectTooLarge({file(MeshLimits::kTextureBytes)});
    const auto half = file(MeshLimits::kTextureBytes / 2);
    std::vector<std::shared_ptr<const SurfaceTexture>> many(9, half);
    for (auto& texture : many)
        texture = std::make_shared<const SurfaceTexture>(*half);
    expectTooLarge(many);
    expectTooLarge(std::vector<std::shared_ptr<const SurfaceTexture>>(MeshLimits::kLooks + 1));
}

/// Each texture goes through the pipe, to the card and into files once.
TEST(MeshReader, LooksComeThroughAndShareTheirTextures) {
    const RiggedMesh mesh = texturedTriangle();
    const auto read = meshFromBytes(toBytes(mesh), "x");
    ASSERT_TRUE(read) << read.error().text();
    const std::vector<SurfacePart>& surface = read->skin.surface;
    ASSERT_EQ(surface.size(), 3U);
    for (size_t p = 0; p < surface.size(); ++p) {
        EXPECT_EQ(surface[p].first_triangle, p);
        EXPECT_EQ(surface[p].triangles, 1U);
    }
    EXPECT_FALSE(surface[1].look);
    EXPECT_EQ(surface[2].look->base_color, Eigen::Vector3f(0, 1, 0));
    EXPECT_EQ(surface[0].look->texture->file, kPicture);
    EXPECT_EQ(surface[0].look->texture, surface[2].look->texture);
    EXPECT_EQ(texturesOf(surface).size(), 1U);
}

bool within(double value, double low, double high) {
    return low <= value && value <= high;
}

bool pictureIsHarmless(const SurfaceTexture& texture) {
    return (texture.file.starts_with("\x89PNG") || texture.file.starts_with("\xff\xd8")) &&
           texture.file.size() <= 64'000'000 && within(texture.width_px, 0, 2048) &&
           within(texture.height_px, 0, 2048) &&
           (texture.rgba.empty() ||
            static_cast<int64_t>(texture.rgba.size()) == int64_t{4} * texture.width_px * texture.height_px);
}

/// What may be drawn and written into files; in words of its own, not checkRiggedMesh()'s.
bool looksHarmless(const RiggedMesh& mesh) {
    for (const SkinnedVertex& vertex : mesh.skin.vertices)
        for (const float part : vertex.uv)
            if (!within(part, -1e4, 1e4))
                return false;
    uint64_t next = 0;
    for (const SurfacePart& part : mesh.skin.surface) {
        if (part.first_triangle != next || !within(part.triangles, 1, 4e6))
            return false;
        next += part.triangles;
        if (part.look && !(part.look->base_color.minCoeff() >= 0 && part.look->base_color.maxCoeff() <= 1))
            return false;
        if (part.look && part.look->texture && !pictureIsHarmless(*part.look->texture))
            return false;
    }
    return mesh.skin.surface.empty() || next == mesh.skin.triangles.size();
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
