// SPDX-License-Identifier: Apache-2.0
#include "ui/plots/plot_panel.h"

#include <QScreen>
#include <QWheelEvent>

#include "tests/ui/plots/plots_fixture.h"

namespace noctule::ui {
namespace {

class PlotPanelTest : public test::PlotsFixture {
protected:
    void SetUp() override {
        PlotsFixture::SetUp();
        panel_ = std::make_unique<PlotPanel>(*studio_);
        show(*panel_, 700, 400);
    }
    void TearDown() override {
        panel_.reset();
        PlotsFixture::TearDown();
    }

    void openPair() {
        studio_->selection().setPair(0, 0);
        studio_->selection().setJoint("RightArm");
        ASSERT_TRUE(open());
    }
    void onlyTab(PlotTab only) {
        panel_->setOn(only, true);
        for (int tab = 0; tab < kPlotTabs; ++tab)
            panel_->setOn(static_cast<PlotTab>(tab), static_cast<PlotTab>(tab) == only);
    }
    bool waitForCurves(size_t lanes, size_t curves_of_first) {
        return waitFor([this, lanes, curves_of_first] {
            return panel_->lanes().size() == lanes &&
                   panel_->lanes()[0]->content().curves.size() == curves_of_first;
        });
    }
    LaneStack& stack() { return *static_cast<LaneStack*>(panel_->lanes()[0]->parentWidget()); }
    QPoint at(double t_s) {
        const auto [left, right] = stack().timeExtent();
        return {left + qRound(panel_->window().xOf(t_s, right - left)), 40};
    }
    /// Columns of the panel with the cursor's colour in the lowest rows of the first lane, where no words
    /// are: what the X server shows, not what a repaint would bring.
    std::vector<int> cursorsOnScreen() {
        constexpr int kRows = 3;
        const QImage shown = QGuiApplication::primaryScreen()->grabWindow(panel_->winId()).toImage();
        const PlotLane& lane = *panel_->lanes()[0];
        const int end = lane.mapTo(panel_.get(), QPoint(0, lane.height())).y();
        std::vector<int> columns;
        for (int x = 0; x < shown.width(); ++x)
            for (int y = end - kRows; y < end; ++y)
                if (shown.pixelColor(x, y) == Theme::get().tokens().t1) {
                    columns.push_back(x);
                    break;
                }
        return columns;
    }
    double secondsPerPixel() {
        const auto [left, right] = stack().timeExtent();
        return panel_->window().span() / (right - left);
    }
    void wheel(double t_s, int notches, Qt::KeyboardModifiers modifiers = {}) {
        const QPoint position = at(t_s);
        QWheelEvent event(position, stack().mapToGlobal(position), {}, {0, 120 * notches}, Qt::NoButton,
                          modifiers, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&stack(), &event);
    }
    void moveMouse(const QPoint& to, Qt::KeyboardModifiers modifiers) {
        QMouseEvent move(QEvent::MouseMove, to, stack().mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                         modifiers);
        QApplication::sendEvent(&stack(), &move);
    }
    std::unique_ptr<PlotPanel> panel_;
};

TEST_F(PlotPanelTest, ShowsConfidenceOfTheChosenPair) {
    openPair();
    onlyTab(PlotTab::kConfidence);
    ASSERT_TRUE(waitForCurves(1, 1));
    const LaneContent& lane = panel_->lanes()[0]->content();
    EXPECT_EQ(lane.curves[0].value->size(), static_cast<size_t>(noctule::test::kPulses));
    EXPECT_EQ(lane.curves[0].legend, "source 1 (chest) to right forearm");
    panel_->channels().setPair({0, 1}, true);
    EXPECT_TRUE(waitForCurves(1, 2));
    EXPECT_NE(panel_->lanes()[0]->content().curves[1].pen, LanePen::kFirst);
}

TEST_F(PlotPanelTest, NoLaneIsCutInItsTitle) {
    constexpr int kFreeBelow = 8;  // rows below a curve are empty
    openPair();
    onlyTab(PlotTab::kJointAngles);
    panel_->setOn(PlotTab::kRoot, true);
    panel_->setOn(PlotTab::kRanges, true);
    ASSERT_TRUE(waitFor([this] { return panel_->lanes().size() >= 6; }));
    for (const int height : {300, 331, 360, 401}) {
        panel_->resize(700, height);
        QTest::qWait(30);
        const int seen = stack().parentWidget()->height();
        for (const PlotLane* lane : panel_->lanes())
            EXPECT_TRUE(lane->y() >= seen || lane->geometry().bottom() < seen + kFreeBelow)
                << "a lane from " << lane->y() << " to " << lane->geometry().bottom() << " of " << seen;
    }
}

TEST_F(PlotPanelTest, TheCursorRunsThroughNoTitle) {
    openPair();
    onlyTab(PlotTab::kConfidence);
    ASSERT_TRUE(waitForCurves(1, 1));
    studio_->time().setTime(1);
    QTest::qWait(60);
    const QImage shown = stack().grab().toImage();
    const int x = at(1).x(), title = Theme::get().px(PlotLane::kTitleRow);
    const auto is_cursor = [&](int y) { return shown.pixelColor(x, y) == Theme::get().tokens().t1; };
    for (int y = 0; y < title; ++y)
        EXPECT_FALSE(is_cursor(y)) << y;
    EXPECT_TRUE(is_cursor(stack().height() - 2));
}

TEST_F(PlotPanelTest, RangesCarryTheirDecisions) {
    openPair();
    onlyTab(PlotTab::kRanges);
    ASSERT_TRUE(waitForCurves(2, 1));
    const LaneCurve& curve = panel_->lanes()[0]->content().curves[0];
    ASSERT_TRUE(curve.fate);
    EXPECT_EQ(curve.fate->size(), curve.value->size());
    EXPECT_EQ((*curve.fate)[0], RangeFate::kUsed);
    EXPECT_EQ((*curve.fate)[2], RangeFate::kGated);
    const auto [low, high] = panel_->lanes()[0]->valueRange();
    EXPECT_LE(low, 0.5);
    EXPECT_GE(high, 0.5);
}

TEST_F(PlotPanelTest, AnglesComeWithTheReference) {
    openPair();
    onlyTab(PlotTab::kJointAngles);
    ASSERT_TRUE(waitForCurves(3, 2));  // the shoulder turns about three axes
    EXPECT_EQ(panel_->lanes()[0]->content().curves[1].pen, LanePen::kReference);
    studio_->time().setTime(1);
    EXPECT_TRUE(waitFor([this] { return panel_->lanes()[0]->readout().contains("ref"); }))
        << panel_->lanes()[0]->readout().toStdString();
}

TEST_F(PlotPanelTest, InertialLanesMarkWhatWasLostAndClipped) {
    openPair();
    studio_->selection().setPair(0, 1);
    onlyTab(PlotTab::kInertial);
    ASSERT_TRUE(waitForCurves(2, 3));
    const auto& marks = panel_->lanes()[0]->content().marks;
    ASSERT_EQ(marks.size(), 2u);
    EXPECT_EQ(marks[0].kind, LaneMarks::Kind::kLost);
    EXPECT_GE(marks[0].t_s.size(), 60u);  // every fourth frame
}

TEST_F(PlotPanelTest, RootHasItsOwnLanes) {
    openPair();
    onlyTab(PlotTab::kRoot);
    ASSERT_TRUE(waitForCurves(4, 2));
    EXPECT_TRUE(panel_->lanes()[0]->content().title.startsWith("Root"));
}

TEST_F(PlotPanelTest, TakesWithoutSoundSaySo) {
    openPair();
    onlyTab(PlotTab::kRawSound);
    ASSERT_TRUE(waitForCurves(1, 0));
    EXPECT_TRUE(panel_->lanes()[0]->content().empty.contains("not the sound"));
}

TEST_F(PlotPanelTest, ReadoutFollowsTheCursor) {
    openPair();
    onlyTab(PlotTab::kConfidence);
    ASSERT_TRUE(waitForCurves(1, 1));
    studio_->time().setTime(0.001);
    EXPECT_TRUE(waitFor([this] { return panel_->lanes()[0]->readout() == "0.25"; }));
    studio_->time().setTime(4 * 0.008 + 0.001);  // the fifth pulse was not heard
    EXPECT_TRUE(waitFor([this] { return panel_->lanes()[0]->readout() == "0.00"; }));
}

TEST_F(PlotPanelTest, TheCursorIsOneLineThroughAllLanes) {
    openPair();
    panel_->setOn(PlotTab::kJointAngles, true);
    panel_->setOn(PlotTab::kConfidence, true);
    ASSERT_TRUE(waitFor([this] { return panel_->lanes().size() == 4; }));
    studio_->time().setTime(1);
    QTest::qWait(100);
    const QImage picture = stack().grab().toImage();
    const int x = at(1).x();
    const QColor line = Theme::get().tokens().t1;
    for (const PlotLane* lane : panel_->lanes()) {
        const int below_title = lane->y() + Theme::get().px(PlotLane::kTitleRow);
        EXPECT_EQ(picture.pixelColor(x, below_title + 1), line) << lane->y();  // where no dot lies on it
        EXPECT_EQ(lane->canvas().left(), panel_->lanes()[0]->canvas().left());
    }
}

TEST_F(PlotPanelTest, AfterPlayingAndAClickElsewhereThereIsOneCursor) {
    openPair();
    onlyTab(PlotTab::kJointAngles);
    ASSERT_TRUE(waitForCurves(3, 2));
    for (const double t_s : {0.3, 1.7, 0.9}) {
        studio_->time().play();
        QTest::qWait(250);
        studio_->time().pause();
        QTest::mouseClick(&stack(), Qt::LeftButton, {}, at(t_s));
        const int clicked = stack().mapTo(panel_.get(), at(t_s)).x();
        EXPECT_TRUE(waitFor([&] { return cursorsOnScreen() == std::vector{clicked}; }))
            << t_s << " s: " << testing::PrintToString(cursorsOnScreen()) << ", clicked at " << clicked;
    }
}

TEST_F(PlotPanelTest, DraggingMovesTheCursor) {
    openPair();
    ASSERT_TRUE(waitFor([this] { return !panel_->lanes().empty(); }));
    QTest::mousePress(&stack(), Qt::LeftButton, {}, at(0.5));
    EXPECT_NEAR(studio_->time().time(), 0.5, secondsPerPixel());
    moveMouse(at(1.5), {});
    EXPECT_NEAR(studio_->time().time(), 1.5, secondsPerPixel());
    QTest::mouseRelease(&stack(), Qt::LeftButton, {}, at(1.5));
}

TEST_F(PlotPanelTest, TheWheelZoomsAtThePointerAndADoubleClickShowsAll) {
    openPair();
    ASSERT_TRUE(waitFor([this] { return !panel_->lanes().empty(); }));
    TimeWindow& window = panel_->window();
    const QPoint before = at(1.5);
    wheel(1.5, 4);
    EXPECT_LT(window.span(), 1);
    EXPECT_LE(std::abs(at(1.5).x() - before.x()), 2);
    const double from_s = window.from();
    wheel(1.5, 1, Qt::ShiftModifier);
    EXPECT_LT(window.from(), from_s);
    QTest::mouseDClick(&stack(), Qt::LeftButton, {}, at(1.5));
    EXPECT_TRUE(window.showsAll());
}

TEST_F(PlotPanelTest, ShiftAndDragPans) {
    openPair();
    ASSERT_TRUE(waitFor([this] { return !panel_->lanes().empty(); }));
    TimeWindow& window = panel_->window();
    window.show(0.5, 1.0);
    const double held_s = 0.8;
    const QPoint from = at(held_s), to = from - QPoint(60, 0);
    QTest::mousePress(&stack(), Qt::LeftButton, Qt::ShiftModifier, from);
    moveMouse(to, Qt::ShiftModifier);
    QTest::mouseRelease(&stack(), Qt::LeftButton, Qt::ShiftModifier, to);
    EXPECT_NEAR(at(held_s).x(), to.x(), 2);
    EXPECT_DOUBLE_EQ(studio_->time().time(), 0);
}

TEST_F(PlotPanelTest, KeysZoomAndPan) {
    openPair();
    ASSERT_TRUE(waitFor([this] { return !panel_->lanes().empty(); }));
    TimeWindow& window = panel_->window();
    studio_->time().setTime(1);
    QTest::keyClick(&stack(), Qt::Key_Plus);
    QTest::keyClick(&stack(), Qt::Key_Plus);
    EXPECT_NEAR(window.span(), 2 / 1.25 / 1.25, 1e-9);
    const double from_s = window.from();
    QTest::keyClick(&stack(), Qt::Key_Right, Qt::ControlModifier);
    EXPECT_GT(window.from(), from_s);
    QTest::keyClick(&stack(), Qt::Key_Minus);
    QTest::keyClick(&stack(), Qt::Key_0, Qt::ControlModifier);
    EXPECT_TRUE(window.showsAll());
    QTest::keyClick(&stack(), Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_DOUBLE_EQ(studio_->time().time(), 2);
}

TEST_F(PlotPanelTest, CsvHoldsWhatIsShown) {
    openPair();
    onlyTab(PlotTab::kConfidence);
    ASSERT_TRUE(waitForCurves(1, 1));
    panel_->window().show(0, 0.0401);
    const QStringList rows = QString::fromStdString(panel_->csv()).split('\n', Qt::SkipEmptyParts);
    ASSERT_EQ(rows.size(), 7);  // pulses at 0, 8, .. 40 ms
    EXPECT_EQ(rows[0], "time_s,confidence of source 1 (chest) to right forearm");
    EXPECT_EQ(rows[1], "0.000000,0.25");
    EXPECT_EQ(rows[5], "0.032000,0");
}

TEST_F(PlotPanelTest, ThePictureHoldsLanesAndRuler) {
    openPair();
    ASSERT_TRUE(waitFor([this] { return !panel_->lanes().empty(); }));
    const QImage picture = panel_->picture();
    EXPECT_GT(picture.height(), stack().height());
    const QColor back = Theme::get().tokens().panel;
    int inked = 0;
    for (int x = 0; x < picture.width(); ++x)
        for (int y = stack().height() + 8; y < picture.height(); ++y)
            inked += picture.pixelColor(x, y) != back;
    EXPECT_GT(inked, 20);  // times of the ruler
}

TEST_F(PlotPanelTest, RemembersWhichTabsAreOn) {
    onlyTab(PlotTab::kRoot);
    const PlotPanel again(*studio_);
    EXPECT_TRUE(again.isOn(PlotTab::kRoot));
    EXPECT_FALSE(again.isOn(PlotTab::kConfidence));
}

TEST_F(PlotPanelTest, LanesKeepTheirLeastHeight) {
    openPair();
    for (int tab = 0; tab < kPlotTabs; ++tab)
        panel_->setOn(static_cast<PlotTab>(tab), true);
    panel_->resize(700, 300);
    ASSERT_TRUE(waitFor([this] { return panel_->lanes().size() >= 10; }));
    QTest::qWait(50);
    for (const PlotLane* lane : panel_->lanes())
        EXPECT_GE(lane->height(), Theme::get().px(PlotLane::kLeastHeight));
    const auto [left, right] = stack().timeExtent();
    EXPECT_EQ(right, panel_->width() - Theme::get().px(PlotPanel::kRightExtent));
}

TEST_F(PlotPanelTest, TheAxisOfConfidenceSaysItsNumbersAlikeAtAnyHeight) {
    openPair();
    onlyTab(PlotTab::kConfidence);
    ASSERT_TRUE(waitForCurves(1, 1));
    PlotLane& lane = *panel_->lanes()[0];
    for (const int height : {PlotLane::kLeastHeight, 400}) {
        lane.resize(lane.width(), Theme::get().px(height));
        EXPECT_EQ(lane.tickText(0), "0.0") << height;
        EXPECT_EQ(lane.tickText(1), "1.0") << height;
    }
}

}  // namespace
}  // namespace noctule::ui
