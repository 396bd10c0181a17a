// SPDX-License-Identifier: Apache-2.0
// Heading and place of the live body, on a clock of the test's own; boxes play the tiny take over TCP.
#include "ui/models/place_reset.h"

#include <gtest/gtest.h>

#include <QSignalSpy>

#include "tests/devices/support/test_box.h"
#include "tests/support/same_results.h"
#include "tests/ui/support/wait.h"
#include "ui/models/voice.h"

namespace noctule::ui {
namespace {

using noctule::test::TestBox;

class PlaceResetTest : public testing::Test {
protected:
    void SetUp() override {
        settings_.clear();
        settings_.setValue("record/tones", false);
        Voice::get().setSpeaker([this](const QString& words) { spoken_ += words; });
        suits_ = std::make_unique<LiveSuits>(
            jobs_, session_,
            LiveSuit::Surroundings{"test", [] { return std::string("2026-01-01T00:00:00Z"); }},
            LiveSuits::Folders{[this] { return QString::fromStdString(folder_.path().string()); },
                               QString::fromStdString(folder_.file("suits"))});
        place_ = std::make_unique<PlaceReset>(*suits_, session_, settings_, [this] { return now_ms_; });
    }
    void TearDown() override { Voice::get().setSpeaker({}); }

    void openSession() { ASSERT_TRUE(session_.create(QString::fromStdString(folder_.file("here")), "here")); }
    bool showsBody() {
        return waitFor([this] {
            return suits_->current().suit.phase() == LiveSuit::Phase::kLooking && place_->whyNot().isEmpty();
        });
    }
    bool connectSuit() {
        const Take take = std::move(Take::open(noctule::test::kTinyTake).value());
        suits_->current().suit.connectTo(QString::fromStdString(box_.address()),
                                         {take.calibrationInForce()->value, take.actorInForce()->value, 0.5});
        return showsBody();
    }
    FloorMove floor() const { return *suits_->current().floor; }
    /// By which the frame that is shown now comes to the origin.
    FloorMove toOrigin() const { return moveToOrigin(*suits_->current().suit.frame()->pose->pose); }
    QUndoStack& undoStack() { return session_.undoStack(); }
    std::vector<std::string> labelsInTake() const {
        const Session& session = session_.session();
        const Take take = std::move(Take::open(session.pathOf(session.takes.back()).string()).value());
        std::vector<std::string> labels;
        const auto markers = take.markers();
        for (const MarkerRow& marker : markers.value())
            if (marker.kind == "user")
                labels.push_back(marker.label);
        return labels;
    }

    const noctule::test::Folder folder_;
    QSettings settings_;
    qint64 now_ms_ = 500;
    QStringList spoken_;
    Jobs jobs_;
    SessionModel session_{jobs_, [this] { return QString::fromStdString(folder_.file("sessions")); }};
    TestBox box_{{.loops = true}};
    std::unique_ptr<LiveSuits> suits_;
    std::unique_ptr<PlaceReset> place_;
};

TEST_F(PlaceResetTest, TheBodyStandsAtItsPlaceUntilItIsTakenBack) {
    EXPECT_EQ(place_->whyNot(), "No suit is connected. Connect one first.");
    ASSERT_TRUE(connectSuit());
    QSignalSpy reset(place_.get(), &PlaceReset::wasReset), moved(place_.get(), &PlaceReset::moved);
    const FloorMove wanted = toOrigin();
    ASSERT_FALSE(wanted == FloorMove{}) << "else nothing would be seen of it";
    place_->reset();
    EXPECT_TRUE(floor() == wanted);
    EXPECT_EQ(reset.count(), 1);
    EXPECT_EQ(spoken_, QStringList({"Heading and place are here"}));
    session_.undoStack().undo();
    EXPECT_TRUE(floor() == FloorMove{});
    session_.undoStack().redo();
    EXPECT_TRUE(floor() == wanted);
    EXPECT_EQ(moved.count(), 3);
}

TEST_F(PlaceResetTest, ItIsForgottenWithTheSuit) {
    ASSERT_TRUE(connectSuit());
    place_->reset();
    ASSERT_FALSE(floor() == FloorMove{});
    suits_->current().suit.disconnectSuit();
    EXPECT_TRUE(floor() == FloorMove{});
    EXPECT_EQ(place_->whyNot(), "No suit is connected. Connect one first.");
    session_.undoStack().undo();
    EXPECT_EQ(undoStack().count(), 0) << "there is nothing to bring back";
    EXPECT_TRUE(floor() == FloorMove{});
}

TEST_F(PlaceResetTest, TheLonePerformerHearsTheCountdown) {
    ASSERT_TRUE(connectSuit());
    settings_.setValue("record/countdown_s", 2);
    place_->resetLater();
    EXPECT_TRUE(place_->isCounting());
    now_ms_ += 999;
    place_->look();
    EXPECT_EQ(spoken_, QStringList({"2"}));
    now_ms_ += 1000;
    place_->look();
    EXPECT_EQ(spoken_, QStringList({"2", "1"}));
    EXPECT_TRUE(floor() == FloorMove{}) << "one ms is left";
    now_ms_ += 1;
    const FloorMove wanted = toOrigin();
    place_->look();
    EXPECT_TRUE(floor() == wanted);
    EXPECT_FALSE(place_->isCounting());
    EXPECT_EQ(spoken_, QStringList({"2", "1", "Heading and place are here"}));
}

TEST_F(PlaceResetTest, TheSameKeyEndsTheCountdownAndWithoutOneThereAreFiveSeconds) {
    ASSERT_TRUE(connectSuit());
    settings_.setValue("record/countdown_s", 0);
    place_->resetLater();
    EXPECT_EQ(spoken_, QStringList({"5"}));
    place_->resetLater();
    EXPECT_FALSE(place_->isCounting());
    now_ms_ += 60'000;
    place_->look();
    EXPECT_TRUE(floor() == FloorMove{});
    EXPECT_EQ(undoStack().count(), 0);
}

TEST_F(PlaceResetTest, ASuitThatLeavesDuringTheCountdownIsNotReset) {
    ASSERT_TRUE(connectSuit());
    place_->resetLater();
    suits_->current().suit.disconnectSuit();
    spoken_.clear();
    QSignalSpy said(place_.get(), &PlaceReset::said);
    now_ms_ += 60'000;
    place_->look();
    EXPECT_EQ(spoken_, QStringList({"Heading and place were not reset"}));
    ASSERT_EQ(said.count(), 1);
    EXPECT_EQ(said[0][0].toString(), "No suit is connected. Connect one first.");
    EXPECT_EQ(undoStack().count(), 0);
}

TEST_F(PlaceResetTest, TheCountdownEndsWhenSomebodyElseIsLookedAt) {
    const TestBox second({.loops = true, .serial = "NB-000002"});
    ASSERT_TRUE(connectSuit());
    SuitInUse& first = suits_->current();
    suits_->add(QString::fromStdString(second.address()));
    const auto connected = [&] { return suits_->connected().size() == 2; };
    ASSERT_TRUE(waitFor(connected));
    SuitInUse& other = *suits_->connected().back();
    ASSERT_NE(&first, &other);
    suits_->setCurrent(first);
    ASSERT_TRUE(showsBody());
    place_->resetLater();
    ASSERT_TRUE(place_->isCounting());
    suits_->setCurrent(other);
    QSignalSpy said(place_.get(), &PlaceReset::said);
    place_->look();
    EXPECT_FALSE(place_->isCounting());
    ASSERT_EQ(said.count(), 1);
    EXPECT_EQ(said[0][0].toString(), "The countdown has ended. Heading and place stay.");
    now_ms_ += 60'000;
    place_->look();
    EXPECT_TRUE(*first.floor == FloorMove{} && *other.floor == FloorMove{});
    EXPECT_EQ(undoStack().count(), 0);
}

TEST_F(PlaceResetTest, AnchorsOfTheRoomGiveHeadingAndPlace) {
    const TestBox room({.loops = true, .serial = "NB-000002", .drive_hz = 48000, .fixed = true});
    ASSERT_TRUE(connectSuit());
    SuitInUse& worn = suits_->current();
    suits_->add(QString::fromStdString(room.address()));
    ASSERT_TRUE(waitFor([&] { return place_->whyNot() == "The room's anchors give heading and place."; }));
    suits_->setCurrent(worn);
    EXPECT_EQ(place_->whyNot(), "The room's anchors give heading and place.") << "of the suit as well";
    place_->reset();
    EXPECT_TRUE(floor() == FloorMove{});
    EXPECT_EQ(undoStack().count(), 0);
}

TEST_F(PlaceResetTest, ATakeTellsOfItAndHoldsWhatItsFileGives) {
    openSession();
    ASSERT_TRUE(connectSuit());
    place_->reset();
    ASSERT_FALSE(floor() == FloorMove{});
    QSignalSpy marked(place_.get(), &PlaceReset::marked), ended(suits_.get(), &LiveSuits::recordingEnded);
    ASSERT_EQ(suits_->record({"walk", {}, 0, 0}), "");
    ASSERT_TRUE(waitFor([&] {
        return suits_->phase() == LiveSuit::Phase::kRecording && suits_->recordedSeconds() >= 1 &&
               place_->whyNot().isEmpty();
    }));
    EXPECT_TRUE(floor() == FloorMove{}) << "the take's own stream begins at the place";
    session_.undoStack().undo();
    EXPECT_TRUE(floor() == FloorMove{}) << "what was before is of another stream";
    EXPECT_EQ(marked.count(), 0);
    place_->reset();
    session_.undoStack().undo();
    ASSERT_EQ(marked.count(), 2);
    EXPECT_GT(marked[0][0].toDouble(), 0.9);
    suits_->stopRecording();
    ASSERT_TRUE(waitFor([&] { return ended.count() == 1; }));
    EXPECT_EQ(labelsInTake(),
              (std::vector<std::string>{"heading and place reset", "heading and place reset, taken back"}));
    const Session& session = session_.session();
    const std::string live = session.pathOf(session.takes.back()).string();
    noctule::test::expectSameResults(live, noctule::test::processedFromFile(folder_, live));
}

}  // namespace
}  // namespace noctule::ui
