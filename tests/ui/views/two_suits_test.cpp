// SPDX-License-Identifier: Apache-2.0
// Two virtual suits from Connect over Record to Review and Export: each a program of its own that plays one
// performer of a take with sound, five housings each.
#include <gtest/gtest.h>
#include <signal.h>

#include <QComboBox>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTest>
#include <QToolButton>
#include <set>

#include "core/recording/take.h"
#include "tests/core/simulation/swaying_pair.h"
#include "tests/support/take_files.h"
#include "tests/ui/support/wait.h"
#include "ui/scene/scene_view.h"
#include "ui/style/theme.h"
#include "ui/views/connect/assign_panel.h"
#include "ui/views/connect/connect_page.h"
#include "ui/views/connect/device_card.h"
#include "ui/views/connect/devices_panel.h"
#include "ui/views/connect/suit_switch.h"
#include "ui/views/export/export_form.h"
#include "ui/views/export/export_page.h"
#include "ui/views/readiness_words.h"
#include "ui/views/record/record_bar.h"
#include "ui/views/record/record_center.h"
#include "ui/views/record/record_page.h"
#include "ui/views/record/record_readiness.h"
#include "ui/views/suit_cards.h"
#include "ui/views/suit_state_card.h"
#include "ui/widgets/button.h"

namespace noctule::ui {
namespace {

namespace fs = std::filesystem;

/// Sound of two who sway; made once for all tests.
const std::string& soundOfPair() {
    static const QTemporaryDir folder;
    static const std::string path = [] {
        simulation::CastRequest request;
        for (const std::string name : {"A", "B"}) {
            simulation::CastSubject subject;
            subject.name = name;
            subject.stage.clip = noctule::test::swaying();
            subject.stage.suit = noctule::test::fewHousings();
            subject.place = name == "A" ? simulation::StandingPlace{0, -0.6, 0}
                                        : simulation::StandingPlace{0, 0.7, std::numbers::pi};
            request.subjects.push_back(std::move(subject));
        }
        request.shared_clock = true;
        request.scenario = *simulation::Scenario::named("nominal");
        request.rest_seconds = noctule::test::kSwayingRest_s;
        const auto cast = simulation::prepareCast(request);
        EXPECT_TRUE(cast);
        simulation::TakeRequest take;
        take.out_path = folder.filePath("pair.noctule").toStdString();
        take.name = "pair";
        take.created_utc = "2026-01-02T03:04:05Z";
        take.software = "test";
        EXPECT_TRUE(simulation::writeTake(*cast, take, {}));
        return take.out_path;
    }();
    return path;
}

class TwoSuitsTest : public testing::Test {
protected:
    void SetUp() override {
        Theme::install(*qApp);
        QSettings().clear();
        fs::remove_all(QStandardPaths::writableLocation(QStandardPaths::CacheLocation).toStdString());
        QSettings().setValue("folders/sessions", folder_.filePath("sessions"));
        QSettings().setValue("folders/suits", folder_.filePath("suits"));
        QSettings().setValue("record/countdown_s", 0);
        QSettings().setValue("record/tones", false);
        StudioParts parts;
        parts.software = "noctule test";
        parts.utc_now = [] { return std::string("2026-03-01T10:00:00Z"); };
        parts.make_sample_take = [](const std::string& path, const JobContext&) -> Status {
            fs::copy_file(noctule::test::kTinyTake, path);
            return Done{};
        };
        parts.make_pair_take = [](const std::string& path, const JobContext&) -> Status {
            fs::copy_file(soundOfPair(), path);
            return Done{};
        };
        parts.virtual_suit_program = NOCTULE_PROGRAM;
        studio_ = std::make_unique<Studio>(parts);
        ASSERT_TRUE(studio_->session().create(folder_.filePath("stage"), "Stage"));
        connect_ = std::make_unique<ConnectPage>(*studio_);
        record_ = std::make_unique<RecordPage>(*studio_);
        record_->resize(1000, 700);
        record_->show();
        connect_->enter();
        record_->enter();
    }
    void TearDown() override {
        waitFor([this] { return studio_->jobs().idle(); });
        connect_.reset();
        record_.reset();
        studio_.reset();
    }

    LiveSuits& suits() { return studio_->suits(); }
    SuitInUse& worn(size_t index) { return *suits().connected().at(index); }
    bool bothLook() {
        return waitFor([this] {
            const auto all = suits().connected();
            return all.size() == 2 && std::ranges::all_of(all, [](const SuitInUse* one) {
                       return one->suit.phase() == LiveSuit::Phase::kLooking && one->suit.frame() &&
                              one->suit.frame()->pose;
                   });
        });
    }
    static void press(DeviceCard& card) { emit card.activated(); }
    void addBoth() {
        press(connect_->devices().virtualCard());
        ASSERT_TRUE(waitFor([this] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; }));
        press(connect_->devices().secondVirtualCard());
        ASSERT_TRUE(bothLook());
    }
    RecordRun& run() { return record_->run(); }
    bool recordFor(double seconds) {
        // Whatever is wanting of ten housings, the suits can be recorded.
        if (!waitFor([&] {
                return run().state() == RecordRun::State::kReady ||
                       (run().state() == RecordRun::State::kRefused && run().obstacle().may_record_anyway);
            }))
            return false;
        if (run().state() == RecordRun::State::kReady)
            run().press();
        else
            run().recordAnyway();
        return waitFor([&] {
            return run().state() == RecordRun::State::kRecording &&
                   worn(0).suit.recordedSeconds() >= seconds && worn(1).suit.recordedSeconds() >= seconds;
        });
    }
    SuitCards& cards() { return record_->readiness().suits(); }

    QTemporaryDir folder_;
    std::unique_ptr<Studio> studio_;
    std::unique_ptr<ConnectPage> connect_;
    std::unique_ptr<RecordPage> record_;
};

TEST_F(TwoSuitsTest, ConnectShowsOneOfThemAndSaysWhoWearsEach) {
    DevicesPanel& devices = connect_->devices();
    EXPECT_TRUE(devices.secondVirtualCard().isHidden()) << "the first comes first";
    addBoth();
    EXPECT_EQ(worn(0).suit.status()->hello->drive_hz, 40000);
    EXPECT_EQ(worn(1).suit.status()->hello->drive_hz, 48000);
    EXPECT_TRUE(worn(0).suit.calibration() && worn(1).suit.calibration());
    auto* row = connect_->findChild<SuitSwitch*>();
    ASSERT_TRUE(row);
    ASSERT_EQ(row->buttons().size(), 2u);
    EXPECT_EQ(row->buttons()[1]->text(), "Performer 2");
    EXPECT_TRUE(row->buttons()[1]->isChecked());
    EXPECT_EQ(connect_->assigning().performers().currentText(), "Performer 2");
    EXPECT_TRUE(devices.secondVirtualCard().words().detail.contains("worn by B Performer 2"));
    EXPECT_TRUE(devices.secondVirtualCard().words().chosen);
    row->buttons()[0]->click();
    EXPECT_EQ(&suits().current(), &worn(0));
    EXPECT_EQ(connect_->assigning().performers().currentText(), "Performer 1");
    EXPECT_TRUE(devices.virtualCard().words().chosen);
    press(devices.secondVirtualCard());
    EXPECT_TRUE(waitFor([&] { return suits().connected().size() == 1; }));
    EXPECT_TRUE(row->isHidden());
    EXPECT_EQ(studio_->suit().phase(), LiveSuit::Phase::kLooking) << "the first one stays";
}

TEST_F(TwoSuitsTest, TheVerdictIsThatOfTheWorstWhoeverIsLookedAt) {
    addBoth();
    ASSERT_TRUE(waitFor([&] {
        return std::ranges::all_of(suits().connected(), [](const SuitInUse* one) {
            return one->check.readiness().verdict == Readiness::Verdict::kReady;
        });
    }));
    worn(0).suit.setCalibration({});
    for (const bool other : {true, false}) {
        suits().setCurrent(worn(other ? 1 : 0));
        ASSERT_TRUE(waitFor([&] { return &worstOf(suits()) == &worn(0); }));
        const VerdictWords words = verdictOf(suits());
        EXPECT_EQ(words.tone, Tone::kWarn);
        EXPECT_TRUE(words.text.contains("Not calibrated")) << words.text.toStdString();
        EXPECT_EQ(words.text.startsWith("Performer 1: "), other) << words.text.toStdString();
        EXPECT_EQ(connect_->readiness().verdict(), words.verdict);
    }
}

TEST_F(TwoSuitsTest, OneButtonRecordsBothAndReviewAndExportHaveBoth) {
    addBoth();
    ASSERT_TRUE(waitFor([&] { return cards().words().size() == 2; }));
    EXPECT_EQ(cards().words()[0].name, "Performer 1");
    EXPECT_EQ(cards().words()[1].letter, 1);
    EXPECT_TRUE(cards().words()[1].box.contains("48 kHz")) << cards().words()[1].box.toStdString();
    EXPECT_FALSE(cards().apart());
    cards().cards()[0]->showButton()->click();
    EXPECT_EQ(&suits().current(), &worn(0));
    EXPECT_EQ(record_->center().bar().verb(), "Record both");
    QSignalSpy steps(studio_.get(), &Studio::stepRequested);
    ASSERT_TRUE(recordFor(3));
    EXPECT_EQ(record_->center().bar().verb(), "Stop both");
    EXPECT_TRUE(waitFor([&] {
        return cards().words()[0].verdict.startsWith("Records, 0:0") &&
               cards().words()[1].verdict.startsWith("Records, 0:0");
    }));
    run().addMarker();
    run().stop();
    ASSERT_TRUE(waitFor([&] { return steps.count() > 0; }));
    EXPECT_EQ(steps.back()[0].value<Step>(), Step::kReview);
    TakeDocument& take = studio_->take();
    ASSERT_TRUE(waitFor([&] { return take.isOpen() && take.shownMotion() && studio_->jobs().idle(); }))
        << take.problem().toStdString();
    ASSERT_EQ(take.subjects().size(), 2u);
    EXPECT_EQ(take.subjects()[0].name, "Performer 1");
    EXPECT_EQ(take.subjects()[1].name, "Performer 2");
    EXPECT_TRUE(waitFor([&] { return take.motionOf(1) && !take.motionOf(1)->frames.empty(); }));
    ExportPage page(*studio_);
    page.resize(1000, 700);
    page.show();
    page.choosePreset("bvh");
    page.enter();
    QTest::mouseClick(page.writeButton(), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return page.results().has_value() && studio_->jobs().idle(); }));
    std::set<std::string> files;
    for (const ExportOutcome& outcome : page.results()->outcomes) {
        EXPECT_FALSE(outcome.error) << outcome.error->text();
        files.insert(fs::path(outcome.path).filename().string());
    }
    EXPECT_EQ(files.size(), 2u);
    EXPECT_TRUE(bothLook()) << "and the suits go on";
}

TEST_F(TwoSuitsTest, ASurveyIsShownWhereItWasBegun) {
    addBoth();
    QSignalSpy steps(studio_.get(), &Studio::stepRequested);
    ASSERT_EQ(suits().record({.base_name = "room", .is_survey = true}), "");
    ASSERT_TRUE(waitFor([&] { return suits().recordedSeconds() > 0.5; }));
    EXPECT_EQ(run().state(), RecordRun::State::kRecording);
    suits().stopRecording();
    ASSERT_TRUE(waitFor([&] { return !suits().isTakeOpen() && studio_->jobs().idle(); }));
    EXPECT_EQ(studio_->session().session().takes.size(), 1u);
    EXPECT_EQ(studio_->session().currentTake(), -1);
    EXPECT_EQ(steps.size(), 0);
}

TEST_F(TwoSuitsTest, AProgramThatDiesIsNamedAndTheOtherIsRecordedOn) {
    addBoth();
    ASSERT_TRUE(recordFor(1));
    QSignalSpy warned(studio_.get(), &Studio::warned);
    kill(static_cast<pid_t>(studio_->secondVirtualSuit().processId()), SIGKILL);
    ASSERT_TRUE(waitFor([&] { return cards().words()[1].verdict.startsWith("Lost at"); }));
    EXPECT_TRUE(cards().words()[0].verdict.startsWith("Records"));
    const double then_s = worn(0).suit.recordedSeconds();
    ASSERT_TRUE(waitFor([&] { return worn(0).suit.recordedSeconds() > then_s + 1; }));
    EXPECT_EQ(run().state(), RecordRun::State::kRecording);
    run().stop();
    ASSERT_TRUE(waitFor([&] { return !suits().isTakeOpen(); }));
    EXPECT_TRUE(waitFor([&] { return suits().connected().size() == 1; })) << "nobody is there any more";
    EXPECT_EQ(studio_->session().session().takes.at(0).state, TakeState::kComplete);
    EXPECT_TRUE(std::ranges::any_of(warned, [](const QList<QVariant>& said) {
        return said[0].toString().contains("Performer 2") && said[0].toString().contains("was lost after");
    }));
}

}  // namespace
}  // namespace noctule::ui
