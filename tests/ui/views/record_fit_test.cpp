// SPDX-License-Identifier: Apache-2.0
// What step Record says of the calibration while it records, against a box that plays the tiny take over TCP.
#include "tests/ui/views/record_fixture.h"
#include "ui/scene/scene_canvas.h"
#include "ui/scene/scene_view.h"
#include "ui/views/record/record_problems.h"
#include "ui/views/record/record_readiness.h"
#include "ui/widgets/button.h"
#include "ui/widgets/problem_card.h"

namespace noctule::ui {
namespace {

using noctule::test::TestBox;

class RecordFit : public test::RecordFixture {
protected:
    void SetUp() override {
        RecordFixture::SetUp();
        run().setOpensReview(false);
        openSession();
    }

    /// Until the suit has been judged while it is recorded.
    void record(const TestBox& box, const Calibration& calibration) {
        studio_->suit().connectTo(QString::fromStdString(box.address()),
                                  {calibration, tiny_.actorInForce()->value, 0.5});
        ASSERT_TRUE(recordFor(1.8));
    }
    void stop() {
        run().stop();
        ASSERT_TRUE(waitFor([this] { return session().takes.size() == 1; }));
    }
    bool says(const QString& verdict) {
        return waitFor([&] { return page_->readiness().verdict() == verdict; });
    }
    QStringList titles() {
        QStringList titles;
        for (const ProblemCard* card : page_->readiness().problems().cards())
            titles += card->title();
        return titles;
    }
    bool offers(const QString& action) {
        for (const ProblemCard* card : page_->readiness().problems().cards())
            for (const Button* button : card->findChildren<Button*>())
                if (button->text() == action && !button->isHidden())
                    return true;
        return false;
    }

    const QString kMoved = "Something has moved since the calibration";
    const Take tiny_ = std::move(Take::open(noctule::test::kTinyTake).value());
};

TEST_F(RecordFit, PartOfACalibrationIsNotRecordingWell) {
    TestBox box({.loops = true});
    Calibration calibration = nominalCalibration(tiny_.suit().value());
    for (BoardCalibration& board : calibration.boards)
        board.made["accelerometers"] = {"2026-01-01T00:00:00Z", "good"};
    record(box, calibration);
    const QString lack = "the source offsets, the gyroscopes and the rest pose";
    EXPECT_TRUE(says("Recording, without calibration of " + lack))
        << page_->readiness().verdict().toStdString();
    EXPECT_TRUE(titles().contains("Without calibration of " + lack)) << titles().join(", ").toStdString();
    EXPECT_TRUE(offers("Calibrate"));
    EXPECT_EQ(page_->readiness().problems().worst(), Tone::kWarn);
    EXPECT_FALSE(studio_->suit().canMoveBody());
    EXPECT_TRUE(studio_->suit().frame());
    const QString seen = page_->center().scene().descriptionInWords();
    const QString missing = SceneCanvas::missing();  // without OpenGL that is said
    EXPECT_TRUE(seen.startsWith(missing.isEmpty() ? "The live body needs a calibration." : missing))
        << seen.toStdString();
    stop();
}

TEST_F(RecordFit, AFailedCheckIsNotRecordingWell) {
    TestBox box({.loops = true});
    const Calibration calibration = tiny_.calibrationInForce()->value;
    record(box, calibration);
    studio_->setChecked(CheckedSuit{QDateTime::currentDateTime(), false});
    EXPECT_FALSE(titles().contains(kMoved)) << "what came with the suit is exact: nothing can have moved";
    studio_->suit().setCalibration(calibration);
    EXPECT_TRUE(waitFor([this] { return titles().contains(kMoved); })) << titles().join(", ").toStdString();
    // A box that finds no core is a problem, too, which comes first.
    const QString verdict = page_->readiness().verdict();
    EXPECT_TRUE(verdict == "Recording, though something has moved" || verdict == "Recording, with problems")
        << verdict.toStdString();
    EXPECT_GE(page_->readiness().problems().worst(), Tone::kWarn);
    stop();
}

}  // namespace
}  // namespace noctule::ui
