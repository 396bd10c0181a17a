// SPDX-License-Identifier: Apache-2.0
// From launch to a suit that is ready, through the window: the virtual suit's program streams the tiny take.
#include <QUndoStack>

#include "tests/devices/support/test_box.h"
#include "tests/support/take_files.h"
#include "tests/ui/main_window/studio_fixture.h"
#include "tests/ui/support/stall_watch.h"
#include "ui/main_window/side_docks.h"
#include "ui/main_window/status_line.h"
#include "ui/main_window/top_bar.h"
#include "ui/views/connect/board_card.h"
#include "ui/views/connect/body_map.h"
#include "ui/views/connect/connect_page.h"
#include "ui/views/connect/device_card.h"
#include "ui/views/connect/devices_panel.h"
#include "ui/views/connect/readiness_panel.h"
#include "ui/widgets/button.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/step_bar.h"

namespace noctule::ui {
namespace {

class ConnectFlow : public test::StudioWindow {
protected:
    StudioParts parts() const override {
        StudioParts parts = StudioWindow::parts();
        parts.make_sample_take = [](const std::string& path, const JobContext&) -> Status {
            std::filesystem::copy_file(noctule::test::kTinyTake, path);
            return Done{};
        };
        return parts;
    }
    ConnectPage& page() { return dynamic_cast<ConnectPage&>(window_->page(Step::kConnect)); }
    QStringList chips() {
        QStringList texts;
        for (const Chip* chip : window_->topBar().findChildren<Chip*>())
            if (chip->isVisible())
                texts << chip->text();
        return texts;
    }
};

TEST_F(ConnectFlow, FromLaunchToReadyInTwoClicksAndOnToRecord) {
    QTest::mouseClick(&window_->topBar().steps(), Qt::LeftButton, {},
                      window_->topBar().steps().stepRect(0).center());
    window_->goTo(Step::kConnect);
    EXPECT_EQ(chips(), QStringList{"No suit"});
    QTest::mouseClick(page().devices().virtualCard().button(), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return page().readiness().verdict() == "Ready"; }));
    EXPECT_EQ(chips(), (QStringList{"2/2 boards", "NB-000777"}));
    ASSERT_TRUE(waitFor([&] { return window_->statusLine().openText().contains("0.6 MB/s"); }))
        << window_->statusLine().openText().toStdString();
    EXPECT_TRUE(window_->statusLine().openText().startsWith("NB-000777 streaming"));
    EXPECT_TRUE(window_->statusLine().openText().contains("°C"));
    EXPECT_TRUE(window_->statusLine().openText().contains(", humidity 4")) << "of the tiny take, 43 to 45 %";
    QTest::mouseClick(page().readiness().wayOn(), Qt::LeftButton);
    EXPECT_EQ(window_->step(), Step::kRecord);
    studio_->stopVirtualSuit();
    EXPECT_EQ(chips(), QStringList{"No suit"});
}

TEST_F(ConnectFlow, TheCountOfBoardsIsGreenWhereAllAreThereWhateverElseIsToKnow) {
    const noctule::test::TestBox box({.loops = true});
    studio_->suit().connectTo(QString::fromStdString(box.address()));
    window_->goTo(Step::kConnect);
    ASSERT_TRUE(waitFor([this] { return chips() == QStringList{"2/2 boards", "NB-000777"}; }));
    EXPECT_FALSE(studio_->check().readiness().problems.empty()) << "it is not calibrated";
    const auto all = window_->topBar().findChildren<Chip*>();
    const auto chip = std::ranges::find(all, "2/2 boards", [](const Chip* one) { return one->text(); });
    ASSERT_NE(chip, all.end());
    EXPECT_EQ((*chip)->tone(), Tone::kOk);
    EXPECT_EQ(window_->topBar().steps().state(TopBar::indexOf(Step::kConnect)), StepBar::State::kAttention);
}

TEST_F(ConnectFlow, NothingThatASilentSuitToldLooksAsIfItWereCurrent) {
    noctule::test::TestBox box({.loops = true, .temperature_c = 23.0F});
    studio_->suit().connectTo(QString::fromStdString(box.address()));
    const auto bottom = [this] { return window_->statusLine().openText(); };
    QStringList told;
    ASSERT_TRUE(waitFor([&] {
        told << bottom();
        return bottom().contains("MB/s") && bottom().contains(QString::fromUtf8("°C"));
    }));
    EXPECT_TRUE(told.filter(QRegularExpression("\\b0\\.0\\sMB")).isEmpty())
        << "no rate before it was measured";
    EXPECT_FALSE(bottom().contains("last known"));
    box.freeze(true);
    box.cut();
    ASSERT_TRUE(
        waitFor([&] { return bottom().contains("the link is broken") || bottom().contains("no sound"); }));
    EXPECT_TRUE(bottom().contains("last known")) << bottom().toStdString();
    EXPECT_FALSE(bottom().contains("MB/s"));
}

TEST_F(ConnectFlow, TheDockKeepsItsWidthAsCardsCome) {
    for (const int width : {1280, 1440}) {
        window_->resize(width, 800);
        window_->goTo(Step::kConnect);
        QTest::qWait(100);
        const int before = window_->sideDocks().right().width();
        const noctule::test::TestBox box({.loops = true});
        studio_->suit().connectTo(QString::fromStdString(box.address()));
        ASSERT_TRUE(waitFor([&] { return !page().readiness().cards().empty(); }));
        QTest::qWait(100);
        EXPECT_EQ(window_->sideDocks().right().width(), before) << width;
        studio_->suit().disconnectSuit();
        EXPECT_TRUE(waitFor([&] { return page().readiness().cards().empty(); }));
    }
}

TEST_F(ConnectFlow, WatchingASuitHoldsNothingUp) {
    if (!test::timesAreJudged())
        GTEST_SKIP() << test::kWhyNotJudged;
    window_->goTo(Step::kConnect);
    studio_->startVirtualSuit();
    ASSERT_TRUE(waitFor([&] { return page().readiness().verdict() == "Ready"; }));
    page().map().boardButton(1)->click();
    QTest::qWait(500);
    test::StallWatch watch;
    QTest::qWait(3000);
    std::printf("watching a suit: longest gap %.0f ms, of it ours %.0f ms\n", watch.longest_ms(),
                watch.longestOwn_ms());
    EXPECT_LT(watch.longestOwn_ms(), test::kLongestStall_ms);
}

TEST_F(ConnectFlow, EveryControlHasANameAndTheKeysAreThere) {
    window_->goTo(Step::kConnect);
    studio_->startVirtualSuit();
    ASSERT_TRUE(waitFor([&] { return page().readiness().verdict() == "Ready"; }));
    for (QWidget* root : {static_cast<QWidget*>(&page()), page().leftDock(), page().rightDock()})
        for (const QAbstractButton* button : root->findChildren<QAbstractButton*>())
            if (button->isVisible()) {
                EXPECT_FALSE(button->accessibleName().isEmpty() && button->text().isEmpty())
                    << button->metaObject()->className();
            }
    QStringList keys;
    for (const QAction* action : page().actions())
        keys << action->shortcut().toString();
    for (const char* key : {"F5", "B", "Del"})
        EXPECT_TRUE(keys.contains(key)) << key;
}

}  // namespace
}  // namespace noctule::ui
