// SPDX-License-Identifier: Apache-2.0
// Pictures of the calibration's pages in the window, with the virtual suit on the level plate and on the
// turntable; see live_pictures.h.
#include <QTemporaryDir>

#include "core/formats/bvh.h"
#include "core/guide/movement_guide.h"
#include "tests/support/guided_motion.h"
#include "tests/ui/main_window/live_pictures.h"
#include "tests/ui/wizards/rig_program.h"
#include "ui/widgets/button.h"
#include "ui/wizards/calibrate_page.h"
#include "ui/wizards/compare_dialog.h"
#include "ui/wizards/wizard_intro.h"
#include "ui/wizards/wizard_page.h"

namespace noctule::ui {
namespace {

class WizardPictures : public test::LivePictures {
protected:
    void put(const QStringList& options) {
        rig_ = std::make_unique<test::RigProgram>(QStringList{"--seed", "3"} + options);
        ASSERT_TRUE(rig_->isThere());
        studio_->suit().connectTo(rig_->address());
        ASSERT_TRUE(waitFor([this] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; }));
        window_->goTo(Step::kCalibrate);
    }
    CalibratePage& page() { return dynamic_cast<CalibratePage&>(window_->page(Step::kCalibrate)); }
    WizardRun& run() { return *page().wizard().run(); }
    void saveComparison(const ShelvedCalibration& other) {
        for (const Scheme scheme : {Scheme::kDark, Scheme::kLight}) {
            Theme::get().setScheme(scheme);
            CompareDialog shown(*studio_, other, window_.get());
            shown.show();
            QTest::qWait(300);
            saveAs(shown, QString("dialog-compare-") + (scheme == Scheme::kDark ? "dark" : "light"));
        }
        Theme::get().setScheme(Scheme::kDark);
    }
    bool reach(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, 60'000); }

    std::unique_ptr<test::RigProgram> rig_;
};

TEST_F(WizardPictures, AccelerometersFromOverviewToResult) {
    put({"--rig", "level"});
    save("calibrate-overview", {{1440, 900}});
    page().open(WizardTask::kAccelerometers);
    save("calibrate-accelerometers-needs", {{1440, 900}});
    page().wizard().intro().beginButton()->click();
    for (int side = 0; side < 2; ++side) {
        rig_->tell(QByteArray("side ") + (side == 0 ? "+z" : "-z"));
        ASSERT_TRUE(reach([&] { return run().guide()->isDone(4 + side); }));
    }
    rig_->tell("unplug 10");
    rig_->tell("side +y");
    ASSERT_TRUE(reach([&] { return run().guide()->guidance().hindrance == Hindrance::kAbsent; }));
    save("calibrate-accelerometers-silent", {{1440, 900}, {1280, 800}});
    rig_->tell("plug 10");
    for (const char* side : {"+y", "-y", "+x", "-x"}) {
        rig_->tell(QByteArray("side ") + side);
        const int steps = run().stepCount();
        const auto done = [&] {
            int count = 0;
            for (int step = 0; step < steps; ++step)
                count += run().guide()->isDone(step);
            return count;
        };
        const int before = done();
        ASSERT_TRUE(reach([&] { return run().phase() >= WizardRun::Phase::kSolving || done() > before; }));
    }
    ASSERT_TRUE(reach([&] { return run().phase() == WizardRun::Phase::kResult; }));
    save("calibrate-accelerometers-result", {{1280, 800}, {1920, 1080}});
    run().save();
    page().closeWizard();
    save("calibrate-overview-later", {{1280, 800}, {1920, 1080}});
    ShelvedCalibration other = studio_->calibrations().all().front();
    for (BoardCalibration& board : other.calibration.boards) {  // a warmer day
        board.gyro.zero_counts += Vector3d(0.8, -0.5, 0.2);
        board.accel.matrix *= 1.0004;
    }
    other.file = "accelerometers-2025-12-01.json";
    saveComparison(other);
}

TEST_F(WizardPictures, OtherTasks) {
    put({"--rig", "rest"});
    for (const WizardTask task : kWizardTasks) {
        page().open(task);
        save("calibrate-" + keyOf(task) + "-needs", {{1280, 800}});
    }
    page().open(WizardTask::kRestPose);
    page().wizard().intro().beginButton()->click();
    ASSERT_TRUE(reach([&] { return run().heldShare() > 0.3; }));
    saveAs("calibrate-rest-pose-hold");
    ASSERT_TRUE(reach([&] { return run().phase() == WizardRun::Phase::kResult; }));
    save("calibrate-rest-pose-result", {{1280, 800}, {1440, 900}});
}

TEST_F(WizardPictures, Movement) {
    QTemporaryDir folder;
    const QString motion = folder.filePath("guided.bvh");
    ASSERT_TRUE(
        writeBvh(motion.toStdString(), noctule::test::GuidedMotion::clip({8.5, 3.5, 0.035}), {}, true));
    put({"--motion", motion, "--loop"});
    page().open(WizardTask::kMovement);
    page().wizard().intro().beginButton()->click();
    const auto guide = [this]() -> const MovementGuide& {
        return static_cast<const MovementGuide&>(*run().guide());
    };
    ASSERT_TRUE(reach([&] { return run().guide()->guidance().hindrance == Hindrance::kStand; }));
    save("calibrate-motion-stand", {{1280, 800}});
    for (const int step : {0, 1}) {
        ASSERT_TRUE(
            reach([&] { return guide().isMoving() && run().step() == step && run().heldShare() > 0.2; }));
        saveAs(QString("calibrate-motion-%1").arg(step + 1));
    }
}

}  // namespace
}  // namespace noctule::ui
