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

}  // namespace
}  // namespace noctule::ui
