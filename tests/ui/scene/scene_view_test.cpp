// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/scene_view.h"

#include <QAccessible>
#include <QPainter>
#include <QScopeGuard>
#include <QSignalSpy>

#include "core/render/body_scene.h"
#include "core/suit/default_suit.h"
#include "tests/ui/scene/scene_fixture.h"
#include "ui/scene/scene_overlay.h"
#include "ui/scene/scene_tools.h"
#include "ui/scene/scene_words.h"
#include "ui/style/lengths.h"
#include "ui/widgets/empty_state.h"

namespace noctule::ui {
namespace {

class SceneViewTest : public test::SceneFixture {
protected:
    BodyPlaces placesNow() const {
        return placeBody(actor_.skeleton, poseAt(studio_->time().time()), studio_->take().overview()->suit,
                         nullptr);
    }
    QPoint onScreen(const Vector3d& p_m) const {
        const auto px = view_->camera().project(p_m, {view_->width(), view_->height()});
        return {static_cast<int>(std::lround(px->x())), static_cast<int>(std::lround(px->y()))};
    }
};

TEST_F(SceneViewTest, SaysWhatWillBeHereAndThenShowsTheBody) {
    EXPECT_EQ(view_->descriptionInWords(), "The body of the take that you open appears here.");
    const QImage before = picture();
    ASSERT_FALSE(before.isNull());
    const auto* message = view_->findChild<EmptyState*>();
    EXPECT_TRUE(message->isVisible());
    openTake();
    EXPECT_FALSE(message->isVisible());
    const QImage after = picture();
    EXPECT_GT(test::differing(before, after), 3000);
    // One board hears the only source, with a confidence of a quarter.
    EXPECT_EQ(view_->descriptionInWords(), "Body at 0:00.8, 0 of 2 pairs good");
    view_->setShown(SceneLayer::kMesh, false);
    EXPECT_GT(test::differing(after, picture()), 3000) << "the mesh was seen";
}

TEST_F(SceneViewTest, FollowsTheTimeCursor) {
    openTake();
    const QImage before = picture();
    studio_->time().setTime(1.6);
    settle();
    EXPECT_GT(test::differing(before, picture()), 2000);
    EXPECT_TRUE(view_->descriptionInWords().startsWith("Body at 0:01.6"));
}

TEST_F(SceneViewTest, TheBodyStaysToTheEndOfTheTake) {
    openTake();
    const double last_s = 1e-9 * static_cast<double>(studio_->take().shownMotion()->frames.back().time_ns);
    ASSERT_LT(last_s, studio_->time().duration()) << "poses end a moment before the take";
    studio_->time().setTime(studio_->time().duration());
    settle();
    EXPECT_TRUE(view_->descriptionInWords().startsWith("Body at"))
        << view_->descriptionInWords().toStdString();
}

TEST_F(SceneViewTest, TheWholeMotionIsInThePictureBelowTheTools) {
    openTake();
    const int below = view_->findChild<SceneTools*>()->geometry().bottom() + 1;
    const QRect free(0, below, view_->width(), view_->height() - below);
    const auto motion = studio_->take().shownMotion();
    for (const TimedPose& frame : motion->frames) {
        if (!frame.pose)
            continue;
        const BodyPlaces places = placeBody(motion->skeleton, *frame.pose, {}, nullptr);
        for (const Vector3d& p_m : places.joints.p_world_joint) {
            const QPoint at = onScreen(p_m);
            ASSERT_TRUE(free.contains(at))
                << at.x() << ", " << at.y() << " at " << 1e-9 * static_cast<double>(frame.time_ns) << " s";
        }
    }
}

TEST_F(SceneViewTest, KeysSwitchViews) {
    openTake();
    QSignalSpy changed(view_.get(), &SceneView::viewChanged);
    QTest::keyClick(view_.get(), Qt::Key_1);
    EXPECT_EQ(view_->view(), CameraView::kFront);
    EXPECT_NEAR(view_->camera().azimuth_rad, 0, 1e-9);
    QTest::keyClick(view_.get(), Qt::Key_3);
    EXPECT_EQ(view_->view(), CameraView::kSide);
    EXPECT_TRUE(view_->camera().parallel);
    QTest::keyClick(view_.get(), Qt::Key_7);
    EXPECT_EQ(view_->view(), CameraView::kTop);
    EXPECT_EQ(changed.count(), 3);
}

TEST_F(SceneViewTest, KeysToggleLayersAndFollow) {
    openTake();
    const bool rays = view_->isShown(SceneLayer::kRays), ghost = view_->isShown(SceneLayer::kGhost);
    QTest::keyClick(view_.get(), Qt::Key_R);
    EXPECT_NE(view_->isShown(SceneLayer::kRays), rays);
    QTest::keyClick(view_.get(), Qt::Key_G);
    EXPECT_NE(view_->isShown(SceneLayer::kGhost), ghost);
    QTest::keyClick(view_.get(), Qt::Key_F, Qt::ShiftModifier);
    EXPECT_TRUE(view_->follows());
    // The choice survives, and belongs to this step.
    EXPECT_EQ(SceneView(*studio_).isShown(SceneLayer::kRays), !rays);
    EXPECT_TRUE(SceneView(*studio_).follows());
    EXPECT_FALSE(SceneView(*studio_, nullptr, Step::kPerformer).follows());
}

TEST_F(SceneViewTest, RaysComeAndGo) {
    openTake();
    const QImage with = picture();
    view_->setShown(SceneLayer::kRays, false);
    EXPECT_GT(test::differing(with, picture()), 20);
}

TEST_F(SceneViewTest, TheReferenceIsAGhost) {
    openTake();
    const QImage alone = picture();
    studio_->take().setComparedRun(TakeDocument::kReference);
    ASSERT_TRUE(waitFor([this] { return studio_->take().comparedMotion() != nullptr; }));
    settle();
    const QImage with_ghost = picture();
    EXPECT_GT(test::differing(alone, with_ghost), 100);
    view_->setShown(SceneLayer::kGhost, false);
    settle();
    EXPECT_LT(test::differing(alone, picture()), 20);
}

TEST_F(SceneViewTest, AClickPicksTheBoard) {
    openTake();
    const QPoint board = onScreen(placesNow().boards[1].p_m);
    QTest::mouseClick(canvas(), Qt::LeftButton, {}, board);
    EXPECT_EQ(studio_->selection().board(), 1);
    settle();
    EXPECT_TRUE(view_->descriptionInWords().contains("board 2")) << view_->descriptionInWords().toStdString();
    QTest::mouseClick(canvas(), Qt::LeftButton, {}, QPoint(view_->width() - 5, view_->height() / 2));
    EXPECT_EQ(studio_->selection().board(), -1) << "a click beside everything chooses nothing";
}

TEST_F(SceneViewTest, MiddleDragOrbitsShiftPansWheelZooms) {
    openTake();
    const Camera start = view_->camera();
    const QPoint from(300, 260), to(360, 280);
    const auto drag = [&](Qt::MouseButton button, Qt::KeyboardModifiers keys) {
        QTest::mousePress(canvas(), button, keys, from);
        QMouseEvent move(QEvent::MouseMove, to, canvas()->mapToGlobal(to), Qt::NoButton, button, keys);
        QApplication::sendEvent(canvas(), &move);
        QTest::mouseRelease(canvas(), button, keys, to);
    };
    drag(Qt::MiddleButton, {});
    EXPECT_LT(view_->camera().azimuth_rad, start.azimuth_rad) << "the scene turns with the mouse";
    EXPECT_TRUE(view_->camera().target_m.isApprox(start.target_m));
    const double azimuth_rad = view_->camera().azimuth_rad;
    drag(Qt::MiddleButton, Qt::ShiftModifier);
    EXPECT_EQ(view_->camera().azimuth_rad, azimuth_rad);
    EXPECT_FALSE(view_->camera().target_m.isApprox(start.target_m));
    QWheelEvent wheel(QPointF(from), canvas()->mapToGlobal(from), {}, {0, 120}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(canvas(), &wheel);
    EXPECT_LT(view_->camera().distance_m, start.distance_m);
}

TEST_F(SceneViewTest, MayaNavigationNeedsAlt) {
    studio_->settings().setValue("scene/navigation", "maya");
    makeView();
    openTake();
    const Camera start = view_->camera();
    QTest::mousePress(canvas(), Qt::MiddleButton, {}, {300, 260});
    QTest::mouseMove(canvas(), {340, 260});
    QTest::mouseRelease(canvas(), Qt::MiddleButton, {}, {340, 260});
    EXPECT_EQ(view_->camera().azimuth_rad, start.azimuth_rad);
    QTest::mousePress(canvas(), Qt::LeftButton, Qt::AltModifier, {300, 260});
    QMouseEvent move(QEvent::MouseMove, QPoint(340, 260), canvas()->mapToGlobal(QPoint(340, 260)),
                     Qt::NoButton, Qt::LeftButton, Qt::AltModifier);
    QApplication::sendEvent(canvas(), &move);
    QTest::mouseRelease(canvas(), Qt::LeftButton, Qt::AltModifier, {340, 260});
    EXPECT_NE(view_->camera().azimuth_rad, start.azimuth_rad);
}

TEST_F(SceneViewTest, FollowKeepsTheBodyInPlace) {
    openTake();
    view_->setFollow(true);
    settle();
    const Vector3d before = view_->camera().target_m;
    studio_->time().setTime(1.8);
    settle();
    const Vector3d moved = view_->camera().target_m - before;
    const Vector3d walked = poseAt(1.8).p_world_root - poseAt(0.8).p_world_root;
    EXPECT_NEAR(moved.x(), walked.x(), 0.02);
    EXPECT_NEAR(moved.z(), walked.z(), 0.02);
    EXPECT_EQ(moved.y(), 0);
}

TEST_F(SceneViewTest, FrameBodyBringsItBack) {
    openTake();
    Camera away = view_->camera();
    away.target_m += Vector3d(20, 0, 0);
    view_->setCamera(away);
    settle();
    QTest::keyClick(view_.get(), Qt::Key_F);
    EXPECT_LT((view_->camera().target_m - poseAt(0.8).p_world_root).norm(), 1);
}

TEST_F(SceneViewTest, ScreenReadersHearWhatIsSeen) {
    openTake();
    QAccessibleInterface* accessible = QAccessible::queryAccessibleInterface(view_.get());
    ASSERT_TRUE(accessible);
    EXPECT_EQ(accessible->role(), QAccessible::Graphic);
    EXPECT_EQ(accessible->text(QAccessible::Name), "3D view");
    EXPECT_EQ(accessible->text(QAccessible::Description), view_->descriptionInWords());
}

TEST_F(SceneViewTest, ClosingTheTakeEmptiesTheView) {
    openTake();
    studio_->take().close();
    settle();
    EXPECT_EQ(view_->descriptionInWords(), "The body of the take that you open appears here.");
}

TEST(SceneOverlayTest, InANarrowViewWordsStandBelowTheBody) {
    Theme::install(*qApp);
    Theme::get().setScale(1);
    OverlayContent content;
    content.legends = {{"Result 1", false}, {"Result 2", true}};
    content.callout = SceneCallout{{190, 200}, "Left shin, board 14", "Source 3, confidence 0.71"};
    QImage image(380, 520, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    SceneOverlay::paint(painter, QRectF(image.rect()), content);
    painter.end();
    int above = 0, below = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            (y < 416 ? above : below) += qAlpha(image.pixel(x, y)) > 0;
    EXPECT_EQ(above, 0) << "here the body stands";
    EXPECT_GT(below, 100);
}

/// Somebody who stands with legs apart: the shin that is chosen is the left one in the picture.
SceneCallout shinOfAStandingBody() {
    SceneCallout callout{{330, 400}, "Right shin, board 17", "Source 8, confidence 0.71"};
    for (int i = 0; i <= 10; ++i) {
        callout.bodies.emplace_back(350 - 4 * i, 260 + 22 * i);
        callout.bodies.emplace_back(350 + 4 * i, 260 + 22 * i);
        callout.bodies.emplace_back(350, 80 + 18 * i);
    }
    return callout;
}

TEST(SceneOverlayTest, TheCalloutStandsBesideTheBodies) {
    Theme::install(*qApp);
    Theme::get().setScale(1);
    const QRectF area(0, 0, 700, 500);
    SceneCallout callout = shinOfAStandingBody();
    const auto covers = [&] {
        const QRectF box = SceneOverlay::calloutBox(area, callout);
        EXPECT_TRUE(area.contains(box));
        return std::ranges::any_of(callout.bodies, [&](const QPointF& p) { return box.contains(p); });
    };
    EXPECT_FALSE(covers());
    EXPECT_GT(SceneOverlay::calloutBox(area, callout).left(), 380) << "beyond the other leg";
    const size_t shown = callout.bodies.size();
    for (size_t i = 0; i < shown; ++i)
        callout.bodies.push_back(callout.bodies[i] + QPointF(150, 0));
    EXPECT_FALSE(covers()) << "nor on the compared one";
    EXPECT_LT(SceneOverlay::calloutBox(area, callout).right(), 330) << "there is room on the left";
}

TEST_F(SceneViewTest, TheCalloutKnowsTheBodyThatItMustNotCover) {
    openTake();
    studio_->selection().setBoard(static_cast<int>(studio_->take().overview()->suit.boards.size()) - 1);
    const auto* overlay = view_->findChild<SceneOverlay*>();
    ASSERT_TRUE(overlay && waitFor([&] { return overlay->content().callout.has_value(); }));
    const SceneCallout& callout = *overlay->content().callout;
    const QRectF box = SceneOverlay::calloutBox(overlay->rect(), callout);
    ASSERT_FALSE(callout.bodies.empty());
    for (const QPointF& p : callout.bodies)
        EXPECT_FALSE(box.contains(p)) << p.x() << ", " << p.y();
}

OverlayContent twoPeople() {
    OverlayContent content;
    content.has_axes = false;
    content.legends = {{"Result 1", false}, {"Result 2", true}};
    content.callout = SceneCallout{{300, 300}, "Pelvis, board 1", "Not heard from source 1"};
    content.distance = SceneDistance{{360, 250}, {360, 300}, "1.50 m", "right wrist of A to left wrist of B"};
    return content;
}

int painted(const OverlayContent& content, const QSize& size) {
    QImage image(size, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    SceneOverlay::paint(painter, QRectF(image.rect()), content);
    painter.end();
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += qAlpha(image.pixel(x, y)) > 0;
    return count;
}

TEST(SceneOverlayTest, TheDistanceStandsClearOfTheCallout) {
    Theme::install(*qApp);
    Theme::get().setScale(1);
    const QRectF area(0, 0, 700, 500);
    OverlayContent content = twoPeople();
    const auto clear = SceneOverlay::distanceBox(area, content);
    content.callout.reset();
    const auto at_rest = SceneOverlay::distanceBox(area, content);
    ASSERT_TRUE(clear && at_rest);
    EXPECT_NE(*clear, *at_rest) << "where it would stand the callout is";
    EXPECT_TRUE(area.contains(*clear));
    EXPECT_FALSE(clear->contains(content.distance->from));
}

TEST(SceneOverlayTest, InANarrowViewTheDistanceIsALineBelowTheBody) {
    Theme::install(*qApp);
    Theme::get().setScale(1);
    OverlayContent content = twoPeople();
    EXPECT_FALSE(SceneOverlay::distanceBox(QRectF(0, 0, 356, 260), content));
    const int with = painted(content, {356, 260});
    content.distance->text.clear();
    content.distance->pair.clear();
    EXPECT_GT(with, painted(content, {356, 260}) + 50);
}

TEST(SceneOverlayTest, AHalfOfTwoResultsSaysWhichOneItIs) {
    Theme::install(*qApp);
    Theme::get().setScale(1);
    OverlayContent content;
    content.has_axes = false;
    content.legends = {{"Result 1", false}};
    EXPECT_GT(painted(content, {200, 295}), 50) << "as wide as a half is at 1280 by 800";
}

TEST_F(SceneViewTest, BesideAnotherViewItSaysWhichResultItShows) {
    openTake();
    const auto* overlay = view_->findChild<SceneOverlay*>();
    EXPECT_TRUE(overlay->content().legends.empty());
    view_->setBesideOther(true);
    settle();
    ASSERT_EQ(overlay->content().legends.size(), 1u);
    EXPECT_EQ(overlay->content().legends.front().text, "Result 1");
}

TEST(SceneWordsTest, AnErrorThatRoundsToZeroIsLeftOut) {
    ComposedScene::Distance distance;
    distance.distance_m = 1.5;
    distance.sigma_m = 0.001;
    EXPECT_EQ(distanceInWords(distance), QString::fromUtf8("1.50\u00A0m"));
    distance.sigma_m = 0.01;
    EXPECT_EQ(distanceInWords(distance), QString::fromUtf8("1.50\u00A0m ±0.01"));
    distance.distance_m = 0.046;
    distance.sigma_m = 0.0004;
    EXPECT_FALSE(distanceInWords(distance).contains(QString::fromUtf8("±")));
    chooseUnits(Units::kImperial);
    const auto back = qScopeGuard([] { chooseUnits(Units::kMetric); });
    EXPECT_EQ(distanceInWords(distance), QString::fromUtf8("1.8″"));
    distance.distance_m = 1.5;
    distance.sigma_m = 0.01;
    EXPECT_EQ(distanceInWords(distance), QString::fromUtf8("4′11.1″ ±0.4″"));
}

class SceneFigure : public SceneViewTest {
protected:
    void SetUp() override {
        SceneViewTest::SetUp();
        if (!IsSkipped()) {
            view_->setFigure(actor_, suit_);
            settle();
        }
    }
    void followDrag(Vector3d& p_segment_m) {
        QObject::connect(
            view_.get(), &SceneView::placementDragged, view_.get(),
            [&p_segment_m](SuitPart, const Vector3d& p, const Quaterniond&) { p_segment_m = p; });
    }

    Suit suit_ = defaultSuit();
};

TEST_F(SceneFigure, ShowsTheRestPoseAndAPartIsChosenByAClick) {
    EXPECT_EQ(view_->descriptionInWords(), "Performer in the rest pose with 18 boards and 8 sources");
    QSignalSpy chosen(view_.get(), &SceneView::partChosen);
    const BodyPlaces places = placeBody(actor_.skeleton, actor_.restPose(), suit_, nullptr);
    QTest::mouseClick(canvas(), Qt::LeftButton, {}, onScreen(places.boards[3].p_m));
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(view_->chosenPart(), (SuitPart{SuitPart::Kind::kBoard, 3}));
    EXPECT_TRUE(view_->descriptionInWords().endsWith("Chosen: Head, board 4"))
        << view_->descriptionInWords().toStdString();
}

TEST_F(SceneFigure, ArrowKeysNudgeAlongThePicture) {
    view_->setView(CameraView::kFront);
    view_->setChosenPart({SuitPart::Kind::kBoard, 3});
    Vector3d p = Vector3d::Zero();
    followDrag(p);
    QTest::keyClick(view_.get(), Qt::Key_Right);
    EXPECT_TRUE(p.isApprox(suit_.boards[3].p_segment_board_m + Vector3d(0.001, 0, 0), 1e-6));
    QTest::keyClick(view_.get(), Qt::Key_Up, Qt::ShiftModifier);
    EXPECT_TRUE(p.isApprox(suit_.boards[3].p_segment_board_m + Vector3d(0.001, 0.01, 0), 1e-6));
}

TEST_F(SceneFigure, DraggingAnArrowMovesThePartAlongIt) {
    const SuitPart part{SuitPart::Kind::kBoard, 2};
    view_->setChosenPart(part);
    settle();
    const BodyPlaces places = placeBody(actor_.skeleton, actor_.restPose(), suit_, nullptr);
    const BoardPlace& board = places.boards[2];
    const double px_per_m = view_->camera().pixelsPerMetre(board.p_m, {view_->width(), view_->height()});
    const Vector3d along = board.q_world_board * Vector3d::UnitX();
    const Vector3d grip = board.p_m + 60 / px_per_m * along;
    const QPoint from = onScreen(grip), to = onScreen(grip + 0.05 * along);
    Vector3d p = suit_.boards[2].p_segment_board_m;
    followDrag(p);
    QSignalSpy ended(view_.get(), &SceneView::dragEnded);
    QTest::mousePress(canvas(), Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, to, canvas()->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(canvas(), &move);
    QTest::mouseRelease(canvas(), Qt::LeftButton, {}, to);
    const Vector3d moved = p - suit_.boards[2].p_segment_board_m;
    const Vector3d expected = 0.05 * (suit_.boards[2].q_segment_board * Vector3d::UnitX());
    EXPECT_LT((moved - expected).norm(), 0.004) << moved.transpose();
    EXPECT_EQ(ended.count(), 1);
}

}  // namespace
}  // namespace noctule::ui
