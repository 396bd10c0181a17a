// SPDX-License-Identifier: Apache-2.0
#include "core/render/screen_shapes.h"

#include <gtest/gtest.h>

#include "core/render/picking.h"

namespace noctule {
namespace {

ScreenView frontView() {
    ScreenView view{{}, {800, 600}, 1};
    view.camera.target_m = Vector3d::Zero();
    view.camera.distance_m = 4;
    view.camera.azimuth_rad = view.camera.elevation_rad = 0;
    return view;
}

TEST(ScreenShapes, GridLiesOnTheGroundAndFadesOut) {
    SceneGrid grid;
    grid.centre_m = {1.2F, 5, -0.7F};
    grid.line = {1, 1, 1, 1};
    grid.axis_x = {1, 0, 0, 1};
    const auto lines = gridLines(grid);
    ASSERT_FALSE(lines.empty());
    bool has_axis = false;
    for (const LineShape& line : lines) {
        EXPECT_EQ(line.from_m.y(), 0);
        EXPECT_EQ(line.to_m.y(), 0);
        const float r = (line.to_m - Eigen::Vector3f(1, 0, -0.5F)).norm();
        if (r > grid.radius_m) {
            EXPECT_EQ(line.to_color.a, 0);
        }
        if (line.from_color.g == 0 && line.from_color.r == 1) {
            has_axis = true;
            EXPECT_EQ(line.from_m.z(), 0) << "the x axis runs through the origin";
        }
    }
    EXPECT_TRUE(has_axis);
}

TEST(ScreenShapes, TrailFadesTowardsItsOldestPoint) {
    SceneTrail trail;
    for (int i = 0; i < 5; ++i)
        trail.points_m.emplace_back(static_cast<float>(i), 0.0F, 0.0F);
    trail.color = {1, 1, 1, 0.8F};
    std::vector<LineShape> lines;
    appendTrail(trail, 2, lines);
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_EQ(lines.front().from_color.a, 0);
    EXPECT_FLOAT_EQ(lines.back().to_color.a, 0.8F);
    EXPECT_FLOAT_EQ(lines.front().width_px, 2 * trail.width_px);
    for (size_t i = 1; i < lines.size(); ++i)
        EXPECT_EQ(lines[i].from_color, lines[i - 1].to_color);
}

TEST(ScreenShapes, BoardsTurnWithTheirOrientationAndKeepTheirLeastSize) {
    Scene scene;
    SceneBoard board;
    board.min_px = 20;
    scene.boards = {board, board};
    scene.boards[1].q_world_board = Eigen::AngleAxisf(0.5F, Eigen::Vector3f::UnitZ());
    ScreenView view = frontView();
    const auto markers = deviceMarkers(scene, view);
    ASSERT_EQ(markers.size(), 2U);
    const float length = (markers[0].corner[1] - markers[0].corner[0]).norm() + 2 * markers[0].radius_px;
    EXPECT_NEAR(length, 20, 2);
    EXPECT_NEAR(markers[0].corner[1].y(), markers[0].corner[0].y(), 1e-4);
    const Eigen::Vector2f turned = markers[1].corner[1] - markers[1].corner[0];
    EXPECT_NEAR(std::atan2(-turned.y(), turned.x()), 0.5, 1e-4) << "counter-clockwise on the screen";
    view.ratio = 2;
    const auto doubled = deviceMarkers(scene, view);
    EXPECT_NEAR((doubled[0].corner[1] - doubled[0].corner[0]).norm(),
                2 * (markers[0].corner[1] - markers[0].corner[0]).norm(), 0.1);
}

TEST(ScreenShapes, FartherDevicesAreDrawnFirst) {
    Scene scene;
    scene.boards.resize(1);
    scene.boards[0].p_m = {0, 0, 1};
    scene.sources.resize(1);
    scene.sources[0].p_m = {0, 0, -1};
    const auto markers = deviceMarkers(scene, frontView());
    ASSERT_EQ(markers.size(), 2U);
    EXPECT_EQ(markers[0].radius_px, 0) << "the source, an ellipse";
    EXPECT_GT(markers[0].distance_m, markers[1].distance_m);
    scene.sources[0].p_m = {0, 0, 100};
    EXPECT_EQ(deviceMarkers(scene, frontView()).size(), 1U) << "behind the eye";
}

TEST(ScreenShapes, SourcesSeenFromTheSideAreNarrowButNotLost) {
    Scene scene;
    scene.sources.resize(2);
    scene.sources[1].normal = Eigen::Vector3f::UnitX();
    const auto markers = deviceMarkers(scene, frontView());
    EXPECT_FLOAT_EQ(markers[0].minor_px, markers[0].half_axis_px.norm());
    EXPECT_LT(markers[1].minor_px, markers[1].half_axis_px.norm());
    EXPECT_GT(markers[1].minor_px, 1);
    EXPECT_NEAR(markers[1].half_axis_px.x(), 0, 1e-4) << "the longer axis stands upright";
}

TEST(Picking, TakesTheNearestAndOfTwoUponEachOtherTheFrontOne) {
    const ScreenView view = frontView();
    const std::vector<Vector3d> points{{0, 0, -0.5}, {0, 0, 0.5}, {0.5, 0, 0}};
    const auto front = pointUnderPixel(points, view, {401, 300}, 12);
    ASSERT_TRUE(front);
    EXPECT_EQ(front->index, 1U);
    const auto px = view.camera.project(points[2], view.size);
    const auto right = pointUnderPixel(points, view, px->head<2>() + Eigen::Vector2d(3, 4), 12);
    ASSERT_TRUE(right);
    EXPECT_EQ(right->index, 2U);
    EXPECT_NEAR(right->distance_px, 5, 1e-9);
    EXPECT_FALSE(pointUnderPixel(points, view, {10, 10}, 12));
}

}  // namespace
}  // namespace noctule
