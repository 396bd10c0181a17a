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

}  // namespace
}  // namespace noctule::ui
