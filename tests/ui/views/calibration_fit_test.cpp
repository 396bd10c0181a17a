// SPDX-License-Identifier: Apache-2.0
// What Connect says of a calibration that is not usable, old, or older than another session's.
#include <QLabel>

#include "tests/ui/views/record_fixture.h"
#include "ui/views/connect/readiness_panel.h"
#include "ui/views/newer_values.h"
#include "ui/widgets/button.h"
#include "ui/widgets/problem_card.h"

namespace noctule::ui {
namespace {

std::string hoursAgo(int hours) {
    return QDateTime::currentDateTimeUtc().addSecs(-3600 * hours).toString(Qt::ISODate).toStdString();
}

class CalibrationFit : public test::RecordFixture {
protected:
    void SetUp() override {
        RecordFixture::SetUp();
        openSession();
        panel_ = std::make_unique<ReadinessPanel>(*studio_);
        studio_->suit().connectTo(QString::fromStdString(box_.address()));
        ASSERT_TRUE(waitFor([this] { return panel_->verdict() == "Connected"; }));
    }
    void TearDown() override {
        panel_.reset();
        RecordFixture::TearDown();
    }
    /// Every step made an hour ago.
    static Calibration fresh() {
        const Take take = std::move(Take::open(noctule::test::kTinyTake).value());
        Calibration calibration = take.calibrationInForce()->value;
        calibration.created_utc = hoursAgo(1);
        for (SourceCalibration& source : calibration.sources)
            source.made["sources"] = {hoursAgo(1), "good"};
        for (BoardCalibration& board : calibration.boards)
            for (const char* task : {"accelerometers", "gyroscopes", "rest-pose"})
                board.made[task] = {hoursAgo(1), "good"};
        return calibration;
    }
    bool shows(const QString& title) {
        return waitFor([&] { return cardOf(title) != nullptr; });
    }
    const ProblemCard* cardOf(const QString& title) {
        for (const ProblemCard* card : panel_->cards())
            if (card->title() == title)
                return card;
        return nullptr;
    }
    static Button* buttonOf(const QWidget& card, const QString& text) {
        for (Button* button : card.findChildren<Button*>())
            if (button->text() == text)
                return button;
        return nullptr;
    }

    const noctule::test::TestBox box_{{.loops = true}};
    std::unique_ptr<ReadinessPanel> panel_;
};

TEST_F(CalibrationFit, AStepThatIsNotUsableIsNotReady) {
    Calibration calibration = fresh();
    calibration.boards[1].made["gyroscopes"].verdict = "not usable";
    studio_->suit().setCalibration(calibration);
    studio_->setChecked(CheckedSuit{QDateTime::currentDateTime(), true});
    const QString title = "Gyroscopes: the calibration is not usable";
    ASSERT_TRUE(shows(title));
    EXPECT_EQ(panel_->verdict(), "Connected");
    EXPECT_TRUE(panel_->verdictText().startsWith("Part of the calibration is not usable."))
        << panel_->verdictText().toStdString();
    EXPECT_TRUE(buttonOf(*cardOf(title), "Calibrate"));
    EXPECT_EQ(verdictOf(studio_->check()).tone, Tone::kWarn);
    EXPECT_EQ(recordingVerdictOf(studio_->check().readiness()).tone, Tone::kWarn);
}

TEST_F(CalibrationFit, AnOldRestPoseIsToldWithItsAge) {
    Calibration calibration = fresh();
    for (BoardCalibration& board : calibration.boards)
        board.made["rest-pose"].created_utc = hoursAgo(26);
    studio_->suit().setCalibration(calibration);
    ASSERT_TRUE(waitFor([this] {
        return !panel_->cards().empty() &&
               panel_->cards().front()->title().startsWith("The rest pose is 26 hour");
    }));
    EXPECT_EQ(panel_->verdict(), "Connected");
    EXPECT_TRUE(buttonOf(*panel_->cards().front(), "Calibrate"));
    studio_->setChecked(CheckedSuit{QDateTime::currentDateTime(), true});
    EXPECT_TRUE(waitFor([this] { return panel_->verdict() == "Ready"; })) << "it still fits";
}

TEST_F(CalibrationFit, ValuesThatAreDueAgainAreAWarning) {
    Calibration calibration = fresh();
    for (BoardCalibration& board : calibration.boards)
        board.made["gyroscopes"].created_utc = hoursAgo(24 * 100);
    studio_->suit().setCalibration(calibration);
    studio_->setChecked(CheckedSuit{QDateTime::currentDateTime(), true});
    ASSERT_TRUE(waitFor([this] { return panel_->verdict() == "Ready"; }));
    EXPECT_TRUE(panel_->verdictText().startsWith("Part of the calibration is due again."))
        << panel_->verdictText().toStdString();
    EXPECT_EQ(verdictOf(studio_->check()).tone, Tone::kWarn);
    ASSERT_FALSE(panel_->cards().empty());
    EXPECT_TRUE(buttonOf(*panel_->cards().front(), "Calibrate"));
}

/// The check is the only one that finds exchanged boards: its card says so. The virtual suit's places are
/// those of the simulation, so nothing is to be found.
TEST_F(CalibrationFit, TheCheckIsOfferedForPlacesAndExchangedBoardsUnlessNobodyWearsTheSuit) {
    studio_->suit().setCalibration(fresh());
    const QString title = "Not checked since it was put on";
    ASSERT_TRUE(shows(title));
    const auto labels = cardOf(title)->findChildren<QLabel*>();
    EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel* label) {
        return label->text().contains(
            "the check says whether boards sit in their places, slipped or were "
            "exchanged.");
    }));
    EXPECT_TRUE(buttonOf(*cardOf(title), "Check the suit"));
    studio_->suit().connectTo(QString::fromStdString(box_.address()), {fresh(), std::nullopt, 0.5});
    EXPECT_TRUE(waitFor([&] { return studio_->suit().isKnownExactly() && panel_->verdict() == "Ready"; }));
    EXPECT_FALSE(cardOf(title));
}

TEST_F(CalibrationFit, NewerValuesOfTheSuitAreOfferedOnConnect) {
    CalibrationShelf& shelf = studio_->calibrations();
    CalibrationResult found;
    found.calibration = fresh();
    ASSERT_EQ(shelf.save(found, "sensors"), "");
    EXPECT_FALSE(panel_->newer().card());
    Calibration later = fresh();
    for (BoardCalibration& board : later.boards)
        board.made["gyroscopes"].created_utc = hoursAgo(0);
    later.created_utc = hoursAgo(0);
    ASSERT_TRUE(SuitMemory(studio_->suitsFolder()).keep(studio_->suit().serial(), later));
    studio_->suit().disconnectSuit();
    studio_->suit().connectTo(QString::fromStdString(box_.address()));
    ASSERT_TRUE(waitFor([this] { return panel_->newer().card() != nullptr; }));
    EXPECT_EQ(panel_->newer().card()->title(), "Newer values of this suit are there");
    ASSERT_TRUE(buttonOf(*panel_->newer().card(), "Use them"));
    buttonOf(*panel_->newer().card(), "Use them")->click();
    EXPECT_TRUE(waitFor([this] { return panel_->newer().card() == nullptr; }));
    EXPECT_EQ(shelf.inForce()->boards[0].made.at("gyroscopes").created_utc,
              later.boards[0].made.at("gyroscopes").created_utc);
}

}  // namespace
}  // namespace noctule::ui
