// SPDX-License-Identifier: Apache-2.0
// Nothing is cut while a wizard guides, and on its results, at 100 and 150 percent in the smallest window.
// Magnetometers and the rest pose's own result have magnetometer_wizard_test.cpp.
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/report/calibration_documents.h"
#include "tests/ui/main_window/wizard_fixture.h"
#include "ui/models/part_names.h"
#include "ui/wizards/wizard_result.h"

namespace noctule::ui {
namespace {

constexpr int kSides = 6, kPlacements = 4;

Suit defaultSuit() {
    std::ifstream file(NOCTULE_SOURCE_DIR "/resources/suits/default.json");
    return suitFromJson(nlohmann::json::parse(file), "default.json").value();
}

AxisCalibration foundAxes(double full_scale) {
    AxisCalibration axes = AxisCalibration::nominal(full_scale);
    axes.sigma_zero_counts = Vector3d::Constant(0.1);
    return axes;
}

CalibrationDocument resultOfSources(const Suit& suit) {
    SourceOffsetReport report;
    report.suit = suit;
    for (int source = 0; source < static_cast<int>(suit.sources.size()); ++source) {
        report.sources.push_back(
            {suit.sources[static_cast<size_t>(source)].id, true, 0.000123, 2e-6, 72, 0.0021, 0.00011});
        for (int placement = 0; placement < kPlacements; ++placement) {
            JigMeasurement measured;
            measured.placement = std::to_string(placement + 1);
            measured.source = source;
            measured.used = true;
            measured.left_out_m = 0.001 * (placement + 1);
            report.measurements.push_back(measured);
        }
    }
    report.leave_one_out = report.all_left_out = {504, 0.0021, 0.0018, 0.0093};
    return documentOf(report);
}

CalibrationDocument resultOfAccelerometers(const Suit& suit) {
    AccelerometerReport report;
    for (const Board& board : suit.boards) {
        AccelerometerBoard found;
        found.board = board;
        found.axes = foundAxes(60);
        for (int side = 0; side < kSides; ++side) {
            AccelerometerPosition position;
            position.residual_m_per_s2 = 0.002 * side;
            position.residual_before_m_per_s2 = 0.3;
            found.positions.push_back(position);
        }
        report.boards.push_back(found);
    }
    return documentOf(report);
}

CalibrationDocument resultOfGyroscopes(const Suit& suit) {
    GyroscopeReport report;
    report.nominal_rpm = report.rpm = 45;
    report.speed_measured = true;
    for (const Board& board : suit.boards) {
        GyroscopeBoard found;
        found.board = board;
        found.axes = foundAxes(20);
        found.sigma_mean_zero_counts = Vector3d::Constant(0.1);
        for (int side = 0; side < kSides; ++side) {
            GyroscopeTurn turn;
            turn.residual_rad_per_s = Vector3d::Constant(0.0002 * side);
            turn.residual_before_rad_per_s = Vector3d::Constant(0.02);
            found.turns.push_back(turn);
        }
        report.boards.push_back(found);
    }
    return documentOf(report);
}

CalibrationDocument resultOfMovement(const Suit& suit) {
    MotionReport report;
    for (const Board& board : suit.boards) {
        BoardInMotion found;
        found.id = board.id;
        found.measured = found.observed[0] = found.observed[1] = found.observed[2] = true;
        found.sigma_turn_rad = Vector3d::Constant(0.008);
        found.before.distance_m = 0.034;
        found.after.distance_m = 0.0047;
        report.boards.push_back(found);
    }
    for (const Source& source : suit.sources)
        report.sources.push_back({source.id, {0.1, 0.2, 0.05}, Vector3d::Constant(0.003), 0.0012, 0.0004});
    for (const std::string& joint : canonicalJointNames())
        if (joint != canonicalJointNames().front())
            report.bones.push_back({joint, 1.034, 0.008});
    report.moved_s = 62;
    report.rests = 6;
    report.distances = 123'456;
    report.iterations = 12;
    report.converged = true;
    return documentOf(report);
}

CalibrationDocument resultOfCheck(const Suit& suit) {
    StillCheckReport report;
    for (const Board& board : suit.boards)
        report.boards.push_back({board.id, true, 0.02, Vector3d::Constant(0.001), 0.012, 6, false});
    return documentOf(report);
}

class EveryWizard : public test::WizardFixture {
protected:
    /// One distance: what is shown is a placement that is not heard as it was measured.
    QString distancesOf(const Suit& suit) {
        const QString path = folder_.filePath("tape.csv");
        std::ofstream(path.toStdString()) << "placement,source,board,distance_m\n1," << suit.sources[0].id
                                          << ',' << suit.boards[0].id << ",0.5125\n";
        return path;
    }
};

TEST_P(EveryWizard, Guides) {
    ASSERT_TRUE(studio_->session().create(folder_.filePath("guided"), "guided"));
    rig_ = std::make_unique<test::RigProgram>(QStringList{"--seed", "3", "--rig", "level"});
    ASSERT_TRUE(rig_->isThere());
    studio_->suit().connectTo(rig_->address());
    ASSERT_TRUE(reach([this] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; }));
    CalibrationResult to_check;
    to_check.calibration = nominalCalibration(studio_->suit().suit());
    ASSERT_EQ(studio_->calibrations().save(to_check, "gyroscopes"), "");
    window_->goTo(Step::kCalibrate);
    for (const WizardTask task : kWizardTasks) {
        if (task == WizardTask::kMagnetometers)
            continue;
        page().open(task);
        if (task == WizardTask::kSources) {
            ASSERT_EQ(run().setDistances(distancesOf(studio_->suit().suit())), "");
        }
        ASSERT_EQ(run().whyNotBegin(), "") << keyOf(task).toStdString();
        run().begin();
        ASSERT_TRUE(reach([this] { return !run().guide()->guidance().boards.empty(); }));
        bothSizesAreWhole(keyOf(task) + " guides");
        page().closeWizard();
    }
}

TEST_P(EveryWizard, ShowsItsResult) {
    ASSERT_TRUE(studio_->session().create(folder_.filePath("results"), "results"));
    window_->goTo(Step::kCalibrate);
    const Suit suit = defaultSuit();
    const std::pair<WizardTask, CalibrationDocument> results[] = {
        {WizardTask::kSources, resultOfSources(suit)},
        {WizardTask::kAccelerometers, resultOfAccelerometers(suit)},
        {WizardTask::kGyroscopes, resultOfGyroscopes(suit)},
        {WizardTask::kMovement, resultOfMovement(suit)},
        {WizardTask::kCheck, resultOfCheck(suit)}};
    for (const auto& [task, document] : results) {
        page().open(task);
        WizardPage& wizard = page().wizard();
        wizard.resultPage().setDocument(document, partNames(suit));
        wizard.setCurrentWidget(&wizard.resultPage());
        bothSizesAreWhole(keyOf(task) + " result");
        EXPECT_EQ(wizard.currentWidget(), &wizard.resultPage());
        page().closeWizard();
    }
}

INSTANTIATE_TEST_SUITE_P(Languages, EveryWizard, testing::Values("en", "de"));

}  // namespace
}  // namespace noctule::ui
