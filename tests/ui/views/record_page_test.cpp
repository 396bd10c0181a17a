// SPDX-License-Identifier: Apache-2.0
// The Record page against a box that plays the tiny take over TCP: two boards, two sources.
#include "ui/views/record/record_page.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>

#include "core/session/shot_list.h"
#include "tests/ui/views/record_fixture.h"
#include "ui/models/countdown_setting.h"
#include "ui/models/voice.h"
#include "ui/plots/level_meters.h"
#include "ui/plots/pairs_heard.h"
#include "ui/style/words.h"
#include "ui/views/readiness_words.h"
#include "ui/views/record/levels_panel.h"
#include "ui/views/record/mark_list.h"
#include "ui/views/record/no_suit.h"
#include "ui/views/record/record_problems.h"
#include "ui/views/record/record_readiness.h"
#include "ui/views/record/record_sidebar.h"
#include "ui/views/record/shot_list.h"
#include "ui/views/record/shot_list_dialog.h"
#include "ui/views/record/take_clock.h"
#include "ui/views/take_list.h"
#include "ui/widgets/button.h"
#include "ui/widgets/problem_card.h"
#include "ui/widgets/record_button.h"
#include "ui/widgets/section_header.h"

namespace noctule::ui {
namespace {

using noctule::test::TestBox;
using State = RecordRun::State;
using RecordPageTest = test::RecordFixture;

/// No constant: its take is one of another file, which may not be there yet.
TestBox::Options looping() {
    return {.loops = true};
}

TEST_F(RecordPageTest, WithoutASuitItSaysSoAndShowsTheWays) {
    EXPECT_EQ(run().state(), State::kNoSuit);
    EXPECT_FALSE(page_->showsSuit());
    QSignalSpy steps(studio_.get(), &Studio::stepRequested);
    QTest::mouseClick(page_->noSuit().connectButton(), Qt::LeftButton);
    ASSERT_EQ(steps.count(), 1);
    EXPECT_EQ(steps[0][0].value<Step>(), Step::kConnect);
    EXPECT_FALSE(page_->noSuit().virtualSuitButton()->isEnabled()) << "its program is not there";
    key(Qt::Key_Space);
    EXPECT_EQ(run().state(), State::kNoSuit);
}

TEST_F(RecordPageTest, SpaceRecordsAndStopsAndTheTakeOpensInReview) {
    TestBox box(looping());
    openSession();
    ASSERT_TRUE(connectTo(box));
    EXPECT_TRUE(page_->showsSuit());
    EXPECT_EQ(bar().name().text(), "take_001");
    for (const QComboBox* choice : page_->findChildren<QComboBox*>())
        EXPECT_FALSE(choice->focusPolicy() & Qt::ClickFocus)
            << "after a click into " << choice->accessibleName().toStdString() << " Space would open it";
    QSignalSpy steps(studio_.get(), &Studio::stepRequested);
    ASSERT_TRUE(recordFor(1));
    EXPECT_EQ(bar().button().state(), RecordButton::State::kRecording);
    EXPECT_EQ(page_->sidebar().runningTake(), "take_001");
    EXPECT_EQ(run().nextName(), "take_002");
    EXPECT_TRUE(page_->center().clock().safety().startsWith("On disk up to 0:"));
    key(Qt::Key_Escape);
    EXPECT_EQ(run().state(), State::kRecording) << "Esc never ends a take";
    key(Qt::Key_Space);
    ASSERT_TRUE(waitFor([&] { return steps.count() == 1; }));
    EXPECT_EQ(steps[0][0].value<Step>(), Step::kReview);
    ASSERT_EQ(session().takes.size(), 1u);
    EXPECT_EQ(session().takes[0].state, TakeState::kComplete);
    EXPECT_EQ(studio_->session().currentTake(), 0);
    EXPECT_EQ(page_->sidebar().runningTake(), "");
    EXPECT_EQ(bar().name().text(), "take_002");
}

TEST_F(RecordPageTest, AnotherProgramBeginsAndEndsATakeOrIsToldWhyNot) {
    QSignalSpy failed(studio_.get(), &Studio::failed);
    run().beginFromElsewhere("dance", {});
    ASSERT_EQ(failed.count(), 1);
    EXPECT_EQ(failed[0][1].toString(), "No suit is connected. Connect one first.");
    TestBox box(looping());
    openSession();
    ASSERT_TRUE(connectTo(box));
    CountdownSetting::get().setSeconds(10);
    ASSERT_TRUE(reach(State::kReady));
    run().beginFromElsewhere("dance", "second try");
    EXPECT_EQ(run().state(), State::kRecording) << "without a countdown";
    ASSERT_TRUE(waitFor([&] { return studio_->suit().recordedSeconds() > 0.3; }));
    EXPECT_EQ(run().takeName(), "dance_001");
    ASSERT_EQ(run().marks().size(), 1u);
    EXPECT_EQ(run().marks()[0].text, "second try");
    run().beginFromElsewhere("dance", {});
    EXPECT_EQ(failed.count(), 2);
    run().stopFromElsewhere();
    ASSERT_TRUE(waitFor([&] { return !session().takes.empty(); }));
    const auto notes = Take::open(pathOf("dance_001"))->notes();
    EXPECT_TRUE(QString::fromStdString(notes->at(0).text).endsWith(" second try")) << notes->at(0).text;
}

TEST_F(RecordPageTest, ThePreRollIsRememberedAndSeen) {
    run().setPreRollSeconds(5);
    EXPECT_EQ(studio_->settings().value("record/pre_roll_s").toInt(), 5);
    const auto buttons = bar().findChildren<Button*>();
    EXPECT_TRUE(std::any_of(buttons.begin(), buttons.end(), [](const Button* button) {
        return button->text() == "No countdown, pre-roll 5\u00A0s";
    }));
}

TEST_F(RecordPageTest, RecordingWellNeedsACalibration) {
    TestBox box(looping());
    openSession();
    RecordReadiness& readiness = page_->readiness();
    ASSERT_TRUE(connectTo(box));
    run().setOpensReview(false);
    ASSERT_TRUE(recordFor(1.8));
    EXPECT_TRUE(waitFor([&] { return readiness.verdict() == "Recording well"; }))
        << readiness.verdict().toStdString();
    run().stop();
    ASSERT_TRUE(waitFor([&] { return session().takes.size() == 1; }));
}

TEST_F(RecordPageTest, RecordingWithoutACalibrationSaysSo) {
    TestBox box(looping());
    openSession();
    RecordReadiness& readiness = page_->readiness();
    run().setOpensReview(false);
    studio_->suit().connectTo(QString::fromStdString(box.address()));
    ASSERT_TRUE(waitFor([&] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; }));
    ASSERT_TRUE(waitFor([&] { return readiness.verdict() == "Connected"; }))
        << readiness.verdict().toStdString();
    ASSERT_TRUE(recordFor(1.8));
    EXPECT_TRUE(waitFor([&] { return readiness.verdict() == "Recording, without calibration"; }))
        << readiness.verdict().toStdString();
    ASSERT_FALSE(readiness.problems().cards().empty());
    EXPECT_EQ(readiness.problems().cards()[0]->title(), "The suit is not calibrated");
    run().stop();
    ASSERT_TRUE(waitFor([&] { return session().takes.size() == 1; }));
    EXPECT_TRUE(Take::open(pathOf("take_001"))->derivedRuns()->empty()) << "no poses that mean nothing";
}

TEST_F(RecordPageTest, ATakeBeginsWithThePreRoll) {
    TestBox box(looping());
    openSession();
    ASSERT_TRUE(connectTo(box, 0));
    run().setPreRollSeconds(2);
    ASSERT_TRUE(reach(State::kReady));
    QTest::qWait(2000);  // what is kept
    key(Qt::Key_Space);
    ASSERT_TRUE(waitFor([&] { return studio_->suit().recordedSeconds() > 0; }));
    EXPECT_GT(studio_->suit().recordedSeconds(), 1);
    run().stop();
    ASSERT_TRUE(waitFor([&] { return !session().takes.empty(); }));
}

TEST_F(RecordPageTest, AfterStopItStaysWhenTheOperatorWantsItSo) {
    TestBox box(looping());
    openSession();
    ASSERT_TRUE(connectTo(box));
    run().setOpensReview(false);
    QSignalSpy steps(studio_.get(), &Studio::stepRequested);
    ASSERT_TRUE(recordFor(0.2));
    QTest::mouseClick(&bar().button(), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return session().takes.size() == 1; }));
    EXPECT_TRUE(reach(State::kReady));
    EXPECT_EQ(steps.count(), 0);
}

TEST_F(RecordPageTest, TheCountdownCountsAndEscEndsIt) {
    TestBox box(looping());
    openSession();
    ASSERT_TRUE(connectTo(box));
    CountdownSetting::get().setSeconds(3);
    ASSERT_TRUE(reach(State::kReady));
    key(Qt::Key_Space);
    ASSERT_EQ(run().state(), State::kCountdown);
    EXPECT_EQ(bar().button().digit(), 3);
    ASSERT_TRUE(waitFor([&] { return bar().button().digit() == 2; }));
    key(Qt::Key_Escape);
    EXPECT_EQ(run().state(), State::kReady);
    EXPECT_EQ(QSettings().value("record/countdown_s").toInt(), 3) << "remembered";
    CountdownSetting::get().setSeconds(1);
    key(Qt::Key_Space);
    EXPECT_EQ(run().state(), State::kCountdown);
    EXPECT_TRUE(reach(State::kRecording));
    run().stop();
    EXPECT_TRUE(waitFor([&] { return session().takes.size() == 1; }));
}

TEST_F(RecordPageTest, TheVoiceCountsAndSaysStartAndStopUnlessItIsOff) {
    TestBox box(looping());
    openSession();
    ASSERT_TRUE(connectTo(box));
    QStringList said;
    Voice::get().setSpeaker([&said](const QString& words) { said += words; });
    run().setOpensReview(false);
    CountdownSetting::get().setSeconds(1);
    ASSERT_TRUE(reach(State::kReady));
    for (const bool on : {true, false}) {
        Voice::get().setOn(on);
        run().press();
        EXPECT_TRUE(waitFor([&] { return studio_->suit().recordedSeconds() > 0.2; }));
        run().stop();
        EXPECT_TRUE(reach(State::kReady));
        EXPECT_EQ(said, on ? QStringList({"1", "Recording", "Stopped"}) : QStringList());
        said.clear();
    }
    Voice::get().setSpeaker({});
}

TEST_F(RecordPageTest, LeavingThePageEndsACountdownButNotATake) {
    TestBox box(looping());
    openSession();
    ASSERT_TRUE(connectTo(box));
    CountdownSetting::get().setSeconds(10);
    ASSERT_TRUE(reach(State::kReady));
    key(Qt::Key_Space);
    ASSERT_EQ(run().state(), State::kCountdown);
    page_->leave();
    EXPECT_EQ(run().state(), State::kReady);
    CountdownSetting::get().setSeconds(0);
    ASSERT_TRUE(recordFor(0.1));
    page_->leave();
    EXPECT_EQ(run().state(), State::kRecording);
    run().stop();
    EXPECT_TRUE(waitFor([&] { return session().takes.size() == 1; }));
}

TEST_F(RecordPageTest, MarkersAndNotesAreListedAndInTheTake) {
    TestBox box(looping());
    openSession();
    ASSERT_TRUE(connectTo(box));
    run().setOpensReview(false);
    key(Qt::Key_M);
    EXPECT_TRUE(run().marks().empty()) << "no take runs";
    ASSERT_TRUE(recordFor(0.2));
    key(Qt::Key_M);
    key(Qt::Key_N);
    ASSERT_TRUE(bar().note().hasFocus());
    QTest::keyClicks(&bar().note(), "m left heel slips");
    QTest::keyClick(&bar().note(), Qt::Key_Return);
    QTest::mouseClick(&bar().markerButton(), Qt::LeftButton);
    ASSERT_EQ(run().marks().size(), 3u) << "the letter m of a note is no marker";
    EXPECT_EQ(page_->sidebar().marks().count(), 3);
    run().stop();
    ASSERT_TRUE(waitFor([&] { return session().takes.size() == 1; }));
    const Take take = std::move(Take::open(pathOf("take_001")).value());
    const auto markers = take.markers();
    std::vector<std::string> labels;
    std::vector<double> times_s;
    for (const MarkerRow& marker : *markers)
        if (marker.kind == "user") {
            labels.push_back(marker.label);
            times_s.push_back(static_cast<double>(marker.sample) /
                              static_cast<double>(take.header().sample_rate_hz));
        }
    EXPECT_EQ(labels, (std::vector<std::string>{"Marker 1", "Marker 2"}));
    ASSERT_EQ(times_s.size(), 2u);
    EXPECT_DOUBLE_EQ(run().marks()[0].t_s, times_s[0]) << "the list tells where the take has it";
    EXPECT_DOUBLE_EQ(run().marks()[2].t_s, times_s[1]);
    ASSERT_EQ(take.notes()->size(), 1u);
    EXPECT_TRUE(QRegularExpression("^0:0\\d\\.\\d m left heel slips$")
                    .match(QString::fromStdString(take.notes()->at(0).text))
                    .hasMatch())
        << take.notes()->at(0).text;
}

TEST_F(RecordPageTest, TheNameIsTypedOnceAndCountsByItself) {
    TestBox box(looping());
    openSession();
    ASSERT_TRUE(connectTo(box));
    run().setOpensReview(false);
    key(Qt::Key_T);
    ASSERT_TRUE(bar().name().hasFocus());
    QTest::keyClicks(&bar().name(), "jump high");
    QTest::keyClick(&bar().name(), Qt::Key_Return);
    EXPECT_EQ(bar().name().text(), "jump_high_001");
    EXPECT_FALSE(bar().name().hasFocus()) << "the space bar is the page's again";
    ASSERT_TRUE(recordFor(0.2));
    key(Qt::Key_Space);
    ASSERT_TRUE(waitFor([&] { return session().takes.size() == 1; }));
    EXPECT_EQ(session().takes[0].name, "jump_high_001");
    EXPECT_EQ(bar().name().text(), "jump_high_002");
}

TEST_F(RecordPageTest, TheShotListCountsAndGoesOn) {
    TestBox box(looping());
    openSession();
    ASSERT_TRUE(connectTo(box));
    run().setOpensReview(false);
    studio_->session().setShots(shotsFromText("Walk, straight line\nTurn, both ways x2"));
    QListWidget& rows = page_->sidebar().shots().rows();
    ASSERT_EQ(rows.count(), 2);
    EXPECT_EQ(run().shot(), 0) << "the first one is due";
    QApplication::processEvents();
    const auto* heading = page_->sidebar().shots().findChild<SectionHeader*>();
    EXPECT_LE(rows.mapTo(&page_->sidebar(), QPoint()).y() -
                  heading->mapTo(&page_->sidebar(), QPoint(0, heading->height())).y(),
              Theme::get().px(8))
        << "right below its heading";
    EXPECT_EQ(run().takeName(), "walk_001");
    ASSERT_TRUE(recordFor(0.2));
    run().stop();
    ASSERT_TRUE(waitFor([&] { return session().takes.size() == 1 && run().state() == State::kReady; }));
    EXPECT_EQ(session().takes[0].shot, "Walk, straight line");
    EXPECT_EQ(run().shot(), 1);
    EXPECT_EQ(run().takeName(), "turn_001");
    QTest::mouseClick(rows.viewport(), Qt::LeftButton, {}, rows.visualItemRect(rows.item(1)).center());
    EXPECT_EQ(run().shot(), -1) << "clicked again it is left";
    studio_->session().setNotes("x");
    EXPECT_EQ(run().shot(), -1) << "and stays so";
    QTest::mouseClick(rows.viewport(), Qt::LeftButton, {}, rows.visualItemRect(rows.item(0)).center());
    EXPECT_EQ(run().takeName(), "walk_002");
    studio_->session().undoStack().undo();
    studio_->session().undoStack().undo();
    EXPECT_EQ(rows.count(), 0);
    EXPECT_EQ(run().shot(), -1);
}

TEST_F(RecordPageTest, ABrokenLinkIsNamedWhenTheButtonIsPressed) {
    TestBox box(looping());
    openSession();
    ASSERT_TRUE(connectTo(box));
    box.freeze(true);
    box.cut();
    ASSERT_TRUE(reach(State::kRefused));
    EXPECT_TRUE(bar().button().isEnabled());
    EXPECT_EQ(page_->center().refusal(), nullptr);
    QTest::mouseClick(&bar().button(), Qt::LeftButton);
    ASSERT_NE(page_->center().refusal(), nullptr);
    EXPECT_NE(page_->center().refusal()->title(), "");
    EXPECT_EQ(session().takes.size(), 0u);
    box.freeze(false);
    EXPECT_TRUE(reach(State::kReady));
    EXPECT_EQ(page_->center().refusal(), nullptr) << "it leaves by itself";
}

TEST_F(RecordPageTest, ShowsLevelsPairsAndReadiness) {
    TestBox box(looping());
    openSession();
    ASSERT_TRUE(connectTo(box));
    LevelsPanel& levels = page_->center().levels();
    ASSERT_TRUE(waitFor(
        [&] { return levels.meters().levels().size() == 2 && levels.meters().levels()[0].sound_db > -80; }));
    EXPECT_GT(levels.meters().levels()[0].peak_db, levels.meters().levels()[0].sound_db);
    EXPECT_EQ(levels.heard().rowCount(), 2);
    levels.meters().chosen(1);
    EXPECT_EQ(studio_->selection().board(), 1);
    RecordReadiness& readiness = page_->readiness();
    readiness.show();
    using Fact = RecordReadiness::Fact;
    ASSERT_TRUE(waitFor([&] { return readiness.value(Fact::kBoards) == "2 of 2"; }));
    ASSERT_TRUE(waitFor([&] { return readiness.value(Fact::kLink).contains("MB/s"); }));
    readiness.hide();
}

TEST_F(RecordPageTest, TheRunningTakeFollowsTheLastOneAndIsAloneHighlighted) {
    TestBox box(looping());
    openSession();
    ASSERT_TRUE(connectTo(box));
    run().setOpensReview(false);
    RecordSidebar& sidebar = page_->sidebar();
    sidebar.resize(Theme::get().px(248), 640);
    sidebar.show();
    auto& takes = *sidebar.findChild<TakeList*>();
    EXPECT_TRUE(takes.isVisible()) << "it says what will be here";
    ASSERT_TRUE(recordFor(0.2));
    EXPECT_FALSE(takes.isVisible()) << "nothing is above the first take";
    run().stop();
    ASSERT_TRUE(waitFor([&] { return session().takes.size() == 1; }));
    ASSERT_TRUE(reach(State::kReady));
    takes.setCurrentIndex(takes.model()->index(0, 0));
    ASSERT_TRUE(takes.selectionModel()->hasSelection());
    ASSERT_TRUE(recordFor(0.2));
    const auto rows = sidebar.findChildren<QWidget*>();
    const auto running = std::ranges::find_if(
        rows, [](const QWidget* row) { return row->accessibleName().startsWith("take_002, "); });
    ASSERT_NE(running, rows.end());
    QTest::qWait(50);
    const int last =
        takes.viewport()->mapTo(&sidebar, takes.visualRect(takes.model()->index(0, 0)).bottomLeft()).y();
    EXPECT_GT((*running)->y(), last);
    EXPECT_LE((*running)->y() - last, Theme::get().px(4));
    EXPECT_FALSE(takes.selectionModel()->hasSelection());
    run().stop();
    ASSERT_TRUE(waitFor([&] { return session().takes.size() == 2; }));
    ASSERT_TRUE(reach(State::kReady));
    takes.setCurrentIndex(takes.model()->index(1, 0));
    EXPECT_TRUE(takes.selectionModel()->hasSelection()) << "as before";
}

TEST(DurationWords, RoundDown) {
    EXPECT_EQ(durationWords(99.9), secondsText(99, 0));
    EXPECT_EQ(durationWords(59 * 60 + 59), "59 min");
    EXPECT_EQ(durationWords(3 * 3600 + 35 * 60 + 59), "3 h 35 min");
    EXPECT_EQ(durationWords(12 * 3600 - 1), "11 h");
}

TEST(TakeClock, SaysUpToWhereTheTakeIsSafe) {
    Theme::install(*qApp);
    TakeClock clock;
    EXPECT_EQ(clock.safety(), "");
    RecorderState state;
    state.commits = 1;
    state.committed_samples = 2'580'000;
    clock.setRecorder(state, 150'000);
    EXPECT_EQ(clock.safety(), "On disk up to 0:17.2");
    EXPECT_EQ(clock.safetyTone(), Tone::kOk);
    QTest::qWait(1100);
    clock.setRecorder(state, 150'000);
    EXPECT_EQ(clock.safetyTone(), Tone::kError) << "a second without a commit";
    ++state.commits;
    clock.setRecorder(state, 150'000);
    EXPECT_EQ(clock.safetyTone(), Tone::kOk);
    clock.setRecorder(std::nullopt, 150'000);
    EXPECT_EQ(clock.safety(), "");
}

TEST(ShotListDialogTest, ReadsWhatWasPasted) {
    Theme::install(*qApp);
    ShotListDialog dialog("- Walk x2\n- Sit\n", true, nullptr);
    ASSERT_EQ(dialog.shots().size(), 2u);
    EXPECT_EQ(dialog.shots()[0], (Shot{"Walk", 2}));
    dialog.editor->setPlainText("");
    EXPECT_TRUE(dialog.shots().empty());
}

}  // namespace
}  // namespace noctule::ui
