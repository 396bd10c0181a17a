// SPDX-License-Identifier: Apache-2.0
// The connected suit against a box that plays the tiny take over TCP.
#include "ui/models/live_suit.h"

#include <gtest/gtest.h>

#include <QSettings>
#include <QSignalSpy>
#include <algorithm>

#include "core/session/placement.h"
#include "tests/devices/support/test_box.h"
#include "tests/support/same_results.h"
#include "tests/ui/support/stall_watch.h"
#include "tests/ui/support/wait.h"

namespace noctule::ui {
namespace {

using Phase = LiveSuit::Phase;
using noctule::test::TestBox;

KnownWearing knownOfTinyTake() {
    const Take take = std::move(Take::open(noctule::test::kTinyTake).value());
    return {take.calibrationInForce()->value, take.actorInForce()->value, 0.5};
}

class LiveSuitTest : public testing::Test {
protected:
    void SetUp() override {
        QSettings().clear();
        suit_ = std::make_unique<LiveSuit>(
            jobs_, session_,
            LiveSuit::Surroundings{"test", [] { return std::string("2026-01-01T00:00:00Z"); }});
    }

    QString home() const { return QString::fromStdString(folder_.file("sessions")); }
    void openSession() { ASSERT_TRUE(session_.create(QString::fromStdString(folder_.file("here")), "here")); }
    bool reach(Phase phase) {
        return waitFor([&] { return suit_->phase() == phase; });
    }
    bool connectTo(const TestBox& box) {
        suit_->connectTo(QString::fromStdString(box.address()), knownOfTinyTake());
        return reach(Phase::kLooking);
    }
    /// Seconds of it.
    bool recordFor(double seconds) {
        const QString why_not = suit_->record({"walk", {}, 0, 0});
        EXPECT_EQ(why_not, "");
        return reach(Phase::kRecording) && waitFor([&] { return suit_->recordedSeconds() >= seconds; });
    }
    std::string takePath(const char* name) const {
        const Session& session = session_.session();
        return session.pathOf(session.takes[static_cast<size_t>(session.findTake(name))]).string();
    }

    const noctule::test::Folder folder_;
    Jobs jobs_;
    SessionModel session_{jobs_, [this] { return home(); }};
    std::unique_ptr<LiveSuit> suit_;
};

TEST_F(LiveSuitTest, LooksByItselfOnceTheBoxHasGreeted) {
    TestBox box({});
    EXPECT_EQ(suit_->phase(), Phase::kNone);
    EXPECT_FALSE(suit_->status()->hello);
    EXPECT_NE(suit_->record({"walk", {}, 0, 0}), "");
    QSignalSpy frames(suit_.get(), &LiveSuit::frameChanged);
    ASSERT_TRUE(connectTo(box));
    EXPECT_EQ(suit_->status()->hello->serial, "NB-000777");
    EXPECT_EQ(suit_->suit().boards.size(), 2u);
    ASSERT_TRUE(waitFor([&] { return frames.count() > 20; }));
    ASSERT_TRUE(waitFor([&] { return suit_->frame()->health.boards[0].frames_per_s > 130; }));
    EXPECT_FALSE(suit_->recording());
    suit_->disconnectSuit();
    EXPECT_EQ(suit_->phase(), Phase::kNone);
    EXPECT_FALSE(suit_->frame());
    EXPECT_TRUE(waitFor([&] { return !box.streaming(); }));
}

TEST_F(LiveSuitTest, ATakeIsInTheSessionWithTheResultsThatTheFileGives) {
    TestBox box({});
    openSession();
    ASSERT_TRUE(connectTo(box));
    QSignalSpy started(suit_.get(), &LiveSuit::recordingStarted);
    QSignalSpy ended(suit_.get(), &LiveSuit::recordingEnded);
    ASSERT_TRUE(recordFor(2));
    ASSERT_EQ(started.count(), 1);
    EXPECT_EQ(started[0][0].toString(), "walk_001");
    const double here_s = suit_->addMarker("here");
    EXPECT_GT(suit_->recording()->committed_samples, 100'000);
    suit_->stopRecording();
    EXPECT_EQ(suit_->phase(), Phase::kSaving);
    ASSERT_TRUE(waitFor([&] { return ended.count() == 1; }));
    EXPECT_EQ(ended[0][0].toString(), "walk_001");
    EXPECT_EQ(ended[0][1].toString(), "");
    ASSERT_EQ(session_.session().takes.size(), 1u);
    const SessionTake& take = session_.session().takes[0];
    EXPECT_EQ(take.state, TakeState::kComplete);
    EXPECT_TRUE(take.processed);
    EXPECT_GE(take.duration_s, 2.0);
    const std::string live = takePath("walk_001");
    const Take file = std::move(Take::open(live).value());
    EXPECT_EQ(file.meta().at("performer"), session_.session().current_performer);
    EXPECT_EQ(file.markers()->back().label, "here");
    EXPECT_DOUBLE_EQ(static_cast<double>(file.markers()->back().sample) / 150000, here_s);
    noctule::test::expectSameResults(live, noctule::test::processedFromFile(folder_, live));
    EXPECT_TRUE(reach(Phase::kLooking)) << "and looks again";
}

TEST_F(LiveSuitTest, ATakeWithAPreRollBeginsBeforeItWasAskedForAndTheLookingGoesOn) {
    TestBox box({.loops = true});
    openSession();
    KnownWearing known = knownOfTinyTake();
    known.rest_s = 0;
    suit_->connectTo(QString::fromStdString(box.address()), known);
    ASSERT_TRUE(reach(Phase::kLooking));
    ASSERT_TRUE(waitFor([&] { return suit_->frame() && suit_->frame()->sample > 150'000; }));
    const int64_t looked_at = suit_->frame()->sample;
    QSignalSpy ended(suit_.get(), &LiveSuit::recordingEnded);
    EXPECT_EQ(suit_->record({"walk", {}, 0, 0.8}), "");
    ASSERT_TRUE(reach(Phase::kRecording));
    ASSERT_TRUE(waitFor([&] { return suit_->recordedSeconds() > 0; }));
    EXPECT_GT(suit_->recordedSeconds(), 0.7) << "at once";
    EXPECT_GE(suit_->frame()->sample, looked_at) << "what is shown goes on";
    ASSERT_TRUE(waitFor([&] { return suit_->recordedSeconds() > 1.5; }));
    suit_->stopRecording();
    ASSERT_TRUE(waitFor([&] { return ended.count() == 1; }));
    EXPECT_EQ(suit_->phase(), Phase::kLooking) << "at once: the stream never ended";
    EXPECT_GE(suit_->frame()->sample, looked_at);
    EXPECT_TRUE(box.streaming());
    EXPECT_GE(session_.session().takes[0].duration_s, 1.5);
    EXPECT_EQ(session_.session().takes[0].state, TakeState::kComplete);
    const int64_t looked_at_last = suit_->frame()->sample;
    ASSERT_TRUE(recordFor(0.3)) << "and one without";
    EXPECT_TRUE(waitFor([&] { return suit_->frame()->sample < looked_at_last; })) << "begins another stream";
    suit_->stopRecording();
    ASSERT_TRUE(waitFor([&] { return ended.count() == 2; }));
}

TEST_F(LiveSuitTest, WhereEachStreamBeginsInTheRestPoseThereIsNoPreRoll) {
    TestBox box({.loops = true});
    openSession();
    ASSERT_TRUE(connectTo(box));
    EXPECT_FALSE(suit_->canPreRoll());
    ASSERT_TRUE(waitFor([&] { return suit_->frame() && suit_->frame()->sample > 150'000; }));
    EXPECT_EQ(suit_->record({"walk", {}, 0, 0.8}), "");
    ASSERT_TRUE(waitFor([&] { return suit_->recordedSeconds() > 0; }));
    EXPECT_LT(suit_->recordedSeconds(), 0.7);
    suit_->stopRecording();
    ASSERT_TRUE(reach(Phase::kLooking));
}

/// However late it is kept, and also where the stream is younger than the evidence should be long.
TEST_F(LiveSuitTest, TheRestPoseOfEvidenceEndsWhereItWasSeen) {
    TestBox box({.loops = true});
    openSession();
    ASSERT_TRUE(connectTo(box));
    ASSERT_TRUE(waitFor([&] { return suit_->frame() && suit_->frame()->sample > 200'000; }));
    QSignalSpy kept(suit_.get(), &LiveSuit::evidenceRecorded);
    LiveSuit::EvidencePlan plan;
    plan.seen_sample = 60'000;
    plan.base_name = "rest_1";
    plan.kind = "level";
    plan.length_s = 1;
    plan.rest_s = 0.3;
    ASSERT_EQ(suit_->keepEvidence(plan), "");
    ASSERT_TRUE(waitFor([&] { return kept.count() == 1; }));
    const auto take = Take::open(kept[0][0].toString().toStdString());
    ASSERT_TRUE(take) << take.error().text();
    std::vector<int64_t> rest;
    const auto markers = take->markers();
    for (const MarkerRow& marker : *markers)
        if (marker.kind == "rest")
            rest.push_back(marker.sample);
    EXPECT_EQ(rest, (std::vector<int64_t>{15'000, 60'000}));
}

TEST_F(LiveSuitTest, ATakeShorterThanItsRestPoseIsToldAsThat) {
    TestBox box({.loops = true});
    openSession();
    ASSERT_TRUE(connectTo(box));
    QSignalSpy ended(suit_.get(), &LiveSuit::recordingEnded), warned(suit_.get(), &LiveSuit::warned),
        failed(suit_.get(), &LiveSuit::failed);
    EXPECT_EQ(suit_->record({"walk", {}, 30, 0}), "");
    ASSERT_TRUE(waitFor([&] { return suit_->recordedSeconds() > 0.1; }));
    suit_->stopRecording();
    ASSERT_TRUE(waitFor([&] { return ended.count() == 1; }));
    ASSERT_EQ(warned.count(), 1);
    EXPECT_EQ(warned[0][0].toString(),
              "walk_001: The take ended before its rest pose did. All of its sound is there, but no pose.");
    EXPECT_EQ(failed.count(), 0);
}

TEST_F(LiveSuitTest, WithoutASessionOneIsMadeByDate) {
    TestBox box({});
    ASSERT_TRUE(connectTo(box));
    QSignalSpy ended(suit_.get(), &LiveSuit::recordingEnded);
    ASSERT_TRUE(recordFor(0.3));
    const QString today = QDate::currentDate().toString(Qt::ISODate);
    ASSERT_TRUE(session_.isOpen());
    EXPECT_EQ(QString::fromStdString(session_.session().name), today);
    suit_->stopRecording();
    ASSERT_TRUE(waitFor([&] { return ended.count() == 1; }));
    EXPECT_EQ(takePath("walk_001"), (home() + "/" + today + "/takes/walk_001.noctule").toStdString());
}

TEST_F(LiveSuitTest, ACutLinkComesBackAndTheTakeHasAGap) {
    TestBox box({});
    openSession();
    ASSERT_TRUE(connectTo(box));
    QSignalSpy ended(suit_.get(), &LiveSuit::recordingEnded);
    ASSERT_TRUE(recordFor(0.5));
    box.cut();
    ASSERT_TRUE(waitFor([&] { return suit_->status()->link == LinkState::kLost; }));
    EXPECT_EQ(suit_->phase(), Phase::kRecording);
    ASSERT_TRUE(waitFor([&] { return suit_->status()->reconnections == 1; }));
    const double then_s = suit_->recordedSeconds();
    ASSERT_TRUE(waitFor([&] { return suit_->recordedSeconds() > then_s + 0.5; }));
    suit_->stopRecording();
    ASSERT_TRUE(waitFor([&] { return ended.count() == 1; }));
    EXPECT_EQ(ended[0][1].toString(), "");
}

TEST_F(LiveSuitTest, ABoxThatRestartsEndsTheTakeIntactAndSaysSo) {
    TestBox box({});
    openSession();
    ASSERT_TRUE(connectTo(box));
    QSignalSpy ended(suit_.get(), &LiveSuit::recordingEnded);
    ASSERT_TRUE(recordFor(0.5));
    box.restart();
    ASSERT_TRUE(waitFor([&] { return ended.count() == 1; }));
    EXPECT_NE(ended[0][1].toString(), "");
    EXPECT_EQ(session_.session().takes.at(0).state, TakeState::kComplete);
    EXPECT_TRUE(reach(Phase::kLooking));
}

TEST_F(LiveSuitTest, AnotherBoxAtTheSameAddressIsAnotherSuit) {
    TestBox box({.loops = true});
    ASSERT_TRUE(connectTo(box));
    ASSERT_TRUE(suit_->calibration());
    QStringList told;
    QObject::connect(suit_.get(), &LiveSuit::warned, [&](const QString& what) {
        if (what.startsWith("Another box answers"))
            told << what;
    });
    const auto starts = [&] {
        return std::ranges::count_if(box.events(), [](const link::BoxEvent& event) {
            return std::holds_alternative<link::StartWanted>(event);
        });
    };
    ASSERT_TRUE(waitFor([&] { return starts() == 1; }));
    box.restart();
    ASSERT_TRUE(waitFor([&] { return starts() == 2; }));
    ASSERT_TRUE(reach(Phase::kLooking));
    EXPECT_TRUE(suit_->calibration()) << "it was switched off and on";
    EXPECT_TRUE(told.isEmpty());
    box.becomes("NB-000778");
    ASSERT_TRUE(waitFor([&] { return !told.isEmpty(); }));
    ASSERT_TRUE(reach(Phase::kLooking));
    EXPECT_EQ(suit_->serial(), "NB-000778");
    EXPECT_FALSE(suit_->calibration()) << "that of the other suit";
    EXPECT_TRUE(told[0].contains("NB-000778 instead of NB-000777"));
    EXPECT_EQ(told.size(), 1);
}

TEST_F(LiveSuitTest, WhoeverDoesNotAnswerIsRefusedInWords) {
    TestBox box({.answers = false});
    suit_->connectTo(QString::fromStdString(box.address()));
    EXPECT_EQ(suit_->phase(), Phase::kConnecting);
    EXPECT_NE(suit_->record({"walk", {}, 0, 0}), "");
    ASSERT_TRUE(reach(Phase::kRefused));
    ASSERT_TRUE(suit_->status()->trouble);
    EXPECT_FALSE(suit_->status()->trouble->message.empty());
    EXPECT_FALSE(suit_->status()->trouble->remedy.empty());
    QSignalSpy failed(suit_.get(), &LiveSuit::failed);
    TestBox other({});
    suit_->connectTo(QString::fromStdString(other.address()));
    EXPECT_TRUE(reach(Phase::kLooking));
    suit_->disconnectSuit();
    suit_->connectTo("somewhere");
    ASSERT_EQ(failed.count(), 1);
    EXPECT_TRUE(failed[0][0].toString().contains("somewhere"));
    EXPECT_EQ(suit_->phase(), Phase::kNone);
}

TEST_F(LiveSuitTest, DisconnectingEndsATakeIntactFirst) {
    TestBox box({});
    openSession();
    ASSERT_TRUE(connectTo(box));
    QSignalSpy ended(suit_.get(), &LiveSuit::recordingEnded);
    ASSERT_TRUE(recordFor(0.5));
    TestBox other({});
    suit_->connectTo(QString::fromStdString(other.address()));
    EXPECT_EQ(suit_->phase(), Phase::kSaving);
    ASSERT_TRUE(reach(Phase::kLooking));
    ASSERT_EQ(ended.count(), 1);
    EXPECT_EQ(session_.session().takes.at(0).state, TakeState::kComplete);
    EXPECT_EQ(suit_->address().toStdString(), other.address());
    EXPECT_FALSE(suit_->calibration()) << "was known of the other suit";
}

TEST_F(LiveSuitTest, StoppingBeforeTheFirstSoundStillMakesATake) {
    TestBox box({});
    openSession();
    ASSERT_TRUE(connectTo(box));
    QSignalSpy ended(suit_.get(), &LiveSuit::recordingEnded);
    EXPECT_EQ(suit_->record({"walk", "Shot 2", 0, 0}), "");
    EXPECT_EQ(suit_->phase(), Phase::kStarting);
    suit_->stopRecording();
    ASSERT_TRUE(waitFor([&] { return ended.count() == 1; }));
    const Take file = std::move(Take::open(takePath("walk_001")).value());
    EXPECT_EQ(file.meta().at("x_shot"), "Shot 2");
}

TEST_F(LiveSuitTest, TheInterfaceNeverWaits) {
    TestBox box({});
    openSession();
    if (!ui::test::timesAreJudged())
        GTEST_SKIP() << ui::test::kWhyNotJudged;
    ui::test::StallWatch watch;
    ASSERT_TRUE(connectTo(box));
    QSignalSpy ended(suit_.get(), &LiveSuit::recordingEnded);
    ASSERT_TRUE(recordFor(0.5));
    suit_->stopRecording();
    ASSERT_TRUE(waitFor([&] { return ended.count() == 1; }));
    suit_->disconnectSuit();
    ASSERT_TRUE(waitFor([&] { return jobs_.idle(); }));
    std::printf("a take of a suit: longest gap %.0f ms, of it ours %.0f ms\n", watch.longest_ms(),
                watch.longestOwn_ms());
    EXPECT_LT(watch.longestOwn_ms(), ui::test::kLongestStall_ms);
}

TEST_F(LiveSuitTest, AnotherPerformersSuitIsTakenBySerialNumber) {
    TestBox box({});
    openSession();
    ASSERT_TRUE(connectTo(box));
    QSignalSpy changed(suit_.get(), &LiveSuit::wearingChanged);
    Performer performer = session_.session().performers[0];
    performer.suit = suit_->suit();
    std::swap(performer.suit.boards[0].segment, performer.suit.boards[1].segment);
    std::swap(performer.suit.boards[0], performer.suit.boards[1]);
    session_.changePerformer(0, performer, "Swap");
    EXPECT_EQ(changed.count(), 1);
    EXPECT_EQ(suit_->suit().boards[0].serial, "NB-004100");
    EXPECT_EQ(suit_->suit().boards[0].segment, "LeftHand");
    session_.undoStack().undo();
    EXPECT_EQ(suit_->suit().boards[0].segment, "Chest");
    ASSERT_TRUE(waitFor([&] { return suit_->phase() == Phase::kLooking && jobs_.idle(); }));
}

}  // namespace
}  // namespace noctule::ui
