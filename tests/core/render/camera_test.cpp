// SPDX-License-Identifier: Apache-2.0
#include "core/render/camera.h"

#include <gtest/gtest.h>

#include <random>

namespace noctule {
namespace {

constexpr PictureSize kSize{1280, 720};

TEST(Camera, StandsBeforeThePerformerAtAzimuthZero) {
    Camera camera;
    camera.target_m = {1, 2, 3};
    camera.distance_m = 4;
    camera.azimuth_rad = camera.elevation_rad = 0;
    EXPECT_TRUE(camera.eye_m().isApprox(Vector3d(1, 2, 7)));
    // The performer's left (+X) is on the right of a front view.
    const auto left_hand = camera.project({2, 2, 3}, kSize);
    ASSERT_TRUE(left_hand);
    EXPECT_GT(left_hand->x(), 640);
    EXPECT_NEAR(left_hand->y(), 360, 1e-9);
    EXPECT_NEAR(left_hand->z(), 4, 1e-12);
}

TEST(Camera, PresetsLookAlongTheirAxes) {
    Camera camera;
    camera.setView(CameraView::kSide);
    EXPECT_TRUE(camera.axes().col(2).isApprox(Vector3d::UnitX()));
    EXPECT_TRUE(camera.parallel);
    camera.setView(CameraView::kTop);
    EXPECT_TRUE(camera.axes().col(2).isApprox(Vector3d::UnitY()));
    EXPECT_TRUE(camera.axes().col(1).isApprox(-Vector3d::UnitZ()));
    camera.setView(CameraView::kFront);
    EXPECT_TRUE(camera.axes().isApprox(Matrix3d::Identity()));
    camera.orbit(0.1, 0);
    EXPECT_FALSE(camera.parallel);
}

TEST(Camera, MatricesAgreeWithProject) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (const bool parallel : {false, true})
        for (int i = 0; i < 200; ++i) {
            Camera camera;
            camera.parallel = parallel;
            camera.azimuth_rad = 3 * uniform(random);
            camera.elevation_rad = 1.5 * uniform(random);
            const Vector3d p = camera.target_m + Vector3d{uniform(random), uniform(random), uniform(random)};
            const Eigen::Vector4d clip =
                camera.projectionMatrix(kSize) * camera.viewMatrix() * p.homogeneous();
            const auto px = camera.project(p, kSize);
            ASSERT_TRUE(px);
            EXPECT_NEAR(px->x(), (0.5 + 0.5 * clip.x() / clip.w()) * 1280, 1e-6);
            EXPECT_NEAR(px->y(), (0.5 - 0.5 * clip.y() / clip.w()) * 720, 1e-6);
            EXPECT_LT(std::abs(clip.z() / clip.w()), 1);
            // and back: the line of sight through that pixel meets the point
            EXPECT_NEAR(camera.sightLine(px->x(), px->y(), kSize).distanceTo(p), 0, 1e-9);
        }
}

TEST(Camera, SeesNothingBehindTheEye) {
    Camera camera;
    camera.azimuth_rad = camera.elevation_rad = 0;
    EXPECT_FALSE(camera.project(camera.eye_m() + Vector3d(0, 0, 1), kSize));
}

TEST(Camera, FramedBoxFitsAndFillsThePicture) {
    const Eigen::AlignedBox3d box(Vector3d(-0.8, 0, -0.3), Vector3d(0.8, 1.8, 0.3));
    for (const bool parallel : {false, true})
        for (const PictureSize size : {PictureSize{1280, 720}, PictureSize{300, 700}}) {
            Camera camera;
            camera.parallel = parallel;
            camera.frame(box, size, 0.05);
            double least = 1, most = 0;
            for (int corner = 0; corner < 8; ++corner) {
                const auto p =
                    camera.project(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)), size);
                ASSERT_TRUE(p);
                for (const double at : {p->x() / size.width_px, p->y() / size.height_px}) {
                    least = std::min(least, at);
                    most = std::max(most, at);
                }
            }
            EXPECT_GE(least, 0.05 - 1e-9);
            EXPECT_LE(most, 0.95 + 1e-9);
            EXPECT_TRUE(least < 0.06 || most > 0.94) << "the picture is not filled";
        }
}

TEST(Camera, PanMovesTheTargetsDepthWithTheMouse) {
    Camera camera;
    const Vector3d p = camera.target_m;
    const auto before = camera.project(p, kSize);
    camera.pan(37, -12, kSize);
    const auto after = camera.project(p, kSize);
    EXPECT_NEAR(after->x() - before->x(), 37, 1e-6);
    EXPECT_NEAR(after->y() - before->y(), -12, 1e-6);
}

TEST(Camera, ZoomAndOrbitKeepTheirLimits) {
    Camera camera;
    for (int i = 0; i < 100; ++i)
        camera.zoom(2);
    EXPECT_DOUBLE_EQ(camera.distance_m, Camera::kMinDistance_m);
    camera.orbit(0, 10);
    EXPECT_NEAR(camera.elevation_rad, std::numbers::pi / 2, 1e-12);
    EXPECT_TRUE(camera.viewMatrix().allFinite());
}

TEST(Camera, FliesTheShortWayRound) {
    Camera a, b;
    a.azimuth_rad = 3;
    b.azimuth_rad = -3;
    b.parallel = true;
    const Camera middle = Camera::between(a, b, 0.5);
    EXPECT_NEAR(std::abs(middle.azimuth_rad), std::numbers::pi, 1e-9);
    EXPECT_FALSE(middle.parallel);
    EXPECT_TRUE(Camera::between(a, b, 1).parallel);
}

}  // namespace
}  // namespace noctule
