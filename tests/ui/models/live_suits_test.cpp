// SPDX-License-Identifier: Apache-2.0
// Several suits beside each other, each a box that plays the tiny take over TCP: who wears them, which one is
// looked at, and their take.
#include "ui/models/live_suits.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QSettings>
#include <QSignalSpy>

#include "core/job/atomic_file.h"
#include "tests/devices/support/test_box.h"
#include "tests/ui/support/wait.h"

namespace noctule::ui {
namespace {

using noctule::test::TestBox;
using SuitsPhase = LiveSuit::Phase;

KnownWearing wearingOfTinyTake() {
    const Take take = std::move(Take::open(noctule::test::kTinyTake).value());
    return {take.calibrationInForce()->value, take.actorInForce()->value, 0.5};
}

class LiveSuitsTest : public testing::Test {
protected:
    void SetUp() override {
        QSettings().clear();
        suits_ = std::make_unique<LiveSuits>(
            jobs_, session_,
            LiveSuit::Surroundings{"test", [] { return std::string("2026-01-01T00:00:00Z"); }},
            LiveSuits::Folders{[this] { return QString::fromStdString(folder_.path().string()); },
                               QString::fromStdString(folder_.file("suits"))});
    }

    void openSession() { ASSERT_TRUE(session_.create(QString::fromStdString(folder_.file("here")), "here")); }
    static std::unique_ptr<TestBox> makeBox(const std::string& serial, double drive_hz) {
        return std::make_unique<TestBox>(
            TestBox::Options{.loops = true, .serial = serial, .drive_hz = drive_hz});
    }
    static bool looks(const SuitInUse& worn) {
        return waitFor([&] { return worn.suit.phase() == SuitsPhase::kLooking; });
    }
    /// Both looked at.
    bool connectBoth() {
        suits_->current().suit.connectTo(QString::fromStdString(ann_->address()), wearingOfTinyTake());
        if (!looks(suits_->current()))
            return false;
        suits_->add(QString::fromStdString(bob_->address()), wearingOfTinyTake());
        return suits_->areSeveral() && looks(suits_->current());
    }
    SuitInUse& first() { return *suits_->connected().at(0); }
    SuitInUse& second() { return *suits_->connected().at(1); }
    bool recordFor(double seconds) {
        const QString why_not = suits_->record({"duo", {}, 0, 0});
        EXPECT_EQ(why_not, "");
        return waitFor([&] {
            return suits_->phase() == SuitsPhase::kRecording && first().suit.recordedSeconds() >= seconds &&
                   second().suit.recordedSeconds() >= seconds;
        });
    }
    Take recordedTake() const {
        const Session& session = session_.session();
        return std::move(Take::open(session.pathOf(session.takes.back()).string()).value());
    }

    const noctule::test::Folder folder_;
    Jobs jobs_;
    SessionModel session_{jobs_, [this] { return QString::fromStdString(folder_.file("sessions")); }};
    std::unique_ptr<TestBox> ann_ = makeBox("NB-000001", 40000), bob_ = makeBox("NB-000002", 48000);
    std::unique_ptr<LiveSuits> suits_;
};

TEST_F(LiveSuitsTest, ABoxComesBackWhereItWas) {
    ASSERT_TRUE(connectBoth());
    const SuitInUse& of_bob = second();
    first().suit.disconnectSuit();
    first().suit.disconnectSuit();
    ASSERT_TRUE(suits_->connected().empty());
    suits_->add(QString::fromStdString(bob_->address()), wearingOfTinyTake());
    ASSERT_EQ(suits_->connected().size(), 1U);
    EXPECT_EQ(&first(), &of_bob) << "there its earlier connection is waited for";
    EXPECT_TRUE(looks(first()));
}

TEST_F(LiveSuitsTest, OneMoreIsLookedAtAndWornByAPerformerOfItsOwn) {
    ASSERT_TRUE(connectBoth());
    EXPECT_EQ(&suits_->current(), &second());
    EXPECT_EQ(suits_->letterOf(first()), 0);
    EXPECT_EQ(suits_->letterOf(second()), 1);
    EXPECT_EQ(suits_->nameOf(second()), "Performer 2") << "no session is open";
    openSession();
    EXPECT_EQ(suits_->nameOf(first()), "Performer 1");
    EXPECT_EQ(suits_->nameOf(second()), "Performer 2");
    ASSERT_EQ(session_.session().performers.size(), 2u) << "a new one";
    EXPECT_EQ(session_.session().current_performer, "Performer 1");
    Performer named = session_.session().performers[1];
    named.name = "Bob";
    session_.changePerformer(1, named, "Rename");
    EXPECT_EQ(suits_->nameOf(second()), "Bob");
    suits_->setPerformer(second(), "Performer 1");
    EXPECT_EQ(suits_->nameOf(second()), "Performer 1");
    EXPECT_EQ(suits_->nameOf(first()), "Bob") << "they have changed suits";
    suits_->add(QString::fromStdString(ann_->address()));
    EXPECT_EQ(suits_->connected().size(), 2u) << "it is there already";
    EXPECT_EQ(&suits_->current(), &first());
}

TEST_F(LiveSuitsTest, EachIsDisconnectedAlone) {
    ASSERT_TRUE(connectBoth());
    int looks_at = 0;
    suits_->follow(&LiveSuit::frameChanged, suits_.get(), [&] { ++looks_at; });
    SuitInUse& ann = first();
    second().suit.disconnectSuit();
    EXPECT_EQ(suits_->connected(), std::vector<SuitInUse*>{&ann});
    EXPECT_EQ(&suits_->current(), &ann) << "another one is looked at";
    EXPECT_GT(looks_at, 0);
    EXPECT_EQ(ann.suit.phase(), SuitsPhase::kLooking) << "and knows nothing of it";
    looks_at = 0;
    EXPECT_TRUE(waitFor([&] { return looks_at > 3; })) << "its frames are followed now";
    suits_->add(QString::fromStdString(bob_->address()), wearingOfTinyTake());
    ASSERT_TRUE(looks(suits_->current()));
    ann.suit.disconnectSuit();
    EXPECT_EQ(suits_->connected().size(), 1u);
    EXPECT_EQ(suits_->letterOf(suits_->current()), 0);
}

TEST_F(LiveSuitsTest, TwoRecordIntoOneTakeAndLookOnAfterIt) {
    openSession();
    ASSERT_TRUE(connectBoth());
    QSignalSpy started(suits_.get(), &LiveSuits::recordingStarted),
        ended(suits_.get(), &LiveSuits::recordingEnded), failed(suits_.get(), &LiveSuits::failed),
        several(suits_.get(), &LiveSuits::takeOfSeveral);
    EXPECT_FALSE(suits_->canPreRoll());
    ASSERT_TRUE(recordFor(1));
    ASSERT_EQ(started.count(), 1);
    EXPECT_EQ(started[0][0].toString(), "duo_001");
    EXPECT_NE(suits_->record({"duo", {}, 0, 0}), "") << "it is being recorded already";
    EXPECT_EQ(first().suit.phase(), SuitsPhase::kRecording);
    EXPECT_TRUE(second().suit.frame()) << "the live view goes on";
    EXPECT_TRUE(waitFor([&] {
        const auto disk = suits_->onDisk();
        return disk.recorder && disk.recorder->committed_samples > 0 && disk.sample_rate_hz == 150'000;
    }));
    suits_->addMarker("here");
    suits_->stopRecording();
    EXPECT_EQ(suits_->phase(), SuitsPhase::kSaving);
    ASSERT_TRUE(waitFor([&] { return ended.count() == 1; }));
    EXPECT_EQ(ended[0][0].toString(), "duo_001");
    EXPECT_EQ(ended[0][1].toString(), "");
    EXPECT_EQ(failed.count(), 0);
    ASSERT_EQ(session_.session().takes.size(), 1u);
    EXPECT_EQ(session_.session().takes[0].state, TakeState::kComplete);
    const Take take = recordedTake();
    EXPECT_EQ(take.suitIds(), (std::vector<int>{1, 2}));
    const auto subjects = take.subjects();
    ASSERT_TRUE(subjects);
    ASSERT_EQ(subjects->size(), 2u);
    EXPECT_EQ(subjects->at(0).name, "Performer 1");
    EXPECT_EQ(subjects->at(1).name, "Performer 2");
    for (const int suit : {1, 2}) {
        EXPECT_GE(take.sampleCount(suit).value(), 150'000);
        EXPECT_TRUE(take.calibrationInForce(suit)) << "what was known of each";
    }
    EXPECT_EQ(take.meta().at("box_serial"), "NB-000001");
    EXPECT_EQ(take.meta().at("x_box_serial_2"), "NB-000002");
    EXPECT_EQ(take.meta().at("performer"), "Performer 1");
    EXPECT_EQ(take.markers()->back().label, "here");
    EXPECT_EQ(several.count(), first().suit.canMoveBody() && second().suit.canMoveBody() ? 1 : 0);
    EXPECT_TRUE(looks(first()) && looks(second()));
    ASSERT_TRUE(recordFor(0.3)) << "and once more";
    suits_->stopRecording();
    ASSERT_TRUE(waitFor([&] { return ended.count() == 2; }));
}

TEST_F(LiveSuitsTest, ABoxThatIsLostEndsNothingAndIsNamed) {
    openSession();
    ASSERT_TRUE(connectBoth());
    QSignalSpy ended(suits_.get(), &LiveSuits::recordingEnded), warned(suits_.get(), &LiveSuits::warned);
    ASSERT_TRUE(recordFor(0.5));
    const double lost_at_s = second().suit.recordedSeconds();
    bob_.reset();
    ASSERT_TRUE(waitFor([&] { return second().suit.status()->link == LinkState::kLost; }));
    ASSERT_TRUE(waitFor([&] { return first().suit.recordedSeconds() > lost_at_s + 1.5; }));
    EXPECT_EQ(suits_->phase(), SuitsPhase::kRecording);
    EXPECT_EQ(ended.count(), 0);
    suits_->stopRecording();
    ASSERT_TRUE(waitFor([&] { return ended.count() == 1; }));
    EXPECT_EQ(ended[0][1].toString(), "") << "the operator ended it";
    EXPECT_EQ(session_.session().takes.at(0).state, TakeState::kComplete);
    const bool named = std::ranges::any_of(warned, [](const QList<QVariant>& said) {
        return said[0].toString().contains("Performer 2 (NB-000002) was lost after");
    });
    EXPECT_TRUE(named);
    const Take take = recordedTake();
    EXPECT_GE(take.sampleCount(1).value(), 225'000);
    EXPECT_EQ(take.subjects()->size(), 2u);
}

/// What endOfTake() makes of reports of two boxes, one of which was cut off and came back.
TEST_F(LiveSuitsTest, ABoxThatIsCutOffAndComesBackIsNoTroubleOfTheTake) {
    openSession();
    ASSERT_TRUE(connectBoth());
    QSignalSpy ended(suits_.get(), &LiveSuits::recordingEnded);
    ASSERT_TRUE(recordFor(0.5));
    bob_->cut();
    ASSERT_TRUE(waitFor([&] { return second().suit.status()->reconnections == 1; }));
    const double then_s = second().suit.recordedSeconds();
    ASSERT_TRUE(waitFor([&] { return second().suit.recordedSeconds() > then_s + 0.5; })) << "it goes on";
    EXPECT_EQ(ended.count(), 0);
    suits_->stopRecording();
    ASSERT_TRUE(waitFor([&] { return ended.count() == 1; }));
    EXPECT_EQ(ended[0][1].toString(), "");
    ASSERT_EQ(session_.session().takes.size(), 1u);
    EXPECT_EQ(session_.session().takes[0].state, TakeState::kComplete);
    EXPECT_GE(recordedTake().sampleCount(2).value(), 150'000);
}

/// The same where one is cut by its power, and then the other: nobody has stopped the take.
TEST_F(LiveSuitsTest, ATakeWhoseBoxesHaveAllRestartedEndsByItselfAndSaysWhy) {
    openSession();
    ASSERT_TRUE(connectBoth());
    QSignalSpy ended(suits_.get(), &LiveSuits::recordingEnded);
    ASSERT_TRUE(recordFor(0.5));
    bob_->restart();
    ASSERT_TRUE(waitFor([&] { return !second().suit.status()->stream_is_open; }));
    const double then_s = first().suit.recordedSeconds();
    ASSERT_TRUE(waitFor([&] { return first().suit.recordedSeconds() > then_s + 0.5; }));
    EXPECT_EQ(suits_->phase(), SuitsPhase::kRecording);
    EXPECT_EQ(ended.count(), 0);
    ann_->restart();
    ASSERT_TRUE(waitFor([&] { return ended.count() == 1; }));
    const QString trouble = ended[0][1].toString();
    EXPECT_NE(trouble, "");
    EXPECT_FALSE(trouble.contains("the take was removed")) << trouble.toStdString();
    ASSERT_EQ(session_.session().takes.size(), 1u);
    EXPECT_EQ(session_.session().takes[0].state, TakeState::kComplete);
    for (const int suit : {1, 2})
        EXPECT_GE(recordedTake().sampleCount(suit).value(), 75'000);
}

TEST_F(LiveSuitsTest, TheRateThatIsMeasuredIsOfAllBoxesOfATake) {
    openSession();
    bob_ = std::make_unique<TestBox>(
        TestBox::Options{.loops = true, .serial = "NB-000002", .drive_hz = 48000, .fixed = true});
    ASSERT_TRUE(connectBoth());
    ASSERT_TRUE(recordFor(0.2));
    ASSERT_TRUE(waitFor([&] { return second().check.bytesPerSecond().has_value(); }))
        << "of a room, of which nothing is processed while it is recorded";
    ASSERT_TRUE(waitFor([&] { return suits_->measuredBytesPerSecond().has_value(); }));
    EXPECT_GT(*first().check.bytesPerSecond(), 0);
    EXPECT_GT(*second().check.bytesPerSecond(), 0);
    EXPECT_EQ(*suits_->measuredBytesPerSecond(),
              *first().check.bytesPerSecond() + *second().check.bytesPerSecond());
    QSignalSpy ended(suits_.get(), &LiveSuits::recordingEnded);
    suits_->stopRecording();
    ASSERT_TRUE(waitFor([&] { return ended.count() == 1; }));
}

TEST_F(LiveSuitsTest, TheRateDoesNotJumpWhenATakeEnds) {
    openSession();
    LiveSuit& suit = suits_->current().suit;
    KnownWearing known = wearingOfTinyTake();
    known.rest_s = 0;
    suit.connectTo(QString::fromStdString(ann_->address()), known);
    ASSERT_TRUE(waitFor([&] { return suit.reachedSample() > 600'000; }));
    QSignalSpy ended(&suit, &LiveSuit::recordingEnded);
    ASSERT_EQ(suit.record({"walk", {}, 0, 0.1}), "");
    ASSERT_TRUE(waitFor([&] { return suit.recordedSeconds() >= 1.2; }));
    suit.stopRecording();
    double highest = 0;
    const auto isMeasured = [&] {
        highest = std::max(highest, suits_->current().check.bytesPerSecond().value_or(0));
        return ended.count() == 1 && highest > 0;
    };
    QElapsedTimer clock;
    clock.start();
    ASSERT_TRUE(waitFor([&] { return isMeasured() && clock.elapsed() > 3000; }));
    EXPECT_LT(highest, 2 * 2.0 * 2 * 150'000) << "the stream is seconds ahead of the take";
}

TEST_F(LiveSuitsTest, AnchorsAreRecordedAsTheRoom) {
    openSession();
    bob_ = std::make_unique<TestBox>(
        TestBox::Options{.loops = true, .serial = "NB-000002", .drive_hz = 48000, .fixed = true});
    suits_->current().suit.connectTo(QString::fromStdString(ann_->address()), wearingOfTinyTake());
    ASSERT_TRUE(looks(suits_->current()));
    suits_->add(QString::fromStdString(bob_->address()), {wearingOfTinyTake().calibration, {}, 0});
    ASSERT_TRUE(looks(suits_->current()));
    EXPECT_EQ(suits_->nameOf(second()), "Room");
    EXPECT_EQ(session_.session().performers.size(), 1u) << "nobody wears it";
    QSignalSpy ended(suits_.get(), &LiveSuits::recordingEnded);
    ASSERT_TRUE(recordFor(0.5));
    suits_->stopRecording();
    ASSERT_TRUE(waitFor([&] { return ended.count() == 1; }));
    const auto subjects = recordedTake().subjects();
    ASSERT_TRUE(subjects);
    ASSERT_EQ(subjects->size(), 2u);
    EXPECT_FALSE(subjects->at(0).room);
    EXPECT_TRUE(subjects->at(1).room);
    EXPECT_TRUE(recordedTake().calibrationInForce(2)) << "its sources sound late by what it says";
}

TEST_F(LiveSuitsTest, ASurveyBeginsInTheRestPoseThatItAsksForAndIsNotToBeProcessed) {
    openSession();
    ASSERT_TRUE(connectBoth());
    QSignalSpy several(suits_.get(), &LiveSuits::takeOfSeveral),
        ended(suits_.get(), &LiveSuits::recordingEnded);
    ASSERT_EQ(suits_->record({.base_name = "room", .rest_s = 1.5, .is_survey = true}), "");
    ASSERT_TRUE(waitFor([&] { return suits_->phase() == SuitsPhase::kRecording; }));
    EXPECT_TRUE(suits_->isSurvey());
    ASSERT_TRUE(waitFor([&] { return suits_->recordedSeconds() > 0.3; }));
    suits_->stopRecording();
    ASSERT_TRUE(waitFor([&] { return ended.count() == 1; }));
    EXPECT_TRUE(suits_->isSurvey()) << "until the next one begins";
    EXPECT_EQ(several.count(), 0);
    const auto rest = recordedTake().restInterval(1);
    ASSERT_TRUE(rest && *rest);
    EXPECT_GE((*rest)->last, 224'999) << "1.5 s at 150 kHz";
    ASSERT_TRUE(waitFor([&] { return looks(first()) && looks(second()); }));
    ASSERT_TRUE(recordFor(0.3));
    EXPECT_FALSE(suits_->isSurvey());
    suits_->stopRecording();
    ASSERT_TRUE(waitFor([&] { return ended.count() == 2; }));
}

TEST_F(LiveSuitsTest, SuitsThatCannotBeToldApartAreRefusedInWords) {
    openSession();
    bob_ = makeBox("NB-000002", 40000);
    ASSERT_TRUE(connectBoth());
    ASSERT_TRUE(suits_->whyNotTogether());
    const QString carrier = suits_->record({"duo", {}, 0, 0});
    EXPECT_TRUE(carrier.contains("Performer 1 (NB-000001) and Performer 2 (NB-000002) both sound at 40 kHz"))
        << carrier.toStdString();
    EXPECT_TRUE(carrier.contains("another carrier"));
    EXPECT_TRUE(carrier.contains("in its firmware")) << carrier.toStdString();
    second().suit.disconnectSuit();
    EXPECT_FALSE(suits_->whyNotTogether());
    bob_ = makeBox("NB-000001", 48000);
    suits_->add(QString::fromStdString(bob_->address()), wearingOfTinyTake());
    ASSERT_TRUE(looks(suits_->current()));
    const QString twice = suits_->record({"duo", {}, 0, 0});
    EXPECT_TRUE(twice.contains("are the same driver box, NB-000001")) << twice.toStdString();
    EXPECT_EQ(suits_->phase(), SuitsPhase::kLooking);
    EXPECT_TRUE(session_.session().takes.empty());
}

TEST_F(LiveSuitsTest, OneThatDoesNotBeginLeavesNoTakeAndTheOthersLookOn) {
    openSession();
    ASSERT_TRUE(connectBoth());
    QSignalSpy failed(suits_.get(), &LiveSuits::failed);
    bob_->freeze(true);  // its link seems to hold
    EXPECT_EQ(suits_->record({"duo", {}, 0, 0}), "");
    ASSERT_TRUE(waitFor([&] { return failed.count() > 0; }));
    EXPECT_FALSE(suits_->isTakeOpen());
    session_.refresh(QString::fromStdString((session_.session().takesFolder() / "duo_001.noctule").string()));
    EXPECT_TRUE(session_.session().takes.empty());
    EXPECT_TRUE(looks(first()));
}

TEST_F(LiveSuitsTest, LeavingEndsTheTakeIntactFirst) {
    openSession();
    ASSERT_TRUE(connectBoth());
    QSignalSpy ended(suits_.get(), &LiveSuits::recordingEnded);
    ASSERT_TRUE(recordFor(0.5));
    second().suit.disconnectSuit();
    ASSERT_TRUE(waitFor([&] { return ended.count() == 1; }));
    EXPECT_EQ(suits_->connected().size(), 1u);
    EXPECT_EQ(session_.session().takes.at(0).state, TakeState::kComplete);
}

TEST_F(LiveSuitsTest, ACalibrationOfTheSessionIsThatOfTheFirstUnlessItNamesTheSuit) {
    openSession();
    Calibration of_ann = *wearingOfTinyTake().calibration;
    of_ann.created_utc = "2026-02-02T00:00:00Z";
    const std::string file = (session_.session().calibrationFolder() / "ann.json").string();
    ASSERT_TRUE(writeFileAtomically(file, toJson(of_ann).dump(), false));
    session_.setCalibration("ann.json", "test");
    ASSERT_TRUE(connectBoth());
    EXPECT_TRUE(waitFor([&] { return first().suit.calibration()->created_utc == of_ann.created_utc; }));
    EXPECT_NE(second().suit.calibration()->created_utc, of_ann.created_utc) << "her own";
    second().calibrations.use("ann.json", "test");
    EXPECT_EQ(session_.session().suit_calibrations.at("NB-000002"), "ann.json");
    EXPECT_EQ(second().suit.calibration()->created_utc, of_ann.created_utc);
    EXPECT_EQ(session_.session().calibration, "ann.json");
    session_.undoStack().undo();
    EXPECT_TRUE(session_.session().suit_calibrations.empty());
    EXPECT_NE(second().suit.calibration()->created_utc, of_ann.created_utc);
}

}  // namespace
}  // namespace noctule::ui
