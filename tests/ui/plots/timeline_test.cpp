// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/timeline.h"

#include <QAccessible>

#include "tests/ui/plots/plots_fixture.h"
#include "ui/plots/time_ruler.h"
#include "ui/plots/transport_bar.h"

namespace noctule::ui {
namespace {

class TimelineTest : public test::PlotsFixture {
protected:
    void SetUp() override {
        PlotsFixture::SetUp();
        window_ = std::make_unique<TimeWindow>(studio_->time());
        timeline_ = std::make_unique<Timeline>(*studio_, *window_);
        bar_ = std::make_unique<TransportBar>(*studio_, *timeline_);
        show(*timeline_, 800, timeline_->sizeHint().height());
        ASSERT_TRUE(open());
    }
    void TearDown() override {
        bar_.reset();
        timeline_.reset();
        window_.reset();
        PlotsFixture::TearDown();
    }
    void drag(const QPoint& from, const QPoint& to) {
        QTest::mousePress(timeline_.get(), Qt::LeftButton, {}, from);
        QMouseEvent move(QEvent::MouseMove, to, timeline_->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(timeline_.get(), &move);
        QTest::mouseRelease(timeline_.get(), Qt::LeftButton, {}, to);
    }
    bool key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        const QKeyEvent event(QEvent::KeyPress, key, modifiers);
        return bar_->handleKey(event);
    }
    TimeCursor& time() { return studio_->time(); }

    static constexpr double kPixel_s = 2.0 / 700;
    std::unique_ptr<TimeWindow> window_;
    std::unique_ptr<Timeline> timeline_;
    std::unique_ptr<TransportBar> bar_;
};

TEST_F(TimelineTest, AClickAndADragMoveTheCursor) {
    QTest::mouseClick(timeline_.get(), Qt::LeftButton, {}, timeline_->rulerPoint(0.5));
    EXPECT_NEAR(time().time(), 0.5, kPixel_s);
    drag(timeline_->rulerPoint(0.5), timeline_->rulerPoint(1.25));
    EXPECT_NEAR(time().time(), 1.25, kPixel_s);
    EXPECT_DOUBLE_EQ(time().in(), 0);
}

TEST_F(TimelineTest, GripsMoveInAndOutAndNotTheCursor) {
    drag(timeline_->inGrip(), timeline_->rulerPoint(0.4));
    EXPECT_NEAR(time().in(), 0.4, kPixel_s);
    drag(timeline_->outGrip(), timeline_->rulerPoint(1.6));
    EXPECT_NEAR(time().out(), 1.6, kPixel_s);
    drag(timeline_->inGrip(), timeline_->rulerPoint(1.9));  // not past out
    EXPECT_DOUBLE_EQ(time().in(), time().out());
    EXPECT_DOUBLE_EQ(time().time(), 0);
}

TEST_F(TimelineTest, APressOnAGripAloneMovesNothing) {
    time().setRange(0.5, 1.5);
    QTest::mouseClick(timeline_.get(), Qt::LeftButton, {}, timeline_->inGrip() + QPoint(2, 0));
    EXPECT_DOUBLE_EQ(time().in(), 0.5);
}

TEST_F(TimelineTest, KeysStepFramesAndSeconds) {
    time().setTime(0.5);
    QTest::keyClick(timeline_.get(), Qt::Key_Right);
    EXPECT_NEAR(time().time(), 0.5 + time().frameStep(), time().frameStep());
    EXPECT_GT(time().time(), 0.5);
    time().setTime(0.5);
    QTest::keyClick(timeline_.get(), Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_DOUBLE_EQ(time().time(), 1.5);
    time().setRange(0.25, 1.75);
    QTest::keyClick(timeline_.get(), Qt::Key_Home);
    EXPECT_DOUBLE_EQ(time().time(), 0.25);
    QTest::keyClick(timeline_.get(), Qt::Key_End);
    EXPECT_DOUBLE_EQ(time().time(), 1.75);
}

TEST_F(TimelineTest, IsASliderToScreenReaders) {
    QAccessibleInterface* slider = QAccessible::queryAccessibleInterface(timeline_.get());
    ASSERT_NE(slider, nullptr);
    EXPECT_EQ(slider->role(), QAccessible::Slider);
    ASSERT_NE(slider->valueInterface(), nullptr);
    slider->valueInterface()->setCurrentValue(1.25);
    EXPECT_DOUBLE_EQ(time().time(), 1.25);
    EXPECT_DOUBLE_EQ(slider->valueInterface()->maximumValue().toDouble(), 2);
    EXPECT_EQ(slider->text(QAccessible::Value), "0:01.25 of 0:02.00");
}

TEST_F(TimelineTest, MIsAMarkerInTheTakeAndCommaGoesBackToIt) {
    time().setTime(0.75);
    ASSERT_TRUE(key(Qt::Key_M));
    ASSERT_TRUE(waitFor([this] {
        const auto overview = studio_->take().overview();
        return overview && !overview->markers.empty();
    }));
    const ReviewMarker marker = studio_->take().overview()->markers.front();
    EXPECT_EQ(marker.kind, "user");
    EXPECT_NEAR(marker.t_s, 0.75, 1e-5);
    time().setTime(1.5);
    EXPECT_TRUE(key(Qt::Key_Comma));
    EXPECT_NEAR(time().time(), 0.75, 1e-5);
    EXPECT_EQ(timeline_->chosenMarker(), 0);
    EXPECT_TRUE(key(Qt::Key_Period));  // there is no next one
    EXPECT_NEAR(time().time(), 0.75, 1e-5);
    time().setTime(0);
    EXPECT_TRUE(key(Qt::Key_Period));
    EXPECT_NEAR(time().time(), 0.75, 1e-5);
}

TEST_F(TimelineTest, KeysOfThePage) {
    EXPECT_TRUE(key(Qt::Key_Space));
    EXPECT_TRUE(time().isPlaying());
    EXPECT_TRUE(key(Qt::Key_Space));
    EXPECT_FALSE(time().isPlaying());
    time().setTime(0.5);
    EXPECT_TRUE(key(Qt::Key_I, Qt::ControlModifier));
    EXPECT_DOUBLE_EQ(time().in(), 0.5);
    time().setTime(1.5);
    EXPECT_TRUE(key(Qt::Key_O, Qt::ControlModifier));
    EXPECT_DOUBLE_EQ(time().out(), 1.5);
    const bool looped = time().loops();
    EXPECT_TRUE(key(Qt::Key_L, Qt::ControlModifier));
    EXPECT_NE(time().loops(), looped);
    EXPECT_FALSE(key(Qt::Key_Q));
}

TEST_F(TimelineTest, ThePlayingCursorTurnsPages) {
    window_->show(0, 0.5);
    time().setTime(0.45);
    time().play();
    EXPECT_TRUE(waitFor([this] { return window_->from() > 0.3; }));
    time().pause();
    EXPECT_LE(window_->from(), time().time());
    EXPECT_NEAR(window_->span(), 0.5, 1e-9);
}

TEST(TimeWindowTest, StaysWithinTheTakeAndAboveItsShortest) {
    TimeCursor cursor;
    TimeWindow window(cursor);
    cursor.setExtent(10, 0.01);
    EXPECT_TRUE(window.showsAll());
    window.zoom(4, 10);
    EXPECT_DOUBLE_EQ(window.to(), 10);
    EXPECT_DOUBLE_EQ(window.span(), 2.5);
    window.pan(100);
    EXPECT_DOUBLE_EQ(window.to(), 10);
    window.pan(-100);
    EXPECT_DOUBLE_EQ(window.from(), 0);
    window.zoom(1e9, 1);
    EXPECT_DOUBLE_EQ(window.span(), TimeWindow::kShortest_s);
    window.zoom(1e-9, 1);
    EXPECT_TRUE(window.showsAll());
    window.show(2, 4);
    EXPECT_DOUBLE_EQ(window.timeAt(window.xOf(3.3, 777), 777), 3.3);
}

TEST(RulerScale, StepsAreRoundAndLabelsDoNotTouch) {
    for (const double span_s : {0.002, 0.013, 0.4, 3.0, 36.0, 600.0, 7200.0}) {
        const RulerScale scale = rulerScale(1, 1 + span_s, 800, 72);
        ASSERT_FALSE(scale.t_s.empty()) << span_s;
        EXPECT_GE(scale.step_s / span_s * 800, 72 * (1 - 1e-6)) << span_s;
        EXPECT_LE(scale.step_s / span_s * 800, 72 * 2.6) << span_s;
    }
    EXPECT_DOUBLE_EQ(rulerScale(0, 36, 800, 72).step_s, 4);
    EXPECT_EQ(rulerScale(0, 36, 800, 72).decimals, 0);
    EXPECT_EQ(rulerScale(0, 0.4, 800, 72).decimals, 2);
}

}  // namespace
}  // namespace noctule::ui
