// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/timeline.h"

#include <QAccessible>
#include <QSignalSpy>

#include "tests/ui/plots/plots_fixture.h"
#include "ui/language/language.h"
#include "ui/plots/time_ruler.h"
#include "ui/plots/transport_bar.h"
#include "ui/widgets/name_field.h"

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
    TimeCursor& time() { return studio_->time(); }
    UndoHistory& undo() { return studio_->session().undoStack(); }
    /// "0.50 Marker 1", as the document knows them.
    QStringList markers() const {
        QStringList markers;
        for (const ReviewMarker& marker : studio_->take().overview()->markers)
            markers.append(
                QString("%1 %2").arg(marker.t_s, 0, 'f', 2).arg(QString::fromStdString(marker.label)));
        return markers;
    }
    bool become(const QStringList& wanted) {
        return waitFor([&] { return markers() == wanted && studio_->jobs().idle(); });
    }
    void setMarkers() {
        for (const double t_s : {0.5, 1.5}) {
            time().setTime(t_s);
            bar_->addMarker();
        }
        ASSERT_TRUE(become({"0.50 Marker 1", "1.50 Marker 2"})) << markers().join(", ").toStdString();
    }

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

/// "Anfang 0:00,00" is longer than "In 0:00.00": what fits is measured.
TEST_F(TimelineTest, TheBarBelowSaysAsMuchAsHasRoomInEveryLanguage) {
    for (const char* language : {"de", "en"}) {
        chooseLanguage(studio_->settings(), language);
        applyLanguage(studio_->settings());
        QWidget window;  // whose size the desktop has a say in; that of the bar it has not
        window.resize(1000, 100);
        window.show();
        TransportBar bar(*studio_, *timeline_, &window);
        bar.show();
        int most = 0;
        for (int width = 540; width <= 1000; width += 3) {
            bar.resize(width, bar.sizeHint().height());
            QCoreApplication::processEvents();
            int shown = 0;
            for (const QWidget* part : bar.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
                if (part->isVisible()) {
                    ++shown;
                    EXPECT_GE(part->width(), part->minimumSizeHint().width())
                        << width << " px: " << part->accessibleName().toStdString();
                }
            EXPECT_GE(shown, most) << width;
            most = shown;
        }
        EXPECT_EQ(most, 10) << "with the length and the label of the speed";
    }
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

TEST_F(TimelineTest, AMarkerIsInTheTakeAndGoneBackTo) {
    time().setTime(0.75);
    bar_->addMarker();
    ASSERT_TRUE(waitFor([this] {
        const auto overview = studio_->take().overview();
        return overview && !overview->markers.empty();
    }));
    const ReviewMarker marker = studio_->take().overview()->markers.front();
    EXPECT_EQ(marker.kind, "user");
    EXPECT_NEAR(marker.t_s, 0.75, 1e-5);
    time().setTime(1.5);
    timeline_->goToMarker(-1);
    EXPECT_NEAR(time().time(), 0.75, 1e-5);
    EXPECT_EQ(timeline_->chosenMarker(), 0);
    timeline_->goToMarker(1);  // there is no next one
    EXPECT_NEAR(time().time(), 0.75, 1e-5);
    time().setTime(0);
    timeline_->goToMarker(1);
    EXPECT_NEAR(time().time(), 0.75, 1e-5);
}

TEST_F(TimelineTest, MarkersAreNamedWhereTheyStand) {
    setMarkers();
    EXPECT_EQ(timeline_->chosenMarker(), 1) << "the one that was set last";
    QTest::mouseDClick(timeline_.get(), Qt::LeftButton, {}, timeline_->flagPoint(0.5));
    auto* field = timeline_->findChild<NameField*>();
    ASSERT_TRUE(field);
    EXPECT_EQ(field->text(), "Marker 1");
    QTest::keyClicks(field, "jump");
    QTest::keyClick(field, Qt::Key_Return);
    ASSERT_TRUE(become({"0.50 jump", "1.50 Marker 2"}));
    EXPECT_EQ(timeline_->chosenMarker(), 0);

    ASSERT_TRUE(waitFor([this] { return !timeline_->findChild<NameField*>(); }));
    QTest::keyClick(timeline_.get(), Qt::Key_F2);
    field = timeline_->findChild<NameField*>();
    ASSERT_TRUE(field);
    QTest::keyClicks(field, "something else");
    QTest::keyClick(field, Qt::Key_Escape);
    EXPECT_TRUE(become({"0.50 jump", "1.50 Marker 2"}));
    EXPECT_EQ(undo().undoText(), "Name the marker jump");
}

TEST_F(TimelineTest, MarkersAreDeletedAndAllOfItIsUndone) {
    setMarkers();
    timeline_->goToMarker(-1);
    QTest::keyClick(timeline_.get(), Qt::Key_Delete);
    ASSERT_TRUE(become({"1.50 Marker 2"}));
    EXPECT_FALSE(timeline_->canEditMarker()) << "none is chosen now";
    undo().undo();
    ASSERT_TRUE(become({"0.50 Marker 1", "1.50 Marker 2"}));
    EXPECT_EQ(timeline_->chosenMarker(), 0) << "it is back";
    for (int i = 0; i < 2; ++i)
        undo().undo();  // quickly: the file is written in order
    ASSERT_TRUE(become({}));
    EXPECT_FALSE(undo().canUndo());
    for (int i = 0; i < 3; ++i)
        undo().redo();
    EXPECT_TRUE(become({"1.50 Marker 2"}));
}

TEST_F(TimelineTest, AMarkerThatCannotBeWrittenIsToldAndLeavesTheStack) {
    setMarkers();
    std::filesystem::rename(path(), path() + ".away");
    QSignalSpy failed(studio_.get(), &Studio::failed);
    bar_->addMarker();
    ASSERT_TRUE(waitFor([&] { return failed.count() == 1; }));
    std::filesystem::rename(path() + ".away", path());
    EXPECT_EQ(undo().count(), 3);
    undo().undo();
    EXPECT_EQ(undo().count(), 2);
    undo().undo();
    EXPECT_TRUE(become({"0.50 Marker 1"}));
}

TEST_F(TimelineTest, AMarkerWhoseWayBackFailsCanBeUndoneLater) {
    setMarkers();
    QSignalSpy failed(studio_.get(), &Studio::failed);
    std::filesystem::rename(path(), path() + ".away");
    undo().undo();
    ASSERT_TRUE(waitFor([&] { return failed.count() == 1; }));
    std::filesystem::rename(path() + ".away", path());
    undo().redo();
    undo().undo();
    EXPECT_TRUE(become({"0.50 Marker 1"}));
    EXPECT_EQ(failed.count(), 1);
    EXPECT_EQ(undo().count(), 2);
}

TEST_F(TimelineTest, MarkersAreUndoneWhereTheirTakeIsNow) {
    setMarkers();
    const std::string now = path() + ".kick.noctule";
    std::filesystem::rename(path(), now);
    emit studio_->session().takeRenamed(QString::fromStdString(path()), QString::fromStdString(now));
    undo().undo();
    EXPECT_TRUE(become({"0.50 Marker 1"}));
    EXPECT_EQ(studio_->take().path().toStdString(), now);
}

TEST_F(TimelineTest, ANameGoesToTheMarkerThatItWasTypedFor) {
    setMarkers();
    timeline_->goToMarker(-1);
    timeline_->nameMarker();
    auto* field = timeline_->findChild<NameField*>();
    ASSERT_TRUE(field);
    QTest::keyClicks(field, "jump");
    studio_->markers().add(0.2);  // the take is read anew, with another one before it
    ASSERT_TRUE(become({"0.20 Marker 3", "0.50 Marker 1", "1.50 Marker 2"}));
    timeline_->goToMarker(1);
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_TRUE(become({"0.20 Marker 3", "0.50 jump", "1.50 Marker 2"}))
        << markers().join(", ").toStdString();
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
