// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <QSettings>

#include "ui/views/export/export_settings.h"

namespace noctule::ui {
namespace {

TEST(ExportPresetsTest, RememberSettingsPerPreset) {
    QSettings().clear();
    QSettings store;
    {
        ExportPresets presets(store);
        ExportSettings settings = presets.all()[0].settings;
        settings.frames_per_second = 30;
        presets.remember(presets.all()[0].key, settings);
        settings.metres_per_unit = 1;
        const QString own = presets.addOwn("Mine", settings);
        presets.choose(own);
    }
    ExportPresets presets(store);
    EXPECT_EQ(presets.all()[0].settings.frames_per_second, 30);
    EXPECT_EQ(presets.all()[2].settings.frames_per_second, 60) << "each has its own";
    ASSERT_TRUE(presets.all().back().is_own);
    EXPECT_EQ(presets.lastChosen(), presets.all().back().key);
    EXPECT_EQ(presets.all().back().name, "Mine");
    presets.removeOwn(presets.lastChosen());
    EXPECT_FALSE(presets.all().back().is_own);
    EXPECT_EQ(presets.lastChosen(), presets.all().front().key);
}

}  // namespace
}  // namespace noctule::ui
