// SPDX-License-Identifier: Apache-2.0
// The wizards in the window, and whether anything on them is cut.
#pragma once

#include "tests/ui/main_window/clipping_fixture.h"
#include "tests/ui/wizards/rig_program.h"
#include "ui/main_window/side_docks.h"
#include "ui/wizards/calibrate_page.h"
#include "ui/wizards/wizard_page.h"

namespace noctule::ui::test {

class WizardFixture : public ClippingFixture {
protected:
    CalibratePage& page() { return dynamic_cast<CalibratePage&>(window_->page(Step::kCalibrate)); }
    WizardRun& run() { return *page().wizard().run(); }
    bool reach(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, 120'000); }
    void smallWindowIsWhole(const QString& where) {
        window_->resize(1280, 800);
        window_->sideDocks().reset();
        QTest::qWait(60);
        expectWholeAndItsLanguage(*window_, where);
        EXPECT_EQ(window_->size(), QSize(1280, 800)) << where.toStdString();
    }
    /// Quicker than wizardIsWhole(): colours cut nothing.
    void bothSizesAreWhole(const QString& name) {
        for (const double scale : {1.0, 1.5}) {
            Theme::get().setScale(scale);
            const QString look = QStringLiteral("%1, %2 %").arg(GetParam()).arg(100 * scale);
            smallWindowIsWhole(name + ", " + look);
            savePicture(name, look);
        }
        Theme::get().setScale(1);
    }
    void savePicture(const QString& name, const QString& look) {
        const QString folder = qEnvironmentVariable("NOCTULE_SCREENSHOTS");
        if (!folder.isEmpty())
            window_->grab().save(QStringLiteral("%1/window-%2-%3.png")
                                     .arg(folder, QString(name).replace(' ', '-'),
                                          QString(look).remove(',').remove('%').replace(' ', '-')));
    }
    void wizardIsWhole(const QString& name) {
        inEveryLook(
            [&](const QString& look) { smallWindowIsWhole(QStringLiteral("%1, %2").arg(name, look)); });
        if (!qEnvironmentVariableIsEmpty("NOCTULE_SCREENSHOTS"))
            inEveryLook([&](const QString& look) {
                const bool large = look.contains("150");
                window_->resize(large ? QSize(1280, 800) : QSize(1440, 900));
                window_->sideDocks().reset();
                QTest::qWait(300);
                savePicture(name, look);
            });
        Theme::get().setScale(1);
        Theme::get().setScheme(Scheme::kDark);
    }

    std::unique_ptr<RigProgram> rig_;
};

}  // namespace noctule::ui::test
