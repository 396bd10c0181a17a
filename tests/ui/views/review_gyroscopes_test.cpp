// SPDX-License-Identifier: Apache-2.0
// From a result that used no gyroscopes to one that does.
#include <QApplication>
#include <QTimer>

#include "tests/ui/views/reviewed_session.h"
#include "ui/views/report/report_panel.h"
#include "ui/views/review/reprocess_dialog.h"
#include "ui/views/review/review_page.h"

namespace noctule::ui {
namespace {

using ReviewGyroscopes = test::ReviewedSession;

TEST_F(ReviewGyroscopes, ProcessingWithThemProposesThem) {
    ReviewPage page(*studio_);
    openTake("swing_001");
    ProcessRequest without = ReprocessDialog(*studio_, *studio_->take().overview()).request();
    without.tracker.sensors.gyroscopes = false;
    page.process(without);
    ASSERT_TRUE(waitFor(
        [&] { return jobsAreDone() && studio_->take().overview()->runs.back().settings.sensors == "AD"; }));
    EXPECT_FALSE(ReprocessDialog(*studio_, *studio_->take().overview()).request().tracker.sensors.gyroscopes)
        << "Reprocess begins with what was";

    std::optional<SensorSelection> asked;
    QTimer looking;
    QObject::connect(&looking, &QTimer::timeout, [&] {
        if (auto* dialog = qobject_cast<ReprocessDialog*>(QApplication::activeModalWidget())) {
            asked = dialog->request().tracker.sensors;
            dialog->reject();
        }
    });
    looking.start(20);
    emit page.reportPanel().gyroscopesWanted();
    ASSERT_TRUE(asked);
    EXPECT_TRUE(asked->gyroscopes);
    EXPECT_TRUE(asked->accelerometers && asked->distances) << "the others as they were";
}

}  // namespace
}  // namespace noctule::ui
