// SPDX-License-Identifier: Apache-2.0
// The live survey of a room: two boxes play what a suit and four anchors heard, and the page leads through a
// walk. How good the places become is not asked: a busy machine delays what the boxes send.
#include "ui/wizards/room_walk.h"

#include "core/recording/take.h"
#include "tests/ui/wizards/room_flow.h"
#include "ui/wizards/room_drawing.h"

namespace noctule::ui {
namespace {

using namespace test;

class RoomWalkTest : public RoomFlow {
protected:
    void makeBoxes() {
        tape_ = makeTake("tape_001", "9", "signal");
        suit_ = std::make_unique<RigProgram>(QStringList{"--take", tape_, "--subject", "Ada", "--loop"});
        anchors_ = std::make_unique<RigProgram>(QStringList{"--take", tape_, "--subject", "room", "--loop"});
        ASSERT_TRUE(suit_->isThere() && anchors_->isThere());
    }
    void connectSuit() {
        const Take take = Take::open(tape_.toStdString()).value();
        studio_->suit().connectTo(suit_->address(),
                                  {take.calibrationInForce(1)->value, take.actorInForce(1)->value, 0.5});
        ASSERT_TRUE(looks());
    }
    void connectAnchors() {
        const Take take = Take::open(tape_.toStdString()).value();
        studio_->suits().add(anchors_->address(), {take.calibrationInForce(2)->value, {}, 0});
        ASSERT_TRUE(looks());
        EXPECT_TRUE(studio_->suit().suit().isFixed());
    }
    bool looks() {
        return waitLong([this] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; });
    }
    void connectBoth() {
        makeBoxes();
        connectSuit();
        connectAnchors();
    }
    RoomWalk& walk() { return page_->room().walk(); }
    Button* button() { return page_->room().walkButton(); }
    /// It surveys soon and often, and ends at `most_s`.
    void begin(double most_s) {
        walk().setTimes({.stand_s = 2, .first_s = 3, .every_s = 1, .least_s = 1000, .most_s = most_s});
        page_->openRoom();
        ASSERT_TRUE(waitLong([this] { return button()->isEnabled(); })) << button()->toolTip().toStdString();
        click(button());
        ASSERT_TRUE(walk().isRunning()) << walk().trouble().toStdString();
    }
    bool walksFor(double seconds) {
        return waitLong([&] { return walk().seconds() >= seconds; });
    }
    /// Over, and its take looked at as any take that is open.
    bool isSurveyed() {
        return waitLong([this] {
            const RoomRun::Phase phase = run().phase();
            return !walk().isRunning() && studio_->jobs().idle() &&
                   (phase == RoomRun::Phase::kResult || phase == RoomRun::Phase::kFailed);
        });
    }
    void expectOneTake() {
        const Session& session = studio_->session().session();
        ASSERT_EQ(session.takes.size(), 1u);
        EXPECT_EQ(session.takes[0].name, "room_001");
        EXPECT_EQ(session.takes[0].state, TakeState::kComplete);
        const std::string path = session.pathOf(session.takes[0]).string();
        EXPECT_FALSE(std::filesystem::exists(path + "-wal")) << "a survey still read it";
        const Take take = Take::open(path).value();
        const auto subjects = take.subjects();
        ASSERT_TRUE(subjects);
        ASSERT_EQ(subjects->size(), 2u);
        EXPECT_TRUE(subjects->at(1).room);
        EXPECT_TRUE(take.calibrationInForce(2)) << "of the anchors' sources";
        EXPECT_EQ(take.restInterval(1).value()->first, 0);
        EXPECT_TRUE(take.derivedRuns()->empty()) << "places come first";
    }

    QString tape_;
    std::unique_ptr<RigProgram> suit_, anchors_;
};

TEST_F(RoomWalkTest, TheButtonSaysWhoIsMissing) {
    makeBoxes();
    page_->openRoom();
    EXPECT_FALSE(button()->isEnabled());
    EXPECT_TRUE(button()->toolTip().contains("No box of anchors"));
    connectSuit();
    EXPECT_FALSE(button()->isEnabled());
    EXPECT_TRUE(button()->toolTip().contains("No box of anchors"));
    connectAnchors();
    ASSERT_TRUE(waitLong([this] { return button()->isEnabled(); })) << button()->toolTip().toStdString();
    EXPECT_TRUE(says(page_->room(), "ends by itself when every anchor is good"));
    EXPECT_TRUE(walk().caution().isEmpty());
    studio_->suit().setCalibration({});
    EXPECT_TRUE(walk().caution().contains("sources are not calibrated"));
    studio_->suits().connected().at(0)->suit.setCalibration({});
    EXPECT_TRUE(walk().whyNotBegin().contains("The suit is not calibrated"));
    studio_->suits().connected().at(0)->suit.disconnectSuit();
    ASSERT_TRUE(waitLong([this] { return studio_->suits().connected().size() == 1; }));
    EXPECT_TRUE(walk().whyNotBegin().contains("No suit is connected"));
}

TEST_F(RoomWalkTest, WhatIsRecordedIsSurveyedMeanwhileAndTheTakeIsShownAtTheEnd) {
    connectBoth();
    begin(1000);
    QSignalSpy steps(studio_.get(), &Studio::stepRequested);
    EXPECT_TRUE(waitLong([this] { return says(page_->room(), "Stand still in the rest pose"); }));
    EXPECT_EQ(button()->window()->focusWidget(), button())
        << "the next key ends the walk, and does not leave";
    const auto bottomOf = [this](const QString& words) {
        for (const QLabel* label : page_->room().findChildren<QLabel*>())
            if (label->isVisible() && label->text().contains(words))
                return label->mapTo(&page_->room(), label->rect().bottomLeft()).y();
        return 10'000;
    };
    EXPECT_TRUE(waitLong([&] { return bottomOf("Stand still in the rest pose") < 200; }))
        << "at the top while nothing is drawn";
    ASSERT_TRUE(waitLong([this] { return walk().phase() == RoomWalk::Phase::kWalking; }));
    EXPECT_TRUE(waitLong([this] { return says(page_->room(), "Walk slowly past all 4 anchor"); }));
    EXPECT_TRUE(says(page_->room(), " of 60 s"));
    EXPECT_EQ(button()->text(), "End the walk");
    EXPECT_TRUE(page_->room().surveyButton()->isHidden());
    ASSERT_TRUE(waitLong([this] { return walk().found() || walk().hindrance(); }));
    EXPECT_TRUE(studio_->suits().isTakeOpen()) << "it was surveyed while it was recorded";
    if (walk().found()) {
        EXPECT_EQ(walk().found()->survey.anchors.size(), 4u);
        EXPECT_TRUE(says(*page_->room().side(), "Anchor 4"));
        for (const RoomDrawing* drawing : page_->room().findChildren<RoomDrawing*>())
            EXPECT_FALSE(drawing->isHidden());
    } else {
        EXPECT_TRUE(says(page_->room(), "Nothing is found yet"));
    }
    QTest::qWait(100);  // until the page is laid out
    if (const QString folder = qEnvironmentVariable("NOCTULE_TEST_PICTURES"); !folder.isEmpty())
        page_->grab().save(folder + "/room-walk.png");
    click(button());
    ASSERT_TRUE(isSurveyed());
    EXPECT_TRUE(walk().trouble().isEmpty()) << walk().trouble().toStdString();
    EXPECT_EQ(run().takeName(), "room_001");
    EXPECT_TRUE(says(page_->room(), "Room of room_001"));
    EXPECT_EQ(button()->text(), "Walk and survey");
    EXPECT_EQ(steps.size(), 0) << "nobody is led to Review";
    expectOneTake();
}

TEST_F(RoomWalkTest, ItEndsByItself) {
    connectBoth();
    begin(3);
    ASSERT_TRUE(isSurveyed());
    EXPECT_EQ(run().takeName(), "room_001");
    expectOneTake();
}

TEST_F(RoomWalkTest, LeavingEndsItAndKeepsTheTake) {
    connectBoth();
    begin(1000);
    ASSERT_TRUE(walksFor(2));
    page_->leave();
    EXPECT_EQ(walk().phase(), RoomWalk::Phase::kSaving);
    ASSERT_TRUE(waitLong([this] { return !walk().isRunning() && studio_->jobs().idle(); }));
    EXPECT_FALSE(studio_->take().isOpen()) << "somebody looks at something else";
    expectOneTake();
}

TEST_F(RoomWalkTest, ABoxThatIsLostEndsItAndIsNamed) {
    connectBoth();
    begin(1000);
    ASSERT_TRUE(walksFor(4));
    EXPECT_EQ(anchors_->tell("cut 120"), "ok");
    ASSERT_TRUE(isSurveyed());
    EXPECT_TRUE(walk().trouble().contains("The link to Room broke")) << walk().trouble().toStdString();
    EXPECT_TRUE(says(page_->room(), "The walk ended by itself"));
    expectOneTake();
}

/// No take can be made: the page says so, and still does with another take open.
TEST_F(RoomWalkTest, AWalkThatBroughtNoTakeSaysSoWhateverTakeIsOpen) {
    connectBoth();
    page_->openRoom();
    ASSERT_TRUE(waitLong([this] { return button()->isEnabled(); })) << button()->toolTip().toStdString();
    const QString takes = QString::fromStdString(studio_->session().session().takesFolder().string());
    std::filesystem::remove_all(takes.toStdString());
    std::ofstream(takes.toStdString()) << "in the way";
    click(button());
    ASSERT_TRUE(waitLong([this] { return !walk().isRunning() && studio_->jobs().idle(); }));
    EXPECT_EQ(walk().takeName(), "");
    EXPECT_FALSE(walk().trouble().isEmpty());
    EXPECT_TRUE(says(page_->room(), "The walk brought no take"));
    EXPECT_TRUE(says(page_->room(), "Mend this, then walk once more."));
    std::filesystem::remove(takes.toStdString());
    std::filesystem::create_directories(takes.toStdString());
    studio_->session().importTakes({makeTake("other_001", "4")});
    ASSERT_TRUE(waitLong([this] { return studio_->take().isOpen() && studio_->jobs().idle(); }));
    EXPECT_TRUE(says(page_->room(), "The walk brought no take"));
}

TEST(RoomWalkDecision, EveryAnchorHasToBeGoodAndSomebodyToHaveWalked) {
    room_survey::RoomSurvey survey;
    survey.frame.of_performer = true;
    survey.anchors.resize(3);
    for (room_survey::SurveyedAnchor& anchor : survey.anchors)
        anchor.placed = true, anchor.sigma_m = 0.005;
    EXPECT_TRUE(RoomWalk::isEnough(survey));
    survey.anchors[1].sigma_m = 0.012;
    EXPECT_FALSE(RoomWalk::isEnough(survey));
    EXPECT_EQ(stateSoFar(survey.anchors[1]).words, "nearly");
    EXPECT_EQ(stateOf(survey.anchors[1]).words, "weak") << "once nobody walks any more";
    survey.anchors[1].sigma_m = 0.03;
    EXPECT_EQ(stateSoFar(survey.anchors[1]).words, "weak");
    survey.anchors[1].sigma_m = 0.005;
    survey.anchors[2].moved.emplace();
    EXPECT_FALSE(RoomWalk::isEnough(survey));
    survey.anchors[2].moved.reset();
    survey.frame.of_performer = false;
    EXPECT_FALSE(RoomWalk::isEnough(survey));
}

}  // namespace
}  // namespace noctule::ui
