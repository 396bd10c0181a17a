// SPDX-License-Identifier: Apache-2.0
#include "ui/views/session/recent_sessions.h"

#include "core/recording/take_edit.h"
#include "tests/ui/views/reviewed_session.h"

namespace noctule::ui {
namespace {

using RecentSessionsTest = test::ReviewedSession;

TEST_F(RecentSessionsTest, ATakeThatIsNotUsableIsNoPictureOfItsSession) {
    addTake("swing_002");
    RecentSession asked;
    asked.folder = QString::fromStdString(studio_->session().session().folder.string());
    EXPECT_EQ(lookAt(asked, {}).newest_take, takePath("swing_002")) << "the newest";
    const auto uncalibrate = [&](const QString& name) {
        auto take = Take::open(takePath(name).toStdString(), Access::kReadWrite);
        ASSERT_TRUE(take);
        auto edit = TakeEdit::begin(*take);
        ASSERT_TRUE(edit);
        ASSERT_TRUE(edit->addCalibration(nominalCalibration(*take->suit())));
        ASSERT_TRUE(edit->removeReference());
        ASSERT_TRUE(edit->commit());
    };
    uncalibrate("swing_002");
    EXPECT_EQ(lookAt(asked, {}).newest_take, takePath("swing_001"));
    uncalibrate("swing_001");
    EXPECT_EQ(lookAt(asked, {}).newest_take, takePath("swing_002")) << "there is no better one";
}

}  // namespace
}  // namespace noctule::ui
