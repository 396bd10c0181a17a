// SPDX-License-Identifier: Apache-2.0
// In and out that are set by a key or a button: each is a step, at once.
#include "ui/views/review/take_range.h"

#include <QSignalSpy>

#include "tests/ui/views/reviewed_session.h"
#include "ui/plots/time_window.h"
#include "ui/plots/timeline.h"
#include "ui/plots/transport_bar.h"

namespace noctule::ui {
namespace {

using TakeRangeTest = test::ReviewedSession;

TEST_F(TakeRangeTest, SetByACommandTheyAreTakenBackOneByOne) {
    const TakeRange range(*studio_);
    TimeWindow window(studio_->time());
    Timeline timeline(*studio_, window);
    TransportBar bar(*studio_, timeline);
    openTake("swing_001");
    QSignalSpy said(studio_.get(), &Studio::said);
    TimeCursor& time = studio_->time();
    UndoHistory& undo = studio_->session().undoStack();
    time.setTime(0.5);
    bar.setIn();
    time.setTime(1.5);
    bar.setOut();
    ASSERT_EQ(undo.count(), 2) << "no waiting: Undo takes back what was done last";
    ASSERT_EQ(said.count(), 2);
    EXPECT_TRUE(said[1][0].toString().startsWith("In is at 0:00")) << said[1][0].toString().toStdString();
    undo.undo();
    EXPECT_NEAR(time.in(), 0.5, 1e-9);
    EXPECT_NEAR(time.out(), time.duration(), 1e-9);
    undo.undo();
    EXPECT_NEAR(time.in(), 0, 1e-9);
}

TEST_F(TakeRangeTest, ASecondPressIsAStepOfItsOwn) {
    const TakeRange range(*studio_);
    TimeWindow window(studio_->time());
    Timeline timeline(*studio_, window);
    TransportBar bar(*studio_, timeline);
    openTake("swing_001");
    TimeCursor& time = studio_->time();
    UndoHistory& undo = studio_->session().undoStack();
    for (const double in_s : {0.5, 0.8}) {
        time.setTime(in_s);
        bar.setIn();
    }
    ASSERT_EQ(undo.count(), 2);
    undo.undo();
    EXPECT_NEAR(time.in(), 0.5, 1e-9);
    undo.undo();
    EXPECT_NEAR(time.in(), 0, 1e-9);
}

TEST_F(TakeRangeTest, ADragBeforeAPressIsTakenBackByItself) {
    const TakeRange range(*studio_);
    TimeWindow window(studio_->time());
    Timeline timeline(*studio_, window);
    TransportBar bar(*studio_, timeline);
    openTake("swing_001");
    TimeCursor& time = studio_->time();
    UndoHistory& undo = studio_->session().undoStack();
    time.setRange(0.3, time.out());  // dragged, and not written yet
    ASSERT_EQ(undo.count(), 0);
    time.setTime(0.6);
    bar.setIn();
    ASSERT_EQ(undo.count(), 2);
    undo.undo();
    EXPECT_NEAR(time.in(), 0.3, 1e-9);
    undo.undo();
    EXPECT_NEAR(time.in(), 0, 1e-9);
}

}  // namespace
}  // namespace noctule::ui
