// SPDX-License-Identifier: Apache-2.0
#include "ui/views/session/transfer_dialog.h"

#include <QFile>
#include <QListWidget>
#include <QSysInfo>

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
            ASSERT_TRUE(createSession(folder_.filePath(name).toStdString(),
                                      "The " + std::string(name) + " stage", "2026-01-01T00:00:00Z"));
        RecentSessions recent(studio_->settings(), studio_->jobs());
        for (const char* name : {"session", "gone", "other"})
            recent.remember(folder_.filePath(name));
    }
};

TEST_F(TransferDialogTest, OffersTheSessionsThatAreThere) {
    TransferDialog dialog(*studio_, "swing_001", SessionModel::Transfer::kMove);
    EXPECT_EQ(dialog.actionButton()->text(), "Move");
    EXPECT_FALSE(dialog.actionButton()->isEnabled());
    auto* list = dialog.findChild<QListWidget*>();
    ASSERT_EQ(list->count(), 1) << "neither the open one nor one that has gone";
    EXPECT_EQ(list->item(0)->data(Qt::UserRole).toString(), folder_.filePath("other"));
    EXPECT_TRUE(list->item(0)->text().startsWith("The other stage   in "))
        << list->item(0)->text().toStdString();
    EXPECT_FALSE(dialog.choose(folder_.filePath("session")).isEmpty()) << "it is there already";
    EXPECT_FALSE(dialog.choose(folder_.path()).isEmpty()) << "no session";
    EXPECT_EQ(dialog.choose(folder_.filePath("third")), QString());
    EXPECT_TRUE(dialog.actionButton()->isEnabled());
    dialog.accept();
    EXPECT_EQ(dialog.result(), QDialog::Accepted);
    EXPECT_EQ(dialog.folder(), folder_.filePath("third"));
}

TEST_F(TransferDialogTest, ASessionChosenTwiceIsListedOnce) {
    TransferDialog dialog(*studio_, "swing_001", SessionModel::Transfer::kMove);
    auto* list = dialog.findChild<QListWidget*>();
    for (const char* name : {"third", "third/", "other", "other"})
        EXPECT_EQ(dialog.choose(folder_.filePath(name)), QString());
    EXPECT_EQ(list->count(), 2);
    EXPECT_EQ(dialog.folder(), folder_.filePath("other"));
}

TEST_F(TransferDialogTest, ASingleClickMovesNothing) {
    TransferDialog dialog(*studio_, "swing_001", SessionModel::Transfer::kMove);
    auto* list = dialog.findChild<QListWidget*>();
    list->setCurrentRow(0);
    emit list->itemActivated(list->item(0));  // what a click does on some desktops
    EXPECT_EQ(dialog.result(), 0);
    emit list->itemDoubleClicked(list->item(0));
    EXPECT_EQ(dialog.result(), QDialog::Accepted);
}

TEST_F(TransferDialogTest, ASessionOpenInAnotherWindowIsRefused) {
    QFile marker(folder_.filePath("other/session.lock"));
    ASSERT_TRUE(marker.open(QIODevice::WriteOnly));
    // A process that is always there.
    marker.write(QStringLiteral("1\nnoctule\n%1\n").arg(QSysInfo::machineHostName()).toUtf8());
    marker.close();
    TransferDialog dialog(*studio_, "swing_001", SessionModel::Transfer::kCopy);
    ASSERT_EQ(dialog.choose(folder_.filePath("other")), QString());
    dialog.accept();
    EXPECT_EQ(dialog.result(), 0);
    EXPECT_EQ(dialog.folder(), folder_.filePath("other"));
}

}  // namespace
}  // namespace noctule::ui
