// SPDX-License-Identifier: Apache-2.0
// Takes go to another session as jobs; a move can be undone.
#include <QFile>
#include <QSettings>
#include <QSignalSpy>
#include <QSysInfo>

#include "tests/core/session/session_folder.h"
#include "tests/ui/support/wait.h"
#include "ui/models/session_model.h"

namespace noctule::ui {
namespace {

using Transfer = SessionModel::Transfer;

class SessionTransfersTest : public noctule::test::SessionFolder {
protected:
    void SetUp() override {
        QSettings().clear();
        newSession();
        makeTake(takes() / "walk_001.noctule", "2026-03-01T10:00:00Z", "Performer 1");
        makeTake(takes() / "walk_002.noctule", "2026-03-01T11:00:00Z", "Performer 1");
        ASSERT_TRUE(createSession(other(), "Other stage", noctule::test::kCreated));
        model_.open(QString::fromStdString(folder().string()));
        ASSERT_TRUE(waitFor([this] { return model_.isOpen() && jobs_.idle(); }));
        model_.rate(0, 3);
    }

    Path other() const { return home_ / "other"; }
    Session there() const { return openSession(other(), {}).value(); }
    void transfer(Transfer how) {
        model_.transferTake(0, QString::fromStdString(other().string()), how);
        ASSERT_TRUE(waitFor([this] { return jobs_.idle(); }));
    }

    /// As another window of a program that is always there does.
    void setOpenElsewhere(bool open) {
        QFile marker(QString::fromStdString((other() / "session.lock").string()));
        if (!open) {
            ASSERT_TRUE(marker.remove());
            return;
        }
        ASSERT_TRUE(marker.open(QIODevice::WriteOnly));
        marker.write(QStringLiteral("1\nnoctule\n%1\n").arg(QSysInfo::machineHostName()).toUtf8());
    }

    Jobs jobs_;
    SessionModel model_{jobs_, [this] { return QString::fromStdString(home_.string()); }};
};

TEST_F(SessionTransfersTest, AMoveIsAStepThatCanBeUndone) {
    QSignalSpy moved(&model_, &SessionModel::takeMoved);
    transfer(Transfer::kMove);
    ASSERT_EQ(moved.count(), 1);
    EXPECT_EQ(moved[0][0].toString(), "walk_001 is in “Other stage”");
    EXPECT_EQ(model_.session().findTake("walk_001"), -1);
    ASSERT_EQ(there().takes.size(), 1U);
    EXPECT_EQ(there().takes[0].rating, 3);
    EXPECT_EQ(model_.undoStack().undoText(), "Move walk_001 to “Other stage”");
    model_.undoStack().undo();
    EXPECT_EQ(model_.session().takes.at(0).rating, 3);
    EXPECT_TRUE(isThere(takes() / "walk_001.noctule"));
    EXPECT_TRUE(there().takes.empty());
    model_.undoStack().redo();
    EXPECT_EQ(there().takes.size(), 1U);
    EXPECT_FALSE(isThere(takes() / "walk_001.noctule"));
}

TEST_F(SessionTransfersTest, ARatingGivenMeanwhileGoesAlong) {
    model_.transferTake(0, QString::fromStdString(other().string()), Transfer::kMove);
    EXPECT_EQ(jobs_.all().back()->title(), "Moving walk_001 to Other stage");
    model_.rate(0, 5);
    ASSERT_TRUE(waitFor([this] { return jobs_.idle(); }));
    ASSERT_EQ(there().takes.size(), 1U);
    EXPECT_EQ(there().takes[0].rating, 5);
    model_.undoStack().undo();
    EXPECT_EQ(model_.session().takes.at(0).rating, 5);
}

TEST_F(SessionTransfersTest, ASessionOpenInAnotherWindowIsNotWritten) {
    QSignalSpy failed(&model_, &SessionModel::failed);
    setOpenElsewhere(true);
    transfer(Transfer::kMove);
    transfer(Transfer::kCopy);
    ASSERT_EQ(failed.count(), 2);
    EXPECT_TRUE(failed[0][0].toString().contains("“Other stage” is open in another window"))
        << failed[0][0].toString().toStdString();
    EXPECT_TRUE(there().takes.empty());
    setOpenElsewhere(false);
    transfer(Transfer::kMove);
    EXPECT_EQ(there().takes.size(), 1U);

    setOpenElsewhere(true);
    model_.undoStack().undo();
    EXPECT_EQ(failed.count(), 3);
    EXPECT_EQ(there().takes.size(), 1U);
    EXPECT_EQ(model_.session().takes.size(), 1U);
    setOpenElsewhere(false);
    model_.undoStack().undo();
    EXPECT_EQ(model_.session().takes.size(), 2U);
    setOpenElsewhere(true);
    model_.undoStack().redo();
    EXPECT_EQ(failed.count(), 4);
    EXPECT_EQ(model_.session().takes.size(), 2U);
    EXPECT_TRUE(there().takes.empty());
}

TEST_F(SessionTransfersTest, ACopyStaysHereTooAndKeepsBothNames) {
    makeTake(other() / "takes" / "walk_001.noctule");
    const int steps = model_.undoStack().count();
    transfer(Transfer::kCopy);
    EXPECT_EQ(model_.session().takes.size(), 2U);
    EXPECT_EQ(model_.undoStack().count(), steps);
    EXPECT_EQ(there().takes.size(), 2U);
    EXPECT_TRUE(jobs_.all().back()->outcome().contains("as walk_002"))
        << jobs_.all().back()->outcome().toStdString();
}

TEST_F(SessionTransfersTest, ATakeThatAJobWorksOnAndASessionThatIsNoneAreTold) {
    QSignalSpy failed(&model_, &SessionModel::failed);
    auto kept = model_.keepInPlace(model_.takePath(0));
    transfer(Transfer::kMove);
    EXPECT_EQ(failed.count(), 1);
    transfer(Transfer::kCopy);
    EXPECT_EQ(failed.count(), 2) << "the copy would be torn";
    EXPECT_TRUE(there().takes.empty());
    kept.reset();
    model_.transferTake(0, QString::fromStdString((home_ / "nowhere").string()), Transfer::kMove);
    ASSERT_TRUE(waitFor([&] { return failed.count() == 3; }));
    EXPECT_TRUE(failed[2][0].toString().startsWith("walk_001 was not moved"))
        << failed[2][0].toString().toStdString();
    EXPECT_TRUE(isThere(takes() / "walk_001.noctule"));
    EXPECT_EQ(model_.session().takes.size(), 2U);
}

}  // namespace
}  // namespace noctule::ui
