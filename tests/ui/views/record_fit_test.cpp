// SPDX-License-Identifier: Apache-2.0
// What step Record says of the calibration while it records, against a box that plays the tiny take over TCP.
#include <gtest/gtest.h>

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

#include "core/recording/take.h"
#include "tests/devices/support/test_box.h"
#include "tests/ui/support/wait.h"
#include "ui/style/theme.h"
#include "ui/views/record/record_page.h"
#include "ui/views/record/record_problems.h"
#include "ui/views/record/record_readiness.h"
#include "ui/widgets/button.h"
#include "ui/widgets/problem_card.h"

namespace noctule::ui {
namespace {

using noctule::test::TestBox;

class RecordFit : public testing::Test {
protected:
    void SetUp() override {
        Theme::install(*qApp);
        QSettings().clear();
        QSettings().setValue("folders/sessions", folder_.filePath("sessions"));
        QSettings().setValue("folders/suits", folder_.filePath("suits"));
        QSettings().setValue("record/countdown_s", 0);
        QSettings().setValue("record/tones", false);
        studio_ = std::make_unique<Studio>(
            StudioParts{"test", [] { return std::string("2026-01-01T00:00:00Z"); }, {}, {}});
        page_ = std::make_unique<RecordPage>(*studio_);
        page_->resize(1000, 700);
        page_->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(page_.get()));
        page_->enter();
        page_->run().setOpensReview(false);
        ASSERT_TRUE(studio_->session().create(folder_.filePath("here"), "here"));
    }
    void TearDown() override {
        page_.reset();
        studio_.reset();
    }

    /// Until the suit has been judged while it is recorded.
    void record(const TestBox& box, const Calibration& calibration) {
        studio_->suit().connectTo(QString::fromStdString(box.address()),
                                  {calibration, tiny_.actorInForce()->value, 0.5});
        ASSERT_TRUE(waitFor([this] { return page_->run().state() == RecordRun::State::kReady; }));
        QTest::keyClick(page_.get(), Qt::Key_Space);
        ASSERT_TRUE(waitFor([this] { return studio_->suit().recordedSeconds() >= 1.8; }));
    }
    void stop() {
        page_->run().stop();
        ASSERT_TRUE(waitFor([this] { return studio_->session().session().takes.size() == 1; }));
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

    QTemporaryDir folder_;
    const Take tiny_ = std::move(Take::open(noctule::test::kTinyTake).value());
    std::unique_ptr<Studio> studio_;
    std::unique_ptr<RecordPage> page_;
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
    stop();
}

TEST_F(RecordFit, AFailedCheckIsNotRecordingWell) {
    TestBox box({.loops = true});
    record(box, tiny_.calibrationInForce()->value);
    studio_->setChecked(CheckedSuit{QDateTime::currentDateTime(), false});
    // A box that finds no core is a problem, too, which comes first.
    EXPECT_TRUE(waitFor([this] {
        const QString verdict = page_->readiness().verdict();
        return verdict == "Recording, though something has moved" || verdict == "Recording, with problems";
    })) << page_->readiness().verdict().toStdString();
    EXPECT_GE(page_->readiness().problems().worst(), Tone::kWarn);
    stop();
}

}  // namespace
}  // namespace noctule::ui
