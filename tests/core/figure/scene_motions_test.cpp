// SPDX-License-Identifier: Apache-2.0
// A motion in FBX and glTF is the same performance as in BVH, with and without a body.
#include "core/formats/fbx_writer.h"
#include "core/formats/glb_writer.h"
#include "core/formats/motion_document.h"
#include "core/mesh/import/mesh_import.h"
#include "tests/core/figure/dialects.h"
#include "tests/core/formats/sample_figure.h"
#include "tests/support/files.h"

namespace noctule::figure {
namespace {

Result<BvhDocument> motionOf(const std::string& path) {
    MeshImportSettings settings;
    settings.needs_surface = false;
    const auto mesh = importMesh(path, settings);
    return mesh ? sampledMotion(*mesh, path) : Result<BvhDocument>(mesh.error());
}

UnderstoodMotion understood(Result<BvhDocument> document) {
    EXPECT_TRUE(document) << document.error().text();
    auto motion = understandMotion(std::move(document).value());
    EXPECT_TRUE(motion) << motion.error().text();
    return std::move(motion).value();
}

struct SceneMotion : testing::TestWithParam<std::tuple<bool, const char*>> {};

TEST_P(SceneMotion, IsTheSamePerformance) {
    const auto [with_body, name] = GetParam();
    const test::Folder folder;
    const auto figure = makeFigure(
        test::sampleClip(4), with_body ? std::optional(test::shippedBody()) : std::nullopt, JointNames::kOwn);
    ASSERT_TRUE(figure) << figure.error().text();
    const std::string bvh = folder.file("walk.bvh"), scene = folder.file(name);
    ASSERT_TRUE(writeBvh(bvh, figure->clip, {}, false));
    const bool is_fbx = scene.ends_with(".fbx");
    const Status written = is_fbx ? writeFbx(scene, *figure, {}, false) : writeGlb(scene, *figure, false);
    ASSERT_TRUE(written) << written.error().text();

    const UnderstoodMotion expected = understood(readBvh(bvh)), read = understood(motionOf(scene));
    ASSERT_EQ(read.clip.frames.size(), expected.clip.frames.size());
    EXPECT_NEAR(read.clip.frame_time_s, expected.clip.frame_time_s, 1e-4);
    EXPECT_NEAR(read.measures.height_m, expected.measures.height_m, 0.002);
    const Difference difference = differenceOf(perform(expected), perform(read));
    EXPECT_LT(difference.mean_deg, 0.1);
    EXPECT_LT(difference.worst_deg, 0.5) << difference.worst;
}

INSTANTIATE_TEST_SUITE_P(Files, SceneMotion,
                         testing::Combine(testing::Bool(), testing::Values("walk.fbx", "walk.glb")));

TEST(SceneMotion, ABodyThatStandsIsNoMotion) {
    const auto document = motionOf(NOCTULE_SOURCE_DIR "/resources/bodies/mannequin.glb");
    ASSERT_FALSE(document);
    EXPECT_NE(document.error().text().find("no animation"), std::string::npos);
}

TEST(SceneMotion, TheClipThatMovesMostBonesIsTakenAndSaid) {
    RiggedMesh mesh;
    mesh.nodes = {{"Hips", -1}, {"Spine", 0}};
    const auto track = [](int node, double angle_rad, double rate_hz) {
        RigTrack moves{node, {}, {}, {}, {}};
        for (int k = 0; k < 4; ++k) {
            moves.t_s.push_back(1 + k / rate_hz);
            moves.p_m.emplace_back(0, 1, 0);
            moves.q_parent_node.push_back(axisAngle(Vector3d::UnitX(), angle_rad * k));
            moves.scale.emplace_back(2, 2, 2);
        }
        return moves;
    };
    mesh.clips = {{"still", 9, {track(0, 0, 30), track(1, 0, 30)}},
                  {"nods", 1.1, {track(0, 0.1, 29.97), track(1, 0.2, 29.97)}}};
    const auto document = sampledMotion(mesh, "two.fbx");
    ASSERT_TRUE(document) << document.error().text();
    EXPECT_NEAR(document->frame_time_s, 1.0 / 30, 1e-12);
    ASSERT_EQ(document->frameCount(), 4u) << "from the first key on";
    ASSERT_EQ(document->warnings.size(), 1u);
    EXPECT_NE(document->warnings[0].text.find("nods"), std::string::npos);
    // Scale of a parent counts for places, not for turns.
    const double* last = &document->values[3 * document->channel_count];
    EXPECT_NEAR(last[7], 2, 1e-9);
    EXPECT_NEAR(last[10], degrees(0.6), 0.05);
}

}  // namespace
}  // namespace noctule::figure
