// SPDX-License-Identifier: Apache-2.0
// Nothing of the wizards is cut in the window, however large and in whatever language: the first page of
// each, and every page of the magnetometers with a virtual suit in a bag.
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "core/processing/field_take.h"
#include "tests/ui/main_window/wizard_fixture.h"
#include "ui/widgets/button.h"
#include "ui/wizards/field_sensors.h"
#include "ui/wizards/wizard_intro.h"

namespace noctule::ui {
namespace {

constexpr int kBoards = 6;

class WizardsInTheWindow : public test::WizardFixture {
protected:
    const FieldGuide& guide() { return *run().fieldGuide(); }
    static Suit suitWithField() {
        std::ifstream file(NOCTULE_SOURCE_DIR "/resources/suits/default.json");
        nlohmann::json suit = nlohmann::json::parse(file);
        auto& all = suit["boards"];
        all.erase(all.begin() + kBoards, all.end());
        for (auto& board : all)
            board["stream"] = "imu9";
        return suitFromJson(suit, "default.json").value();
    }
    /// Readings from `share` of all directions; the last board carries iron.
    static FieldRecord turned(double share) {
        FieldRecord record;
        record.spot = SpotField{48.1, 0.9, 65.8, 1.9, 40, 14.2};
        std::mt19937 random(5);
        std::normal_distribution<double> normal;
        for (int board = 0; board < kBoards; ++board) {
            auto& readings = record.readings.emplace_back();
            while (readings.size() < 900) {
                const Vector3d at = Vector3d{normal(random), normal(random), normal(random)}.normalized();
                if (at.y() < 1 - 2 * share)
                    continue;
                const double loose = board == kBoards - 1 ? 5 : 0.3;
                const Vector3d field_ut = 48 * at + Vector3d(9, -6, 3 * board) +
                                          loose * Vector3d{normal(random), 0, normal(random)};
                readings.push_back({1000.0 + 20'000.0 * static_cast<double>(readings.size()),
                                    (field_ut.array() * 2048 / 100 + 2048).round()});
            }
        }
        return record;
    }
    QString fieldTake(const QString& path, double share) {
        EXPECT_TRUE(
            writeFieldTake({path.toStdString(), "turned", "2026-03-01T10:00:00Z", "test", 150'000, {}},
                           suitWithField(), turned(share)));
        return path;
    }
    void connectBag() {
        const QString suit = folder_.filePath("bag.json");
        std::ofstream(suit.toStdString()) << toJson(suitWithField()).dump();
        rig_ = std::make_unique<test::RigProgram>(QStringList{"--suit", suit, "--seed", "3", "--rig", "bag"});
        ASSERT_TRUE(rig_->isThere());
        studio_->suit().connectTo(rig_->address());
        ASSERT_TRUE(reach([this] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; }));
    }
    void begin() {
        page().open(WizardTask::kMagnetometers);
        ASSERT_TRUE(page().wizard().intro().beginButton()->isEnabled());
        page().wizard().intro().beginButton()->click();
        ASSERT_EQ(run().phase(), WizardRun::Phase::kGuiding);
    }
};

TEST_P(WizardsInTheWindow, FirstPages) {
    window_->goTo(Step::kCalibrate);
    for (const WizardTask task : kWizardTasks) {
        page().open(task);
        wizardIsWhole(keyOf(task));
    }
}

TEST_P(WizardsInTheWindow, MagnetometersAtTheSpot) {
    ASSERT_TRUE(studio_->session().create(folder_.filePath("spot"), "spot"));
    connectBag();
    window_->goTo(Step::kCalibrate);
    begin();
    wizardIsWhole("magnetometers spot");
    for (const char* height : {"height 1.5", "height 1"})
        rig_->tell(height);
    ASSERT_TRUE(reach([this] { return guide().isDone(FieldGuide::kSpot); }));
    wizardIsWhole("magnetometers floor");
    rig_->tell("height 0.15");
    ASSERT_TRUE(reach([this] { return guide().isDone(FieldGuide::kFloor); }));
    EXPECT_TRUE(guide().spot().floor_percent);
}

TEST_P(WizardsInTheWindow, MagnetometersBeingTurned) {
    const QString session = folder_.filePath("turned");
    ASSERT_TRUE(studio_->session().create(session, "turned"));
    QDir().mkpath(session + "/calibration/evidence");
    fieldTake(session + "/calibration/evidence/magnetometers_001.noctule", 0.8);
    UnfinishedCalibration unfinished;
    unfinished.started_utc = "2026-03-01T10:00:00Z";
    for (const int step : {0, 1}) {
        WizardEvidence part{"magnetometers_001.noctule", step, {}, {}};
        for (const Board& board : suitWithField().boards)
            part.boards.push_back(board.id);
        unfinished.evidence.push_back(part);
    }
    unfinished.share = 0.8;
    connectBag();
    const QString serial = studio_->suit().serial();
    ASSERT_FALSE(serial.isEmpty());
    ASSERT_TRUE(writeUnfinished(unfinishedPath(session + "/calibration", "magnetometers", serial),
                                "magnetometers", unfinished));
    window_->goTo(Step::kCalibrate);
    page().open(WizardTask::kMagnetometers);
    wizardIsWhole("magnetometers kept");
    begin();
    ASSERT_TRUE(reach([this] { return guide().guidance().hindrance == Hindrance::kTurnOn; }));
    EXPECT_GT(guide().leastShare(), 0.6);
    wizardIsWhole("magnetometers turned");
    rig_->tell("unplug 2");
    ASSERT_TRUE(reach([this] { return guide().guidance().hindrance == Hindrance::kAbsent; }));
    EXPECT_TRUE(page().wizard().fieldSensors().skipButton()->isVisible());
    wizardIsWhole("magnetometers silent");
}

TEST_P(WizardsInTheWindow, ResultOfMagnetometers) {
    ASSERT_TRUE(studio_->session().create(folder_.filePath("result"), "result"));
    window_->goTo(Step::kCalibrate);
    page().open(WizardTask::kMagnetometers);
    run().solveTakes({fieldTake(folder_.filePath("turned.noctule"), 1)});
    ASSERT_TRUE(reach([this] { return run().phase() == WizardRun::Phase::kResult; }))
        << run().trouble().toStdString();
    wizardIsWhole("magnetometers result");
}

TEST_P(WizardsInTheWindow, ResultOfTheRestPose) {
    ASSERT_TRUE(studio_->session().create(folder_.filePath("rest"), "rest"));
    rig_ = std::make_unique<test::RigProgram>(QStringList{"--seed", "3", "--rig", "rest"});
    ASSERT_TRUE(rig_->isThere());
    studio_->suit().connectTo(rig_->address());
    ASSERT_TRUE(reach([this] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; }));
    window_->goTo(Step::kCalibrate);
    page().open(WizardTask::kRestPose);
    page().wizard().intro().beginButton()->click();
    ASSERT_TRUE(reach([this] { return run().phase() == WizardRun::Phase::kResult; }))
        << run().trouble().toStdString();
    wizardIsWhole("rest pose result");
}

INSTANTIATE_TEST_SUITE_P(Languages, WizardsInTheWindow, testing::Values("en", "de"));

}  // namespace
}  // namespace noctule::ui
