// SPDX-License-Identifier: Apache-2.0
#include "core/render/gizmo.h"

#include <gtest/gtest.h>

#include "core/math/rotation.h"

namespace noctule {
namespace {

class Gizmo : public testing::Test {
protected:
    void SetUp() override {
        view_.camera.target_m = {0, 1, 0};
        view_.camera.distance_m = 2;
        T_world_thing_.translation() = Vector3d(0.1, 1.05, 0.1);
        T_world_thing_.linear() = axisAngle(Vector3d(1, 2, 3).normalized(), 0.4).toRotationMatrix();
        gizmo_.p_m = T_world_thing_.translation().cast<float>();
        gizmo_.q_world_thing = Quaterniond(T_world_thing_.linear()).cast<float>();
    }
    Eigen::Vector2d px(const Vector3d& p_m) const { return view_.camera.project(p_m, view_.size)->head<2>(); }
    Vector3d axis(int index) const { return T_world_thing_.linear().col(index); }
    double arrow_m() const {
        return gizmo_.size_px / view_.camera.pixelsPerMetre(T_world_thing_.translation(), view_.size);
    }

    ScreenView view_{{}, {1280, 720}, 1};
    SceneGizmo gizmo_;
    Eigen::Isometry3d T_world_thing_ = Eigen::Isometry3d::Identity();
};

TEST_F(Gizmo, ArrowsAndRingsLieWhereTheyAreDrawn) {
    const std::array moves{GizmoPart::kMoveX, GizmoPart::kMoveY};
    for (int i = 0; i < 2; ++i)
        EXPECT_EQ(gizmoPartAt(gizmo_, view_, px(T_world_thing_.translation() + 0.95 * arrow_m() * axis(i))),
                  moves[static_cast<size_t>(i)]);
    const Vector3d on_ring =
        T_world_thing_.translation() + 0.72 * arrow_m() * (axis(0) + axis(1)).normalized();
    EXPECT_EQ(gizmoPartAt(gizmo_, view_, px(on_ring)), GizmoPart::kTurnZ);
    EXPECT_EQ(gizmoPartAt(gizmo_, view_, {5, 5}), GizmoPart::kNone);
    gizmo_.turns = false;
    EXPECT_EQ(gizmoPartAt(gizmo_, view_, px(on_ring)), GizmoPart::kNone);
}

TEST_F(Gizmo, MovesAlongTheAxisAsFarAsTheMouse) {
    for (const bool parallel : {false, true}) {
        view_.camera.parallel = parallel;
        const Vector3d from = T_world_thing_.translation() + 0.05 * axis(0);
        const Vector3d to = from + 0.12 * axis(0);
        const auto moved = dragGizmo(T_world_thing_, GizmoPart::kMoveX, view_, px(from), px(to));
        EXPECT_TRUE(moved.translation().isApprox(T_world_thing_.translation() + 0.12 * axis(0), 1e-6));
        EXPECT_TRUE(moved.linear().isApprox(T_world_thing_.linear()));
    }
}

TEST_F(Gizmo, TurnsAboutTheAxisAsFarAsTheMouse) {
    const auto onRing = [&](double angle) {
        return px(T_world_thing_.translation() +
                  0.1 * (std::cos(angle) * axis(0) + std::sin(angle) * axis(1)));
    };
    const auto turned = dragGizmo(T_world_thing_, GizmoPart::kTurnZ, view_, onRing(0.2), onRing(0.9));
    EXPECT_TRUE(turned.translation().isApprox(T_world_thing_.translation()));
    const Matrix3d turn = T_world_thing_.linear().transpose() * turned.linear();
    EXPECT_TRUE(turn.isApprox(axisAngle(Vector3d::UnitZ(), 0.7).toRotationMatrix(), 1e-6));
}

TEST_F(Gizmo, AnAxisThatPointsAtTheEyeStaysPut) {
    T_world_thing_.linear() = view_.camera.axes();
    T_world_thing_.translation() = view_.camera.target_m;
    const auto moved = dragGizmo(T_world_thing_, GizmoPart::kMoveZ, view_, {600, 300}, {700, 400});
    EXPECT_TRUE(moved.isApprox(T_world_thing_));
}

TEST_F(Gizmo, ARingSeenFromItsEdgeStillTurns) {
    T_world_thing_.linear() = view_.camera.axes();
    T_world_thing_.translation() = view_.camera.target_m;
    // The ring about x stands upright on the screen: down along its front turns towards the viewer.
    const auto turned = dragGizmo(T_world_thing_, GizmoPart::kTurnX, view_, {640, 360}, {640, 410});
    const Matrix3d turn = T_world_thing_.linear().transpose() * turned.linear();
    EXPECT_TRUE(turn.isApprox(axisAngle(Vector3d::UnitX(), 1.0).toRotationMatrix(), 1e-6));
}

TEST_F(Gizmo, NoPartLeavesThingsAlone) {
    EXPECT_TRUE(
        dragGizmo(T_world_thing_, GizmoPart::kNone, view_, {0, 0}, {50, 50}).isApprox(T_world_thing_));
}

TEST_F(Gizmo, TheHotHandleIsDrawnActive) {
    gizmo_.active = {1, 1, 1, 1};
    gizmo_.hot = GizmoPart::kMoveY;
    int active = 0;
    for (const LineShape& line : gizmoLines(gizmo_, view_))
        active += line.from_color == gizmo_.active;
    EXPECT_EQ(active, 3) << "shaft and two strokes of the head";
}

}  // namespace
}  // namespace noctule
