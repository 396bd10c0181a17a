// SPDX-License-Identifier: Apache-2.0
// What Preferences and a page both show is one setting: each follows the other at once.
#include <QComboBox>

#include "tests/ui/main_window/studio_fixture.h"
#include "ui/main_window/preferences_dialog.h"
#include "ui/models/countdown_setting.h"
#include "ui/models/tones.h"
#include "ui/style/lengths.h"
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
        CountdownSetting::get().setSeconds(5);  // as the menu on Record does
        EXPECT_EQ(dialog.countdown().currentData(), 5);
    }
    restart();
    EXPECT_EQ(PreferencesDialog(*studio_).countdown().currentData(), 5) << "kept";
}

TEST_F(PreferencesTest, UnitsAreKeptAndTheWindowIsMadeAnewWithThem) {
    bool made_anew = false;
    {
        PreferencesDialog dialog(*studio_);
        QObject::connect(&dialog, &PreferencesDialog::wordsChanged, [&] { made_anew = true; });
        EXPECT_EQ(dialog.units().currentIndex(), 0);
        dialog.units().setCurrentIndex(1);
        emit dialog.units().activated(1);
    }
    EXPECT_TRUE(made_anew);
    EXPECT_EQ(chosenUnits(), Units::kImperial);
    EXPECT_EQ(studio_->settings().value("units").toString(), "imperial") << "for the next start";
    restart();
    EXPECT_EQ(PreferencesDialog(*studio_).units().currentIndex(), 1);
    chooseUnits(Units::kMetric);
}

TEST_F(PreferencesTest, TonesArePlayedOnTheChosenDeviceOrElseByTheDesktop) {
    std::vector<SoundDevice> devices{{"usb", "Loudspeaker"}, {"head", "Headphones"}};
    QStringList played;
    Tones::get().setPlayer({[&] { return devices; },
                            [&](const QString& id, const std::function<void()>& failed) {
                                played << id;
                                if (devices.empty())
                                    failed();
                            }});
    QStringList told;
    QObject::connect(studio_.get(), &Studio::warned, [&](const QString& words) { told << words; });
    Tones::get().play();
    EXPECT_TRUE(played.isEmpty()) << "as the desktop unless chosen otherwise";
    {
        PreferencesDialog dialog(*studio_);
        EXPECT_EQ(dialog.soundDevice().count(), 3);
        EXPECT_EQ(dialog.soundDevice().currentText(), "As the desktop");
        choose(dialog.soundDevice(), "head");
    }
    EXPECT_EQ(played, QStringList{"head"}) << "heard at once";
    devices.clear();
    Tones::get().play();
    Tones::get().play();
    ASSERT_EQ(told.size(), 1) << "said once";
    EXPECT_TRUE(told.front().contains("Headphones"));
    EXPECT_EQ(PreferencesDialog(*studio_).soundDevice().currentText(), "Headphones, not there");
    Tones::get().setPlayer({});
}

}  // namespace
}  // namespace noctule::ui
