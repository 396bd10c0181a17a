// SPDX-License-Identifier: Apache-2.0
#include "ui/views/report/report_view.h"

#include <QFile>
#include <QTest>

#include "tests/ui/views/reviewed_session.h"
#include "ui/views/review/review_page.h"

namespace noctule::ui {
namespace {

class ReportViewTest : public test::ReviewedSession {};

TEST_F(ReportViewTest, OpensInsideTheWindowAndIsSaved) {
    ReviewPage page(*studio_);
    page.show();
    page.enter();
    openTake("swing_001");
    page.openFullReport();
    ReportView& view = page.reportView();
    ASSERT_TRUE(page.showsFullReport() && waitFor([&] { return view.page().figureCount() > 10; }));
    EXPECT_TRUE(view.page().toPlainText().contains("Sensors and results"));
    EXPECT_TRUE(view.page().savePdf(outsideFile("report.pdf")));
    QFile joints(outsideFile("joints.csv"));
    view.saveJoints(joints.fileName());
    ASSERT_TRUE(waitFor([&] { return joints.open(QFile::ReadOnly); }));
    EXPECT_TRUE(joints.readAll().contains(",LeftForeArm,"));
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_FALSE(page.showsFullReport());
}

}  // namespace
}  // namespace noctule::ui
