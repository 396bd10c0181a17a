// SPDX-License-Identifier: Apache-2.0
// The page of the room, and takes with a performer below four anchors.
#pragma once

#include <QLabel>
#include <QProcess>

#include "tests/ui/wizards/wizard_flow.h"
#include "ui/wizards/room_page.h"

namespace noctule::ui::test {

class RoomFlow : public WizardFlow {
protected:
    void SetUp() override {
        WizardFlow::SetUp();
        page_->resize(1000, 760);
        ASSERT_TRUE(studio_->session().create(folder_.filePath("session"), "Room"));
    }
    /// Ada below four anchors; `duration` in seconds, as text. Sound of one clock for both can be played by
    /// two boxes.
    QString makeTake(const QString& name, const QString& duration, const QString& level = "readings") {
        const std::string resources = NOCTULE_SOURCE_DIR "/resources/";
        const QString cast = folder_.filePath("cast.json"), take = folder_.filePath(name + ".noctule");
        std::ofstream(cast.toStdString())
            << R"({"shared_clock":)" << (level == "signal" ? "true" : "false")
            << R"(,"subjects":[{"name":"Ada","motion":")" << resources << R"(motions/sample.bvh","suit":")"
            << resources << R"(casts/transceivers_13.json","place":{"x_m":0,"z_m":0,"yaw_deg":0}}],"room":")"
            << resources << R"(casts/ceiling_4.json"})";
        QProcess program;
        program.start(NOCTULE_PROGRAM,
                      {"--batch", "simulate", "--cast", cast, "--out", take, "--level", level, "--scenario",
                       "nominal", "--duration", duration, "--seed", "4"});
        EXPECT_TRUE(program.waitForFinished(-1));
        EXPECT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
        return take;
    }
    RoomRun& run() { return page_->room().run(); }
    static bool says(QWidget& where, const QString& words) {
        for (const QLabel* label : where.findChildren<QLabel*>())
            if (!label->isHidden() && label->text().contains(words))
                return true;
        return false;
    }
};

}  // namespace noctule::ui::test
