// SPDX-License-Identifier: Apache-2.0
// What Preferences and a page both show is one setting: each follows the other at once.
#include <QComboBox>

#include "tests/ui/main_window/studio_fixture.h"
#include "ui/main_window/preferences_dialog.h"
#include "ui/models/countdown.h"
#include "ui/views/record/record_bar.h"
#include "ui/widgets/button.h"

namespace noctule::ui {
namespace {

class PreferencesTest : public test::StudioWindow {
protected:
    static void choose(QComboBox& box, const QVariant& value) {
        box.setCurrentIndex(box.findData(value));
        emit box.activated(box.currentIndex());
    }
};

TEST_F(PreferencesTest, TheCountdownIsThatOfRecord) {
    window_->goTo(Step::kRecord);
    const Button& on_page = window_->findChild<RecordBar*>()->countdownButton();
    {
        PreferencesDialog dialog(*studio_);
        EXPECT_EQ(dialog.countdown().currentData(), 3);
        choose(dialog.countdown(), 10);
        EXPECT_TRUE(on_page.accessibleName().contains("10")) << on_page.accessibleName().toStdString();
        choose(dialog.countdown(), 0);
        EXPECT_EQ(on_page.accessibleName(), "No countdown");
        Countdown::get().setSeconds(5);  // as the menu on Record does
        EXPECT_EQ(dialog.countdown().currentData(), 5);
    }
    restart();
    EXPECT_EQ(PreferencesDialog(*studio_).countdown().currentData(), 5) << "kept";
}

}  // namespace
}  // namespace noctule::ui
