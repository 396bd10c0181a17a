// SPDX-License-Identifier: Apache-2.0
#include "ui/views/session/transfer_dialog.h"

#include "tests/ui/views/reviewed_session.h"
#include "ui/views/session/recent_sessions.h"
#include "ui/widgets/button.h"

namespace noctule::ui {
namespace {

class TransferDialogTest : public test::ReviewedSession {
protected:
    void SetUp() override {
        ReviewedSession::SetUp();
        for (const char* name : {"other", "third"})
            ASSERT_TRUE(createSession(folder_.filePath(name).toStdString(), name, "2026-01-01T00:00:00Z"));
        RecentSessions recent(studio_->settings(), studio_->jobs());
        for (const char* name : {"session", "gone", "other"})
            recent.remember(folder_.filePath(name));
    }
};

TEST_F(TransferDialogTest, OffersTheSessionsThatAreThere) {
    TransferDialog dialog(*studio_, "swing_001", SessionModel::Transfer::kMove);
    EXPECT_EQ(dialog.actionButton()->text(), "Move");
    EXPECT_FALSE(dialog.actionButton()->isEnabled());
    EXPECT_FALSE(dialog.choose(folder_.filePath("session")).isEmpty()) << "it is there already";
    EXPECT_FALSE(dialog.choose(folder_.path()).isEmpty()) << "no session";
    EXPECT_EQ(dialog.choose(folder_.filePath("third")), QString());
    EXPECT_TRUE(dialog.actionButton()->isEnabled());
    dialog.accept();
    EXPECT_EQ(dialog.result(), QDialog::Accepted);
    EXPECT_EQ(dialog.folder(), folder_.filePath("third"));
}

}  // namespace
}  // namespace noctule::ui
