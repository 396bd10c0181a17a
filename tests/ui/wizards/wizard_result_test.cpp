// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/wizard_result.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <algorithm>

#include "tests/ui/support/wait.h"
#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

CalibrationDocument longDocument() {
    CalibrationTable table{"Boards", "", {"board", "turns"}, {}};
    for (int row = 0; row < 100; ++row)
        table.rows.push_back({"board " + std::to_string(row), "6"});
    CalibrationDocument document;
    document.procedure = "Gyroscopes";
    document.summary = "100 boards";
    document.tables.push_back(table);
    return document;
}

TEST(WizardResult, AResultOpensAtItsTopWhereverTheOneBeforeWasLeft) {
    Theme::install(*qApp);
    WizardResult result;
    result.resize(600, 400);
    result.setDocument(longDocument(), {});
    result.show();
    QScrollBar& bar = *result.findChild<QScrollArea*>()->verticalScrollBar();
    ASSERT_TRUE(waitFor([&] { return bar.maximum() > 100; }));
    bar.setValue(bar.maximum());
    result.setDocument(longDocument(), {});
    QApplication::processEvents();
    EXPECT_EQ(bar.value(), 0);
}

TEST(WizardResult, ErrorsBeyondTheScaleAreSaidSo) {
    Theme::install(*qApp);
    const auto isSaid = [](double before_mm) {
        CalibrationDocument document = longDocument();
        document.errors = CalibrationErrors{"Errors", "mm", 1, {{"board 1", {before_mm}, {0.5}}}};
        WizardResult result;
        result.setDocument(document, {});
        const auto labels = result.findChildren<QLabel*>();
        return std::ranges::any_of(labels, [](const QLabel* label) {
            return label->text() == "A triangle at the end of the scale: this error lies beyond it.";
        });
    };
    EXPECT_FALSE(isSaid(0.8));
    EXPECT_TRUE(isSaid(300));
}

}  // namespace
}  // namespace noctule::ui
