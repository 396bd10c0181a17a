// SPDX-License-Identifier: Apache-2.0
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QToolButton>

#include "tests/devices/support/test_box.h"
#include "tests/ui/main_window/studio_fixture.h"
#include "ui/main_window/top_bar.h"
#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

/// Opens every menu of the window as an operator does. A missing icon or an exception ends the test.
class MenusTest : public test::StudioWindow {
protected:
    void openAll(QMenu& menu) {
        menu.popup(window_->mapToGlobal(QPoint(0, 0)));
        ASSERT_TRUE(waitFor([&] { return menu.isVisible(); })) << menu.title().toStdString();
        EXPECT_FALSE(menu.isEmpty()) << menu.title().toStdString();
        EXPECT_FALSE(menu.grab().isNull());
        ++opened_;
        for (QAction* action : menu.actions()) {
            EXPECT_TRUE(action->isSeparator() || !action->text().isEmpty()) << menu.title().toStdString();
            if (QMenu* inner = action->menu())
                openAll(*inner);
        }
        menu.close();
    }

    void openAllOnEveryPage() {
        for (const Step step : test::kEveryStep) {
            window_->goTo(step);
            opened_ = 0;
            for (QAction* title : window_->topBar().menuBar().actions())
                openAll(*title->menu());
            EXPECT_GE(opened_, 7) << "File, its recent sessions, Edit, View, Suit, Take, Help";
            openMenusOf<QToolButton>();
            openMenusOf<QPushButton>();
        }
    }

    /// Buttons of the page and its docks.
    template <class Button>
    void openMenusOf() {
        for (const Button* button : window_->findChildren<Button*>())
            if (button->isVisible() && button->menu())
                openAll(*button->menu());
    }

    void inEveryLook() {
        for (const double scale : {1.0, 1.5})
            for (const Scheme scheme : {Scheme::kDark, Scheme::kLight}) {
                Theme::get().setScale(scale);
                Theme::get().setScheme(scheme);
                openAllOnEveryPage();
            }
        Theme::get().setScale(1);
        Theme::get().setScheme(Scheme::kDark);
    }

    int opened_ = 0;
};

TEST_F(MenusTest, EveryMenuOpensOnEveryPageWithoutASession) {
    inEveryLook();
}

TEST_F(MenusTest, EveryMenuOpensOnEveryPageWithATake) {
    openSampleTake();
    inEveryLook();
}

TEST_F(MenusTest, EveryMenuOpensOnEveryPageWithASuitAndWhileItIsRecorded) {
    noctule::test::TestBox box({.loops = true});
    ASSERT_TRUE(studio_->session().create(home() + "-suit", "suit"));
    studio_->suits().add(QString::fromStdString(box.address()));
    ASSERT_TRUE(waitFor([&] { return studio_->suit().phase() == LiveSuit::Phase::kLooking; }));
    openAllOnEveryPage();
    ASSERT_EQ(studio_->suit().record({"walk", {}, 0, 0}), "");
    ASSERT_TRUE(waitFor([&] { return studio_->suits().isTakeOpen(); }));
    openAllOnEveryPage();
    EXPECT_TRUE(studio_->suits().isTakeOpen());
}

}  // namespace
}  // namespace noctule::ui
