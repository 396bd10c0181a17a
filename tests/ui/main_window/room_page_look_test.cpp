// SPDX-License-Identifier: Apache-2.0
// The survey of a room within the window: nothing is cut, and German is German. NOCTULE_TEST_PICTURES names a
// folder for pictures of it.
#include <QLabel>

#include "tests/support/program_run.h"
#include "tests/ui/main_window/clipping_fixture.h"
#include "ui/main_window/side_docks.h"
#include "ui/widgets/button.h"
#include "ui/wizards/calibrate_page.h"
#include "ui/wizards/room_page.h"
#include "ui/wizards/task_card.h"

namespace noctule::ui {
namespace {

class RoomLook : public test::ClippingFixture {
protected:
    CalibratePage& page() { return dynamic_cast<CalibratePage&>(window_->page(Step::kCalibrate)); }
    /// A performer below four anchors, opened; `duration` in seconds.
    void open(const std::string& name, const std::string& duration) {
        const std::string resources = NOCTULE_SOURCE_DIR "/resources/";
        const std::string cast = folder_.filePath("cast.json").toStdString();
        const std::string take = (folder_.path().toStdString() + "/" + name) + ".noctule";
        std::ofstream(cast)
            << R"({"subjects":[{"name":"Ada","motion":")" << resources << R"(motions/sample.bvh","suit":")"
            << resources << R"(casts/transceivers_13.json","place":{"x_m":0,"z_m":0,"yaw_deg":0}}],"room":")"
            << resources << R"(casts/ceiling_4.json"})";
        const auto made =
            noctule::test::batch({"simulate", "--cast", cast, "--out", take, "--level", "readings",
                                  "--scenario", "nominal", "--duration", duration, "--seed", "4"});
        ASSERT_EQ(made.exit_code, 0) << made.err;
        studio_->session().importTakes({QString::fromStdString(take)});
        ASSERT_TRUE(waitFor([&] {
            return studio_->take().overview() && studio_->take().path().contains(name.c_str()) &&
                   studio_->jobs().idle();
        }));
        window_->goTo(Step::kCalibrate);
        page().closeWizard();
    }
    void survey() {
        QTest::mouseClick(page().roomCard()->button(), Qt::LeftButton);
        ASSERT_TRUE(waitFor([this] {
            return page().room().run().phase() != RoomRun::Phase::kSurveying && studio_->jobs().idle();
        }));
    }
    void leaveOutAnAnchor() {
        const auto without = [this](bool left_out) -> Button* {
            for (auto* button : window_->findChildren<Button*>())
                if (button->text() ==
                    RoomPage::tr(left_out ? "Use anchor %1 again" : "Use without anchor %1").arg(2))
                    return button;
            return nullptr;
        };
        ASSERT_NE(without(false), nullptr);
        without(false)->click();
        ASSERT_TRUE(waitFor([&] { return without(true) != nullptr; }));
    }
    void lookAt(const QString& what) {
        inEveryLook([&](const QString& look) {
            for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
                window_->resize(size);
                window_->sideDocks().reset();
                QTest::qWait(60);
                expectWholeAndItsLanguage(*window_, look + ", " + what);
                EXPECT_EQ(window_->size(), size) << look.toStdString();
                if (const QString folder = qEnvironmentVariable("NOCTULE_TEST_PICTURES"); !folder.isEmpty())
                    window_->grab().save(
                        QStringLiteral("%1/%2 %3 %4.png").arg(folder, what, look).arg(size.width()));
            }
        });
    }
};

TEST_P(RoomLook, IsWholeAndInOneLanguage) {
    ASSERT_TRUE(studio_->session().create(folder_.filePath("room"), "Room"));
    window_->goTo(Step::kCalibrate);
    page().openRoom();
    lookAt("no room");
    open("walk_001", "12");
    lookAt("overview");
    survey();
    ASSERT_EQ(page().room().run().phase(), RoomRun::Phase::kResult);
    lookAt("room");
    leaveOutAnAnchor();
    lookAt("room without an anchor");
    open("short_001", "3.2");  // the rest pose and hardly more
    survey();
    lookAt("room of a short take");
}

INSTANTIATE_TEST_SUITE_P(Languages, RoomLook, testing::Values("en", "de"));

}  // namespace
}  // namespace noctule::ui
