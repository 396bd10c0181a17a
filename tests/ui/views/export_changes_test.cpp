// SPDX-License-Identifier: Apache-2.0
// After an export, whatever its files depend on brings "Write" back; and which result of a take goes out.
#include <QComboBox>

#include "core/recording/take_edit.h"
#include "tests/ui/views/export_page_fixture.h"

namespace noctule::ui {
namespace {

class ExportChangesTest : public test::ExportPageTest {
protected:
    void write() {
        ExportPageTest::write();
        ASSERT_TRUE(waitFor([this] { return !offersToWrite(); })) << "the files are there";
    }
    bool offersToWrite() const { return page_->writeButton()->isVisible(); }
    void processAgain(const QString& name) {
        ProcessRequest gyroscopes_only;
        gyroscopes_only.take_path = takePath(name).toStdString();
        gyroscopes_only.tracker.sensors = {false, true, false};
        studio_->process(gyroscopes_only);
        ASSERT_TRUE(
            waitFor([this] { return studio_->take().overview()->runs.size() == 2 && jobsAreDone(); }));
    }
    std::string runOf(size_t job) const { return page_->plan().value().at(job).request.run; }
};

TEST_F(ExportChangesTest, AnotherInOrOutBringsWriteBack) {
    write();
    studio_->session().setTakeRange(0, 1, 2);
    EXPECT_TRUE(offersToWrite());
    studio_->session().setTakeRange(0, 0, 0);
    EXPECT_FALSE(offersToWrite()) << "as it was written";
}

TEST_F(ExportChangesTest, EditedContactsBringWriteBack) {
    write();
    ASSERT_TRUE(waitFor([this] { return studio_->take().contacts() != nullptr; }));
    studio_->contacts().put({"LeftFoot", -1}, {0.5, 1, 0, true});
    EXPECT_TRUE(waitFor([this] { return offersToWrite(); }));
}

TEST_F(ExportChangesTest, AnotherBodyBringsWriteBack) {
    SessionBody body;
    body.mesh = writtenFigure(JointNames::kHumanIk).toStdString();
    studio_->session().setBody(body);
    page_->choosePreset("web");
    page_->form().body->setCurrentIndex(2);
    ASSERT_TRUE(waitFor([this] { return studio_->shownBody().worn() && jobsAreDone(); }));
    write();
    body.blending = Blending::kDualQuaternion;
    studio_->session().setBody(body);
    EXPECT_TRUE(offersToWrite()) << "another blending";
    body.blending = Blending::kLinear;
    studio_->session().setBody(body);
    EXPECT_FALSE(offersToWrite());
    body.mesh = writtenFigure(JointNames::kOwn).toStdString();
    studio_->session().setBody(SessionBody{});
    studio_->session().setBody(body);
    ASSERT_TRUE(waitFor([this] { return studio_->shownBody().worn() && jobsAreDone(); }));
    EXPECT_TRUE(offersToWrite()) << "another mesh";
}

TEST_F(ExportChangesTest, AnotherTimeBringsWriteBackForAPictureOnly) {
    studio_->time().setTime(1);
    page_->choosePreset("picture");
    write();
    studio_->time().setTime(2);
    EXPECT_TRUE(offersToWrite());
    studio_->time().setTime(1);
    EXPECT_FALSE(offersToWrite());
    page_->choosePreset("bvh");
    write();
    studio_->time().setTime(2);
    EXPECT_FALSE(offersToWrite()) << "a motion has no such time";
}

TEST_F(ExportChangesTest, TheResultThatReviewShowedGoesOutOfATakeThatIsNotOpen) {
    const std::string first = studio_->take().overview()->runs[0].run.name;
    addTake("swing_002");
    openTake("swing_001");
    processAgain("swing_001");
    studio_->take().setShownRun(0);
    openTake("swing_002");
    page_->form().setTakes({"swing_001", "swing_002"});
    ASSERT_EQ(page_->plan().value().size(), 2U);
    EXPECT_EQ(runOf(0), first) << "not the trial after it";
    openTake("swing_001");
    EXPECT_EQ(studio_->take().shownRun(), 0) << "as it was left";

    openTake("swing_002");
    {
        auto take = Take::open(takePath("swing_001").toStdString(), Access::kReadWrite);
        ASSERT_TRUE(take);
        const auto runs = take->derivedRuns();
        ASSERT_TRUE(runs);
        auto edit = TakeEdit::begin(*take);
        ASSERT_TRUE(edit);
        for (const DerivedRun& run : *runs)
            if (run.kind == "pose" && run.name == first) {
                ASSERT_TRUE(edit->dropRun(run.run));
            }
        ASSERT_TRUE(edit->commit());
    }
    studio_->session().refresh(takePath("swing_001"));
    EXPECT_EQ(runOf(0), "") << "it was deleted: the last one";
    openTake("swing_001");
    ASSERT_EQ(studio_->take().overview()->runs.size(), 1U);
    EXPECT_EQ(studio_->take().shownRun(), 0);
    EXPECT_EQ(studio_->take().numberOf(0), "2") << "it keeps its number";
}

TEST_F(ExportChangesTest, ANewResultOfAClosedTakeIsTheOneThatIsShown) {
    addTake("swing_002");
    openTake("swing_001");
    processAgain("swing_001");
    studio_->take().setShownRun(0);
    openTake("swing_002");
    ProcessRequest again;
    again.take_path = takePath("swing_001").toStdString();
    studio_->process(again);
    ASSERT_TRUE(waitFor([this] { return jobsAreDone(); }));
    openTake("swing_001");
    EXPECT_EQ(studio_->take().shownRun(), 2);
}

}  // namespace
}  // namespace noctule::ui
