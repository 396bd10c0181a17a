// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/wizard_result.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QScrollArea>
#include <QScrollBar>

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

}  // namespace
}  // namespace noctule::ui
