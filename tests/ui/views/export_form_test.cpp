// SPDX-License-Identifier: Apache-2.0
#include "ui/views/export/export_form.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>

#include "tests/ui/views/reviewed_session.h"
#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

using ExportFormTest = test::ReviewedSession;

TEST_F(ExportFormTest, ControlsStandInOneColumnHoweverLongALabelIs) {
    ExportForm form(*studio_);
    for (QLabel* label : form.findChildren<QLabel*>())
        if (label->text() == "Try first")
            label->setText("Try the first one of them");
    const auto leftOf = [&](QWidget* control) { return control->mapTo(&form, QPoint()).x(); };
    for (const double scale : {1.25, 1.0}) {
        Theme::get().setScale(scale);
        form.resize(form.sizeHint());
        form.show();
        EXPECT_TRUE(waitFor([&] { return leftOf(form.range) == leftOf(form.name_pattern); })) << scale;
        EXPECT_GT(leftOf(form.range), Theme::get().px(120)) << scale;
    }
}

TEST_F(ExportFormTest, RatesOfTelevisionAreExactAndRemembered) {
    const double ntsc = 30000.0 / 1001;
    ExportSettings settings;
    settings.frames_per_second = ntsc;
    ExportPresets(studio_->settings()).remember("motionbuilder", settings);
    const ExportPresets again(studio_->settings());
    settings = again.all()[static_cast<size_t>(again.indexOf("motionbuilder"))].settings;
    EXPECT_EQ(settings.frames_per_second, ntsc);
    ExportForm form(*studio_);
    form.setSettings(settings);
    EXPECT_EQ(form.frames->currentText(), "29.97 per second");
    EXPECT_EQ(form.frames->currentData().toDouble(), ntsc);
    EXPECT_TRUE(settingsInWords(settings).endsWith("29.97 frames"));
}

}  // namespace
}  // namespace noctule::ui
