// SPDX-License-Identifier: Apache-2.0
// The survey of a room on step Calibrate: from a take with anchors to their places in force, and back.
// NOCTULE_TEST_PICTURES names a folder for a picture of it.
#include "ui/wizards/room_page.h"

#include <QUndoStack>

#include "core/processing/room_evidence.h"
#include "core/recording/database.h"
#include "core/suit/placed_suit.h"
#include "tests/ui/wizards/room_flow.h"
#include "ui/wizards/room_drawing.h"
#include "ui/wizards/task_card.h"

namespace noctule::ui {
namespace {

using namespace test;

class RoomPageTest : public RoomFlow {
protected:
    void open(const QString& take) {
        studio_->session().importTakes({take});
        ASSERT_TRUE(waitLong([this] { return studio_->take().isOpen() && studio_->jobs().idle(); }));
    }
    void survey() {
        QTest::mouseClick(page_->roomCard()->button(), Qt::LeftButton);
        ASSERT_TRUE(waitLong([this] { return run().phase() != RoomRun::Phase::kSurveying; }));
    }
    Vector3d sourceInTake(int source) const {
        Take take = Take::open(studio_->take().path().toStdString()).value();
        const auto room = roomOfTake(take);
        return placedSuit(room->suit, room->calibration)
            .sources[static_cast<size_t>(source)]
            .p_segment_source_m;
    }
};

/// A recorder that goes on while the take is read.
class RecordsOn : public ProgressSink {
public:
    static constexpr int kMost = 3;

    explicit RecordsOn(const Database& take) : take_(take) {}

    void progress(double, const std::string&) override {
        if (written_ < kMost)
            written_ += take_
                            .execute(
                                "INSERT INTO pulse(suit, sample, source) SELECT suit, sample + 1000, 0 "
                                "FROM pulse WHERE suit=2 ORDER BY sample DESC LIMIT 1")
                            .ok();
    }
    int written() const { return written_; }

private:
    const Database& take_;
    int written_ = 0;
};

int pulsesSent(const SurveyedTake& take) {
    int sent = 0;
    for (const room_survey::SurveyedAnchor& anchor : take.survey.anchors)
        sent += anchor.sent;
    return sent;
}

TEST_F(RoomPageTest, WithoutAnchorsThereIsNoCard) {
    EXPECT_TRUE(page_->roomCard()->isHidden());
    page_->openRoom();
    EXPECT_EQ(run().phase(), RoomRun::Phase::kNoTake);
    EXPECT_TRUE(says(page_->room(), "walk slowly past"));
    EXPECT_TRUE(says(page_->room(), "Connect a suit and a box of anchors"));
    EXPECT_TRUE(says(page_->room(), "Or open a take with anchors"));
    EXPECT_TRUE(page_->room().useButton()->isHidden());
    EXPECT_FALSE(page_->room().walkButton()->isEnabled());
    EXPECT_EQ(page_->room().walkButton()->toolTip(), "No box of anchors is connected. Connect one first.");
    run().survey();
    EXPECT_EQ(run().phase(), RoomRun::Phase::kNoTake);
}

TEST_F(RoomPageTest, ATakeIsSurveyedUsedAndTakenBack) {
    open(makeTake("walk_001", "16"));
    ASSERT_FALSE(page_->roomCard()->isHidden());
    survey();
    ASSERT_EQ(run().phase(), RoomRun::Phase::kResult) << run().error().text();
    page_->rightDock()->resize(364, 760);
    page_->rightDock()->show();
    const room_survey::RoomSurvey& found = run().result().survey;
    ASSERT_EQ(found.anchors.size(), 4u);
    EXPECT_TRUE(says(*page_->rightDock(), "Anchor 4"));
    EXPECT_TRUE(says(*page_->rightDock(), "ceiling_4"));
    EXPECT_TRUE(says(page_->room(), "where Ada stood"));
    for (const RoomDrawing* drawing : page_->room().findChildren<RoomDrawing*>())
        EXPECT_EQ(drawing->accessibleName().count("anchor "), 4) << drawing->accessibleName().toStdString();
    if (const QString folder = qEnvironmentVariable("NOCTULE_TEST_PICTURES"); !folder.isEmpty()) {
        QTest::qWait(300);
        page_->room().grab().save(folder + "/room.png");
        page_->room().side()->grab().save(folder + "/room-side.png");
    }

    const Vector3d before = sourceInTake(0);
    const Vector3d surveyed = run().result().result.room->sources[0].p_segment_source_m;
    ASSERT_GT((surveyed - before).norm(), 0.002) << "the survey is not what the file says";
    QTest::mouseClick(page_->room().useButton(), Qt::LeftButton);
    ASSERT_TRUE(waitLong([this] { return run().isInUse() && studio_->jobs().idle(); }));
    EXPECT_LT((sourceInTake(0) - surveyed).norm(), 1e-6);
    EXPECT_TRUE(page_->room().useButton()->isHidden());
    EXPECT_FALSE(page_->room().processButton()->isHidden());
    EXPECT_EQ(run().phase(), RoomRun::Phase::kResult) << "it stays when the take is read again";
    QSignalSpy steps(studio_.get(), &Studio::stepRequested);
    QTest::mouseClick(page_->room().processButton(), Qt::LeftButton);
    ASSERT_EQ(steps.size(), 1);
    EXPECT_EQ(steps.front().front().value<Step>(), Step::kReview);
    for (Job* job : studio_->jobs().all())
        job->cancel();
    ASSERT_TRUE(waitLong([this] { return studio_->jobs().idle(); }));

    studio_->session().undoStack().undo();
    ASSERT_TRUE(waitLong([this] { return !run().isInUse() && studio_->jobs().idle(); }));
    EXPECT_LT((sourceInTake(0) - before).norm(), 1e-6);
    EXPECT_FALSE(page_->room().useButton()->isHidden());
    QTest::mouseClick(page_->room().surveyButton(), Qt::LeftButton);
    EXPECT_EQ(run().phase(), RoomRun::Phase::kSurveying);
    ASSERT_TRUE(waitLong([this] { return run().phase() == RoomRun::Phase::kResult; }));

    const QString file = folder_.filePath("room.json");
    EXPECT_TRUE(run().save(file).isEmpty());
    std::ifstream in(file.toStdString());
    const auto read = suitFromJson(nlohmann::json::parse(in), "room.json");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_LT((read->sources[0].p_segment_source_m - surveyed).norm(), 1e-6);
    EXPECT_FALSE(run().save(folder_.filePath("no/such/folder/room.json")).isEmpty());
}

TEST_F(RoomPageTest, AnAnchorIsLeftOutAndTakenBackIn) {
    open(makeTake("walk_001", "16"));
    survey();
    ASSERT_EQ(run().phase(), RoomRun::Phase::kResult) << run().error().text();
    const auto button = [this](const QString& words) {
        Button* found = nullptr;
        for (Button* one : page_->room().side()->findChildren<Button*>())
            if (one->text() == words)
                found = one;
        return found;
    };
    ASSERT_NE(button("Use without anchor 2"), nullptr);
    EXPECT_TRUE(button("Use without anchor 2")->isEnabled());
    button("Use without anchor 2")->click();
    ASSERT_TRUE(waitLong([&] { return button("Use anchor 2 again") != nullptr; }));
    EXPECT_TRUE(run().result().survey.anchors[1].left_out);
    EXPECT_EQ(run().result().result.room->findSource("ceiling_2"), -1);
    EXPECT_EQ(run().result().result.room->sources.size(), 3u);
    EXPECT_TRUE(says(*page_->room().side(), "left out"));
    EXPECT_TRUE(says(*page_->room().side(), "Without anchor 2: the file lacks it"));
    EXPECT_TRUE(says(*page_->room().side(), "The other places stay as they were found with it"));
    EXPECT_EQ(page_->room().walkButton()->text(), "Walk again");
    EXPECT_FALSE(page_->room().walkButton()->isEnabled());
    EXPECT_TRUE(says(*page_->room().side(), "No box of anchors is connected")) << "why it is grey";
    for (const RoomDrawing* drawing : page_->room().findChildren<RoomDrawing*>())
        EXPECT_TRUE(drawing->accessibleName().contains("anchor 2, left out, at"));
    ASSERT_NE(button("Use without anchor 1"), nullptr);
    EXPECT_FALSE(button("Use without anchor 1")->isEnabled());
    EXPECT_TRUE(button("Use without anchor 1")->toolTip().contains("three anchors"));
    const Vector3d before = sourceInTake(1),
                   surveyed = run().result().result.room->sources[0].p_segment_source_m;
    page_->room().useButton()->click();
    ASSERT_TRUE(waitLong([this] { return run().isInUse() && studio_->jobs().idle(); }));
    EXPECT_LT((sourceInTake(0) - surveyed).norm(), 1e-6);
    EXPECT_LT((sourceInTake(1) - before).norm(), 1e-6) << "it stays as it was";

    ASSERT_NE(button("Use anchor 2 again"), nullptr);
    button("Use anchor 2 again")->click();
    ASSERT_TRUE(waitLong([&] { return button("Use without anchor 2") != nullptr; }));
    EXPECT_EQ(run().result().result.room->sources.size(), 4u);
    EXPECT_FALSE(run().isInUse()) << "its place is not in the take";
}

TEST(RoomErrors, NameTheTakeAndNotItsPlace) {
    const std::string path = "/stage/here/takes/room_001.noctule";
    const Error told =
        namingTake({ErrorKind::kUnusable, path + ": too little is heard", "Open " + path}, path);
    EXPECT_EQ(told.message, "room_001: too little is heard");
    EXPECT_EQ(told.remedy, "Open room_001");
}

TEST_F(RoomPageTest, WhatCannotBeSurveyedIsSaidInPlace) {
    open(makeTake("short_001", "3.2"));  // the rest pose and hardly more
    survey();
    ASSERT_EQ(run().phase(), RoomRun::Phase::kResult) << run().error().text();
    EXPECT_TRUE(says(page_->room(), "The room cannot be used yet"));
    EXPECT_TRUE(says(page_->room(), "Anchor ceiling_1 is weak"));
    EXPECT_TRUE(says(page_->room(), "Walk slowly past it"));
    EXPECT_EQ(page_->room().useButton()->text(), "Use these places anyway");
    EXPECT_FALSE(run().isInUse());
}

TEST_F(RoomPageTest, ATakeThatIsRecordedIsSurveyedAsItWasAtOneMoment) {
    RoomRequest request;
    request.take_path = makeTake("walk_001", "8").toStdString();
    auto recorder = Database::open(request.take_path, Access::kReadWrite);
    ASSERT_TRUE(recorder) << recorder.error().text();
    ASSERT_TRUE(recorder->execute("PRAGMA journal_mode=WAL"));
    const auto before = calibrateRoom(request, {});
    ASSERT_TRUE(before) << before.error().text();
    RecordsOn recording(*recorder);
    const auto meanwhile = calibrateRoom(request, {&recording, nullptr});
    ASSERT_TRUE(meanwhile) << meanwhile.error().text();
    EXPECT_EQ(recording.written(), RecordsOn::kMost);
    EXPECT_EQ(pulsesSent(*meanwhile), pulsesSent(*before));
    const auto after = calibrateRoom(request, {});
    ASSERT_TRUE(after) << after.error().text();
    EXPECT_EQ(pulsesSent(*after), pulsesSent(*before) + RecordsOn::kMost);
}

}  // namespace
}  // namespace noctule::ui
