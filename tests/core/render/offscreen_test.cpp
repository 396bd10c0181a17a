// SPDX-License-Identifier: Apache-2.0
#include "core/render/offscreen.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace noctule {
namespace {

constexpr Rgba kGrey{0.5F, 0.5F, 0.5F, 1};
constexpr PictureSize kPictureSize{320, 240};

/// A cube of 1 m with one bone.
std::shared_ptr<const SkinnedMesh> cube() {
    auto mesh = std::make_shared<SkinnedMesh>();
    mesh->bones = {{"Hips", Eigen::Matrix4f::Identity()}};
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0F, 1.0F}) {
            const Eigen::Vector3f n = side * Eigen::Vector3f::Unit(axis);
            const Eigen::Vector3f u = Eigen::Vector3f::Unit((axis + 1) % 3), v = n.cross(u);
            const auto first = static_cast<uint32_t>(mesh->vertices.size());
            for (const auto& [a, b] : {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}})
                mesh->vertices.push_back({0.5F * (n + a * u + b * v), n, {0, 0, 0, 0}, {1, 0, 0, 0}});
            mesh->triangles.push_back({first, first + 1, first + 2});
            mesh->triangles.push_back({first, first + 2, first + 3});
        }
    return mesh;
}

Camera frontCamera() {
    Camera camera;
    camera.target_m = Vector3d::Zero();
    camera.azimuth_rad = camera.elevation_rad = 0;
    camera.distance_m = 5;
    return camera;
}

Scene emptyScene() {
    Scene scene;
    scene.background = {{0, 0, 0.2F, 1}, {0, 0, 0.2F, 1}};
    return scene;
}

SceneBody bodyOf(std::shared_ptr<const SkinnedMesh> mesh, BodyStyle style) {
    SceneBody body;
    body.mesh = std::move(mesh);
    body.skin = {Eigen::Matrix4f::Identity()};
    body.color = style == BodyStyle::kSolid ? kGrey : Rgba{1, 0, 0, 1};
    body.style = style;
    body.outline_px = 2;
    return body;
}

bool isBackground(const uint8_t* pixel) {
    return pixel[0] <= 1 && pixel[1] <= 1 && std::abs(pixel[2] - 51) <= 1;
}

class OffscreenPicture : public testing::Test {
protected:
    void SetUp() override {
        auto made = Offscreen::create();
        if (!made)
            GTEST_SKIP() << made.error().text();
        offscreen_ = std::move(*made);
    }
    Picture render(const Scene& scene, int samples = 0, PictureSize size = kPictureSize) {
        auto picture = offscreen_->render(scene, frontCamera(), size, samples);
        EXPECT_TRUE(picture) << picture.error().text();
        return picture ? *picture : Picture{};
    }

    std::unique_ptr<Offscreen> offscreen_;
};

TEST_F(OffscreenPicture, ShowsTheBackgroundFromTopToBottom) {
    Scene scene;
    scene.background = {{1, 0, 0, 1}, {0, 0, 1, 1}};
    const Picture picture = render(scene);
    ASSERT_EQ(picture.rgba.size(), 4U * 320 * 240);
    EXPECT_GT(picture.at(160, 2)[0], 240);
    EXPECT_GT(picture.at(160, 237)[2], 240);
    EXPECT_EQ(picture.at(160, 120)[3], 255);
}

TEST_F(OffscreenPicture, ShowsTheMeshWhereItIs) {
    Scene scene = emptyScene();
    scene.bodies = {bodyOf(cube(), BodyStyle::kSolid)};
    for (const int samples : {0, 4}) {
        const Picture picture = render(scene, samples);
        EXPECT_FALSE(isBackground(picture.at(160, 120)));
        EXPECT_TRUE(isBackground(picture.at(20, 20)));
    }
    scene.bodies[0].skin[0](0, 3) = 1.2F;  // to the right of the picture
    const Picture moved = render(scene);
    EXPECT_TRUE(isBackground(moved.at(140, 120)));
    EXPECT_FALSE(isBackground(moved.at(260, 120)));
}

TEST_F(OffscreenPicture, ATranslucentBodyShowsItsNearestSurfaceOnly) {
    Scene scene = emptyScene();
    scene.bodies = {bodyOf(cube(), BodyStyle::kSolid)};
    const Picture solid = render(scene);
    scene.bodies[0].opacity = 0.5F;
    const Picture translucent = render(scene);
    const uint8_t* pixel = translucent.at(160, 120);
    const double expected = 0.5 * solid.at(160, 120)[0];  // over a background without red
    EXPECT_NEAR(pixel[0], expected, 2);
}

/// Four colours, one to a quarter of the face that is seen: the texture's top row is at the top.
TEST_F(OffscreenPicture, ABodyShowsItsTextureTheRightWayUp) {
    SurfaceTexture texture{"PNG", 2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255}};
    auto mesh = std::make_shared<SkinnedMesh>(*cube());
    for (SkinnedVertex& vertex : mesh->vertices)
        vertex.uv = {vertex.p_m.x() + 0.5F, vertex.p_m.y() + 0.5F};
    const auto look = [&](const SurfaceLook& of_all) {
        mesh->surface = {{0, static_cast<uint32_t>(mesh->triangles.size()), of_all}};
    };
    look({{1, 1, 1}, std::make_shared<const SurfaceTexture>(texture)});
    Scene scene = emptyScene();
    scene.bodies = {bodyOf(mesh, BodyStyle::kSolid)};
    const Picture picture = render(scene);
    const auto isColor = [&](int x, int y, bool r, bool g, bool b) {
        const uint8_t* pixel = picture.at(160 + x, 120 + y);
        return (pixel[0] > 120) == r && (pixel[1] > 120) == g && (pixel[2] > 120) == b;
    };
    EXPECT_TRUE(isColor(-15, -15, true, false, false));
    EXPECT_TRUE(isColor(15, -15, false, true, false));
    EXPECT_TRUE(isColor(-15, 15, false, false, true));
    EXPECT_TRUE(isColor(15, 15, true, true, true));
    look({{0, 1, 0}, {}});
    scene.bodies = {bodyOf(std::make_shared<SkinnedMesh>(*mesh), BodyStyle::kSolid)};
    const Picture plain = render(scene);
    EXPECT_GT(plain.at(160, 120)[1], plain.at(160, 120)[0] + 60) << "the base colour, not the viewer's";
}

/// The face that is seen is two triangles: the lower right and the upper left one.
TEST_F(OffscreenPicture, EveryPartOfABodyHasItsOwnLook) {
    auto mesh = std::make_shared<SkinnedMesh>(*cube());
    const auto blue = std::make_shared<const SurfaceTexture>(SurfaceTexture{"PNG", 1, 1, {0, 0, 255, 255}});
    mesh->surface = {{0, 10, {}}, {10, 1, SurfaceLook{{1, 0, 0}, {}}}, {11, 1, SurfaceLook{{1, 1, 1}, blue}}};
    Scene scene = emptyScene();
    scene.bodies = {bodyOf(mesh, BodyStyle::kSolid)};
    for (const float opacity : {1.0F, 0.9F}) {
        scene.bodies[0].opacity = opacity;
        const Picture picture = render(scene);
        const uint8_t *right = picture.at(172, 132), *left = picture.at(148, 108);
        EXPECT_GT(right[0], right[2] + 60) << "red";
        EXPECT_GT(left[2], left[0] + 60) << "blue, from its texture";
    }
    mesh->surface = {{0, 11, SurfaceLook{{0, 1, 0}, {}}}, {11, 1, {}}};
    scene.bodies = {bodyOf(std::make_shared<SkinnedMesh>(*mesh), BodyStyle::kSolid)};
    const Picture picture = render(scene);
    const uint8_t *right = picture.at(172, 132), *left = picture.at(148, 108);
    EXPECT_GT(right[1], right[0] + 60);
    EXPECT_LE(std::abs(left[0] - left[1]), 2) << "the viewer's grey where nobody said";
}

TEST_F(OffscreenPicture, AGhostHasAnOutlineAndNoSurface) {
    Scene scene = emptyScene();
    scene.bodies = {bodyOf(cube(), BodyStyle::kOutline)};
    const Picture picture = render(scene);
    EXPECT_TRUE(isBackground(picture.at(160, 120)));
    int red = 0;
    for (int x = 0; x < 320; ++x)
        red += picture.at(x, 120)[0] > 200;
    EXPECT_GE(red, 3);
    EXPECT_LE(red, 8) << "two strokes of two pixels";
    // and shines through a solid body in front of it
    scene.bodies.push_back(bodyOf(cube(), BodyStyle::kSolid));
    scene.bodies[1].skin[0](2, 3) = 1;
    red = 0;
    const Picture covered = render(scene);
    for (int x = 0; x < 320; ++x)
        red += covered.at(x, 120)[0] > 200 && covered.at(x, 120)[1] < 60;
    EXPECT_GE(red, 3);
}

TEST_F(OffscreenPicture, ADashedRayHasGapsAndASolidOneHasNone) {
    Scene scene = emptyScene();
    scene.rays = {{{-1, 0, 0}, {1, 0, 0}, {1, 1, 1, 1}, 2, false}};
    const auto gaps = [](const Picture& picture) {
        int count = 0;
        for (int x = 100; x < 220; ++x)
            count += picture.at(x, 120)[0] < 40 && picture.at(x - 1, 120)[0] >= 40;
        return count;
    };
    EXPECT_EQ(gaps(render(scene)), 0);
    EXPECT_GT(render(scene).at(160, 120)[0], 200);
    scene.rays[0].dashed = true;
    EXPECT_GE(gaps(render(scene)), 12);
}

TEST_F(OffscreenPicture, RaysBehindABodyArePaler) {
    Scene scene = emptyScene();
    scene.rays = {{{-1, 0, -1}, {1, 0, -1}, {1, 0, 0, 1}, 3, false}};
    const int alone = render(scene).at(160, 120)[0];
    scene.bodies = {bodyOf(cube(), BodyStyle::kSolid)};
    scene.bodies[0].color = {0, 0, 0, 1};
    const int before =
        render({scene.background, {}, {}, scene.bodies, {}, {}, {}, {}, {}, {}, {}, {}}).at(160, 120)[0];
    const int behind = render(scene).at(160, 120)[0];
    EXPECT_GT(behind, before + 20) << "it shines through";
    EXPECT_LT(behind, alone - 60);
}

TEST_F(OffscreenPicture, BoardsSourcesAndRingsHaveTheirColours) {
    Scene scene = emptyScene();
    SceneBoard board;
    board.fill = {0, 1, 0, 1};
    board.edge = {1, 1, 1, 1};
    board.min_px = 40;
    scene.boards = {board};
    Picture picture = render(scene);
    EXPECT_EQ(picture.at(160, 120)[1], 255);
    EXPECT_EQ(picture.at(160, 120)[0], 0);
    EXPECT_EQ(picture.at(140, 120)[0], 255) << "white edge at the end of the longer side";
    scene.boards.clear();
    scene.rings = {{{0, 0, 0}, 30, 4, {1, 0, 0, 1}}};
    picture = render(scene);
    EXPECT_TRUE(isBackground(picture.at(160, 120)));
    EXPECT_EQ(picture.at(190, 120)[0], 255);
}

TEST_F(OffscreenPicture, TheSameSceneGivesTheSamePicture) {
    Scene scene = emptyScene();
    scene.bodies = {bodyOf(cube(), BodyStyle::kSolid)};
    scene.grid.emplace();
    scene.rays = {{{-1, -1, 0}, {1, 1, 0}, {1, 1, 1, 0.5F}, 1.3F, true}};
    const Picture first = render(scene, 4);
    EXPECT_EQ(first.rgba, render(scene, 4).rgba);
    auto other = Offscreen::create();
    ASSERT_TRUE(other);
    const auto again = (*other)->render(scene, frontCamera(), kPictureSize, 4);
    ASSERT_TRUE(again);
    EXPECT_EQ(first.rgba, again->rgba) << "from a second context";
    EXPECT_EQ(first.rgba, render(scene, 4).rgba) << "after another context has drawn";
}

TEST_F(OffscreenPicture, FollowsASizeThatChanges) {
    Scene scene = emptyScene();
    scene.bodies = {bodyOf(cube(), BodyStyle::kSolid)};
    for (const PictureSize size : {PictureSize{100, 50}, PictureSize{333, 201}, PictureSize{8, 8}}) {
        const Picture picture = render(scene, 4, size);
        EXPECT_EQ(picture.width_px, size.width_px);
        EXPECT_EQ(picture.rgba.size(), 4U * static_cast<size_t>(size.width_px * size.height_px));
        EXPECT_FALSE(isBackground(picture.at(size.width_px / 2, size.height_px / 2)));
    }
    const auto refused = offscreen_->render(scene, frontCamera(), {0, 10}, 0);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
}

TEST_F(OffscreenPicture, MeshesThatDoNotFitTheirSkinAreLeftOut) {
    Scene scene = emptyScene();
    scene.bodies = {bodyOf(cube(), BodyStyle::kSolid), SceneBody{}};
    scene.bodies[0].skin.clear();
    EXPECT_TRUE(isBackground(render(scene).at(160, 120)));
}

/// A square beam along X of 200 rings; each hangs half on a bone of its own and half on the last.
std::shared_ptr<SkinnedMesh> beam() {
    constexpr uint32_t kRings = 200;
    auto mesh = std::make_shared<SkinnedMesh>();
    for (uint32_t ring = 0; ring < kRings; ++ring) {
        mesh->bones.push_back({std::to_string(ring), Eigen::Matrix4f::Identity()});
        for (const auto& [y, z] : {std::pair{-0.4F, -0.4F}, {0.4F, -0.4F}, {0.4F, 0.4F}, {-0.4F, 0.4F}})
            mesh->vertices.push_back({{static_cast<float>(ring) / 100 - 1, y, z},
                                      Eigen::Vector3f(0, y, z).normalized(),
                                      {static_cast<uint16_t>(ring), kRings - 1, 0, 0},
                                      {0.5F, 0.5F, 0, 0}});
        for (uint32_t side = 0; ring && side < 4; ++side) {
            const uint32_t a = 4 * ring + side, b = 4 * ring + (side + 1) % 4;
            mesh->triangles.push_back({a, a - 4, b});
            mesh->triangles.push_back({b, a - 4, b - 4});
        }
    }
    return mesh;
}

TEST_F(OffscreenPicture, TheCardBlendsManyBonesAsTheProcessorDoes) {
    const auto mesh = beam();
    SceneBody body = bodyOf(mesh, BodyStyle::kSolid);
    body.skin.clear();
    for (size_t bone = 0; bone < mesh->bones.size(); ++bone) {
        Eigen::Affine3f T(Eigen::AngleAxisf(0.011F * static_cast<float>(bone), Eigen::Vector3f::UnitX()));
        T.translate(Eigen::Vector3f(0, 0.1F, 0)).scale(bone == 50 ? 1.5F : 1);
        body.skin.push_back(T.matrix());
    }
    std::vector<Picture> drawn;
    for (const Blending blending : {Blending::kLinear, Blending::kDualQuaternion}) {
        Scene scene = emptyScene();
        body.blending = blending;
        scene.bodies = {body};
        drawn.push_back(render(scene));
        const PosedSurface surface = skinned(*mesh, body.skin, blending);
        auto still = std::make_shared<SkinnedMesh>(*mesh);
        still->bones.resize(1);
        for (size_t v = 0; v < still->vertices.size(); ++v)
            still->vertices[v] = {surface.points_m[v], surface.normals[v], {}, {1, 0, 0, 0}};
        scene.bodies = {bodyOf(still, BodyStyle::kSolid)};
        drawn.push_back(render(scene));
    }
    const auto different = [&](const Picture& a, const Picture& b) {
        int count = 0;
        for (size_t i = 0; i < a.rgba.size(); ++i)
            count += std::abs(a.rgba[i] - b.rgba[i]) > 24;  // the card does not normalise within triangles
        return count;
    };
    EXPECT_LT(different(drawn[0], drawn[1]), 40);
    EXPECT_LT(different(drawn[2], drawn[3]), 40);
    EXPECT_GT(different(drawn[0], drawn[2]), 2000);  // the wrapped candy against the full one
}

}  // namespace
}  // namespace noctule
