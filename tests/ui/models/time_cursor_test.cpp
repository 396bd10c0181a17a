// SPDX-License-Identifier: Apache-2.0
#include "ui/models/time_cursor.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "ui/models/selection.h"

namespace noctule::ui {
namespace {

class TimeCursorTest : public testing::Test {
protected:
    void SetUp() override { cursor_.setExtent(10, 0.01); }
    TimeCursor cursor_;
};

TEST_F(TimeCursorTest, ExtentPutsEverythingAtItsEnds) {
    cursor_.setTime(5);
    cursor_.setRange(2, 3);
    QSignalSpy extent(&cursor_, &TimeCursor::extentChanged);
    cursor_.setExtent(4, 0.02);
    EXPECT_EQ(extent.count(), 1);
    EXPECT_EQ(cursor_.time(), 0);
    EXPECT_EQ(cursor_.in(), 0);
    EXPECT_EQ(cursor_.out(), 4);
    EXPECT_EQ(cursor_.frameStep(), 0.02);
    cursor_.setExtent(std::nan(""), -1);
    EXPECT_EQ(cursor_.duration(), 0);
    EXPECT_EQ(cursor_.frameStep(), 0.02);
    cursor_.play();
    EXPECT_FALSE(cursor_.isPlaying());
}

TEST_F(TimeCursorTest, TimesAndRangesAreClamped) {
    QSignalSpy time(&cursor_, &TimeCursor::timeChanged);
    cursor_.setTime(11);
    EXPECT_EQ(cursor_.time(), 10);
    cursor_.setTime(10);
    cursor_.setTime(std::nan(""));
    EXPECT_EQ(time.count(), 1);
    cursor_.setRange(8, -1);  // the wrong way round
    EXPECT_EQ(cursor_.in(), 0);
    EXPECT_EQ(cursor_.out(), 8);
    cursor_.setSpeed(100);
    EXPECT_EQ(cursor_.speed(), 4);
    cursor_.setSpeed(-0.01);
    EXPECT_EQ(cursor_.speed(), -0.1);
}

TEST_F(TimeCursorTest, StepsSnapToFrames) {
    cursor_.setFrames(0.005, 0.01);
    cursor_.setTime(1.007);
    cursor_.stepFrames(1);
    EXPECT_NEAR(cursor_.time(), 1.015, 1e-12);
    cursor_.stepFrames(1);
    EXPECT_NEAR(cursor_.time(), 1.025, 1e-12);
    cursor_.stepFrames(-1);
    EXPECT_NEAR(cursor_.time(), 1.015, 1e-12);
    cursor_.setTime(1.017);
    cursor_.stepFrames(-1);
    EXPECT_NEAR(cursor_.time(), 1.015, 1e-12);
    cursor_.stepFrames(10);
    EXPECT_NEAR(cursor_.time(), 1.115, 1e-12);
    cursor_.stepSeconds(-5);
    EXPECT_EQ(cursor_.time(), 0);
}

/// The cursor reads its clock after the slot of the tick before and before that of its own. However late
/// either is, its time lies between what clocks of the test say there.
TEST_F(TimeCursorTest, PlaysAtTheSpeedOfTheClock) {
    constexpr double kSpeed = 2, kNs = 1e-9;
    constexpr int kTicks = 12;
    QElapsedTimer since_before_play, since_after_play;
    qint64 tick_before_ns = 0;
    int ticks = 0;
    cursor_.setExtent(1e6, 0.01);
    cursor_.setSpeed(kSpeed);
    QObject::connect(&cursor_, &TimeCursor::timeChanged, &cursor_, [&](double t_s) {
        EXPECT_LE(t_s, kSpeed * kNs * static_cast<double>(since_before_play.nsecsElapsed()));
        EXPECT_GE(t_s, kSpeed * kNs * static_cast<double>(tick_before_ns));
        tick_before_ns = since_after_play.nsecsElapsed();
        ++ticks;
    });
    since_before_play.start();
    cursor_.play();
    since_after_play.start();
    ASSERT_TRUE(QTest::qWaitFor([&] { return ticks >= kTicks; }, 240'000));
    EXPECT_GE(since_before_play.elapsed(), ticks * 14) << "60 Hz at most, and what a timer may be early";
    cursor_.pause();
    const double paused_at = cursor_.time();
    QTest::qWait(50);
    EXPECT_EQ(cursor_.time(), paused_at);
}

TEST_F(TimeCursorTest, StopsAtOutAndStartsAgainAtIn) {
    QSignalSpy playing(&cursor_, &TimeCursor::playingChanged);
    cursor_.setRange(1, 1.1);
    cursor_.setTime(5);
    cursor_.play();
    EXPECT_EQ(cursor_.time(), 1);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !cursor_.isPlaying(); }, 240'000));
    EXPECT_EQ(cursor_.time(), 1.1);
    EXPECT_EQ(playing.count(), 2);
    cursor_.toggle();
    EXPECT_EQ(cursor_.time(), 1);
    cursor_.toggle();
    EXPECT_FALSE(cursor_.isPlaying());
}

TEST_F(TimeCursorTest, LoopsWithinInAndOutAlsoBackwards) {
    for (const double speed : {4.0, -4.0}) {
        cursor_.setRange(2, 2.3);
        cursor_.setTime(2.1);
        cursor_.setSpeed(speed);
        cursor_.setLoop(true);
        int wraps = 0;
        double last_s = cursor_.time();
        const auto watch = QObject::connect(&cursor_, &TimeCursor::timeChanged, [&](double t_s) {
            EXPECT_GE(t_s, 2);
            EXPECT_LE(t_s, 2.3);
            wraps += (t_s - last_s) * speed < 0;
            last_s = t_s;
        });
        cursor_.play();
        EXPECT_TRUE(QTest::qWaitFor([&] { return wraps >= 2; }, 240'000));
        cursor_.pause();
        QObject::disconnect(watch);
    }
}

TEST(SelectionTest, TellsOnceAndOnlyChanges) {
    Selection selection;
    QSignalSpy pair(&selection, &Selection::pairChanged), joint(&selection, &Selection::jointChanged);
    selection.setPair(-1, -1);
    EXPECT_EQ(pair.count(), 0);
    selection.setPair(4, 13);
    selection.setPair(4, 13);
    EXPECT_EQ(pair.count(), 1);
    selection.setBoard(2);
    EXPECT_EQ(pair.count(), 2);
    EXPECT_EQ(selection.source(), 4);
    EXPECT_EQ(selection.board(), 2);
    selection.setJoint("LeftLeg");
    selection.setJoint("LeftLeg");
    EXPECT_EQ(joint.count(), 1);
}

}  // namespace
}  // namespace noctule::ui
