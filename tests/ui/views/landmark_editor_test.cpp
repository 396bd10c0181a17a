// SPDX-License-Identifier: Apache-2.0
// Landmarks set by hand: what the mouse drags, the keys push and the boxes say is the same, in metres.
#include "ui/views/performer/landmark_editor.h"

#include <gtest/gtest.h>

#include <QAccessible>
#include <QCheckBox>
#include <QLineEdit>
#include <QTest>

#include "core/mesh/rigged_mesh.h"
#include "tests/ui/support/mouse.h"
#include "ui/style/theme.h"
#include "ui/views/number_box.h"
#include "ui/views/performer/landmark_picture.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

/// As large as a person; what the points are set in.
std::shared_ptr<const SkinnedMesh> plank() {
    SkinnedMesh mesh;
    for (const Eigen::Vector3f& p : {Eigen::Vector3f(-0.3F, 0, 0), {0.3F, 0, 0}, {0, 1.8F, 0}, {0, 0, 0.3F}})
        mesh.vertices.push_back({p, {0, 0, 1}});
    mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
    return std::make_shared<const SkinnedMesh>(standingSurface(mesh));
}

class LandmarkEditorTest : public testing::Test {
protected:
    static void SetUpTestSuite() { Theme::install(*qApp); }
    LandmarkEditorTest() : found_(typicalLandmarks(1.8)), editor_(plank(), found_, found_) {
        editor_.resize(editor_.sizeHint());
        editor_.show();
        editor_.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&editor_));
    }
    QPoint at(LandmarkPicture::View view, const std::string& landmark) const {
        return editor_.picture->pointOf(view, landmark).toPoint();
    }
    void drag(LandmarkPicture::View view, const std::string& landmark, const QPoint& by) {
        const QPoint from = at(view, landmark);
        test::dragMouse(*editor_.picture, from, from + by);
    }
    void press(int key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(editor_.picture, static_cast<Qt::Key>(key), modifiers);
    }
    const Vector3d& place(const std::string& landmark) const { return editor_.places().at(landmark); }
    Vector3d moved(const std::string& landmark) const { return place(landmark) - found_.at(landmark); }
    double inBox(const std::string& landmark, int axis) const {
        return editor_.placeOf(landmark, axis)->value();
    }

    Landmarks found_;
    LandmarkEditor editor_;
};

TEST_F(LandmarkEditorTest, ADragMovesExactlyThatLandmark) {
    editor_.both_sides->setChecked(false);
    const double m_per_px = 1 / editor_.picture->pixelsPerMetre();
    const Vector3d hands_m = place("LeftHand") - place("RightHand");
    const LandmarkPicture& picture = *editor_.picture;
    EXPECT_NEAR(picture.pointOf(LandmarkPicture::kFront, "LeftHand").x() -
                    picture.pointOf(LandmarkPicture::kFront, "RightHand").x(),
                hands_m.x() / m_per_px, 1e-6);
    EXPECT_GT(hands_m.x() / m_per_px, 200);
    drag(LandmarkPicture::kFront, "LeftHand", {-12, 30});
    EXPECT_NEAR((moved("LeftHand") - m_per_px * Vector3d(-12, -30, 0)).norm(), 0, 1e-9) << moved("LeftHand");
    drag(LandmarkPicture::kLeftSide, "LeftLeg", {-9, -6});
    EXPECT_NEAR((moved("LeftLeg") - m_per_px * Vector3d(0, 6, 9)).norm(), 0, 1e-9)
        << "seen from its left, forward is to the left: " << moved("LeftLeg");
    for (const std::string& name : landmarkNames())
        if (name != "LeftHand" && name != "LeftLeg") {
            EXPECT_EQ(place(name), found_.at(name)) << name;
        }
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(inBox("LeftHand", axis), 100 * place("LeftHand")[axis], 0.0501) << axis;
}

TEST_F(LandmarkEditorTest, TheOtherSideFollowsWhileBothAreKeptAlike) {
    EXPECT_TRUE(editor_.both_sides->isChecked());
    drag(LandmarkPicture::kFront, "RightHand", {15, 20});
    EXPECT_GT(moved("RightHand").x(), 0.02);
    EXPECT_NEAR(place("LeftHand").x(), -place("RightHand").x(), 1e-12);
    EXPECT_EQ(place("LeftHand").y(), place("RightHand").y());
    EXPECT_NEAR(inBox("LeftHand", 0), 100 * place("LeftHand").x(), 0.0501);
    drag(LandmarkPicture::kFront, "HeadEnd", {15, -10});
    EXPECT_EQ(moved("HeadEnd").x(), 0) << "the middle stays in the middle";
    EXPECT_GT(moved("HeadEnd").y(), 0.02);
}

TEST_F(LandmarkEditorTest, AClickChoosesAndMovesNothing) {
    QTest::mouseClick(editor_.picture, Qt::LeftButton, {},
                      at(LandmarkPicture::kFront, "LeftHand") + QPoint(2, 1));
    EXPECT_EQ(editor_.picture->chosen(), "LeftHand");
    EXPECT_TRUE(editor_.isAsFound());
    EXPECT_FALSE(editor_.undo_button->isEnabled());
    test::moveMouse(*editor_.picture, at(LandmarkPicture::kFront, "RightFoot"));
    EXPECT_EQ(editor_.picture->hovered(), "RightFoot");
    test::moveMouse(*editor_.picture, {2, 2});
    EXPECT_EQ(editor_.picture->hovered(), "");
}

TEST_F(LandmarkEditorTest, KeysMoveTheChosenOne) {
    QTest::mouseClick(editor_.picture, Qt::LeftButton, {}, at(LandmarkPicture::kFront, "LeftFoot"));
    const std::pair<int, Vector3d> keys[] = {{Qt::Key_Left, {-1, 0, 0}},   {Qt::Key_Right, {1, 0, 0}},
                                             {Qt::Key_Up, {0, 1, 0}},      {Qt::Key_Down, {0, -1, 0}},
                                             {Qt::Key_PageUp, {0, 0, -1}}, {Qt::Key_PageDown, {0, 0, 1}}};
    for (const auto& [key, way] : keys)
        for (const bool is_large : {false, true}) {
            const Vector3d before = place("LeftFoot");
            press(key, is_large ? Qt::ShiftModifier : Qt::NoModifier);
            const Vector3d step = place("LeftFoot") - before;
            EXPECT_NEAR((step - (is_large ? 0.01 : 0.001) * way).norm(), 0, 1e-12) << key;
        }
    press(Qt::Key_Period);
    EXPECT_EQ(editor_.picture->chosen(), "LeftToeBase");
    press(Qt::Key_Comma);
    EXPECT_EQ(editor_.picture->chosen(), "LeftFoot");
}

TEST_F(LandmarkEditorTest, NumbersMoveThePicture) {
    QLineEdit* edit = editor_.placeOf("LeftLeg", 2)->findChild<QLineEdit*>();
    editor_.placeOf("LeftLeg", 2)->setFocus();
    EXPECT_EQ(editor_.picture->chosen(), "LeftLeg") << "a box that gets the keyboard chooses its landmark";
    const QPointF before = editor_.picture->pointOf(LandmarkPicture::kLeftSide, "LeftLeg");
    editor_.placeOf("LeftLeg", 2)->selectAll();
    QTest::keyClicks(edit, "12.5");
    QTest::keyClick(edit, Qt::Key_Tab);
    EXPECT_NEAR(place("LeftLeg").z(), 0.125, 1e-12);
    EXPECT_NEAR(place("RightLeg").z(), 0.125, 1e-12);
    EXPECT_EQ(place("LeftLeg").y(), found_.at("LeftLeg").y()) << "what the boxes round is not rounded";
    EXPECT_LT(editor_.picture->pointOf(LandmarkPicture::kLeftSide, "LeftLeg").x(), before.x() - 5);
}

TEST_F(LandmarkEditorTest, StepsAreUndoneAndAllIsFoundAgain) {
    drag(LandmarkPicture::kFront, "LeftHand", {10, 10});
    const Landmarks dragged = editor_.places();
    press(Qt::Key_Up);
    const Landmarks pushed = editor_.places();
    QTest::keyClick(editor_.placeOf("LeftLeg", 1), Qt::Key_Up);
    editor_.placeOf("LeftLeg", 1)->setFocus();
    QTest::keyClick(editor_.placeOf("LeftLeg", 1), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(editor_.places(), pushed) << "also while a box has the keyboard";
    editor_.picture->setFocus();
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(editor_.places(), dragged) << "a key is a step";
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(editor_.isAsFound()) << "a whole drag is a step";
    EXPECT_FALSE(editor_.undo_button->isEnabled());
    press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(editor_.places(), dragged);
    editor_.findAgain();
    EXPECT_TRUE(editor_.isAsFound());
    editor_.undo_button->click();
    EXPECT_EQ(editor_.places(), dragged);
}

TEST_F(LandmarkEditorTest, EscEndsADragAsIfItHadNotBeen) {
    const QPoint from = at(LandmarkPicture::kFront, "LeftHand");
    QTest::mousePress(editor_.picture, Qt::LeftButton, {}, from);
    test::moveMouse(*editor_.picture, from + QPoint(20, 20));
    EXPECT_FALSE(editor_.isAsFound());
    press(Qt::Key_Escape);
    EXPECT_TRUE(editor_.isAsFound());
    test::moveMouse(*editor_.picture, from + QPoint(30, 30));
    QTest::mouseRelease(editor_.picture, Qt::LeftButton, {}, from + QPoint(30, 30));
    EXPECT_TRUE(editor_.isAsFound());
    EXPECT_FALSE(editor_.undo_button->isEnabled());
    EXPECT_FALSE(editor_.redo_button->isEnabled());
}

TEST_F(LandmarkEditorTest, NearerByTheWheelADragIsFiner) {
    const double before = editor_.picture->pixelsPerMetre();
    const QPoint mouse = at(LandmarkPicture::kFront, "LeftHand");
    const QPointF off_before = editor_.picture->pointOf(LandmarkPicture::kFront, "LeftHand") - mouse;
    const auto zoom = [&] { return editor_.picture->pixelsPerMetre() / before; };
    QWheelEvent wheel(mouse, editor_.picture->mapToGlobal(mouse), {}, {0, 480}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(editor_.picture, &wheel);
    EXPECT_GT(editor_.picture->pixelsPerMetre(), 1.9 * before);
    const QPointF off = editor_.picture->pointOf(LandmarkPicture::kFront, "LeftHand") - mouse;
    EXPECT_LT(std::hypot(off.x() - zoom() * off_before.x(), off.y() - zoom() * off_before.y()), 0.01)
        << "what is under it stays";
    drag(LandmarkPicture::kFront, "LeftHand", {0, 10});
    EXPECT_NEAR(moved("LeftHand").y(), -10 / editor_.picture->pixelsPerMetre(), 1e-9);
}

TEST_F(LandmarkEditorTest, ScreenReadersHearWhichAndWhere) {
    QTest::mouseClick(editor_.picture, Qt::LeftButton, {}, at(LandmarkPicture::kFront, "LeftHand"));
    const QAccessibleInterface* read = QAccessible::queryAccessibleInterface(editor_.picture);
    ASSERT_NE(read, nullptr);
    EXPECT_FALSE(read->text(QAccessible::Name).isEmpty());
    EXPECT_TRUE(read->text(QAccessible::Value).contains(landmarkName("LeftHand")))
        << read->text(QAccessible::Value).toStdString();
    EXPECT_FALSE(editor_.placeOf("LeftHand", 0)->accessibleName().isEmpty());
}

}  // namespace
}  // namespace noctule::ui
