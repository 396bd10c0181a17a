// SPDX-License-Identifier: Apache-2.0
// Sessions and takes as the window opens them, and what it says about crashes.
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QSysInfo>
#include <algorithm>

#include "core/session/placement.h"
#include "core/suit/default_suit.h"
#include "tests/ui/main_window/studio_fixture.h"
#include "ui/models/session_marker.h"
#include "ui/views/review/review_page.h"
#include "ui/views/session/new_session_dialog.h"
#include "ui/views/session/recent_sessions.h"
#include "ui/views/session/session_list.h"
#include "ui/views/session/start_page.h"
#include "ui/views/take_list.h"
#include "ui/widgets/button.h"
#include "ui/widgets/empty_state.h"

namespace noctule::ui {
namespace {

class SessionInWindow : public test::StudioWindow {
protected:
    QString makeSession(const QString& name) {
        const QString folder = QDir(home()).filePath(name);
        QDir().mkpath(home());
        EXPECT_TRUE(studio_->session().create(folder, name));
        return folder;
    }
    /// A marker as a process leaves it that was killed.
    void leaveMarkerBehind(const QString& folder) {
        QFile marker(QDir(folder).filePath("session.lock"));
        ASSERT_TRUE(marker.open(QIODevice::WriteOnly));
        marker.write(
            QStringLiteral("%1\nnoctule\n%2\n").arg(999'999'999).arg(QSysInfo::machineHostName()).toUtf8());
    }
    bool isTold(const QString& words) {
        const auto labels = window_->notices().findChildren<QLabel*>();
        return std::ranges::any_of(labels,
                                   [&](const QLabel* label) { return label->text().contains(words); });
    }
    Button* noticeButton(const QString& text) {
        for (auto* button : window_->notices().findChildren<Button*>())
            if (button->text() == text)
                return button;
        return nullptr;
    }
};

TEST_F(SessionInWindow, ANewSessionIsAskedForWithNameFolderPerformerAndHeight) {
    NewSessionDialog dialog(*studio_, window_.get());
    EXPECT_FALSE(dialog.sessionName().isEmpty());
    EXPECT_TRUE(dialog.folder().startsWith(home())) << dialog.folder().toStdString();
    auto* name = dialog.findChild<QLineEdit*>();
    name->clear();
    QTest::keyClicks(name, "Kick study");
    EXPECT_EQ(QFileInfo(dialog.folder()).fileName(), "Kick study");
    dialog.accept();
    ASSERT_TRUE(studio_->session().isOpen());
    const Session& session = studio_->session().session();
    EXPECT_EQ(session.name, "Kick study");
    ASSERT_EQ(session.performers.size(), 1U);
    EXPECT_EQ(session.performers[0].name, "Performer 1");
    EXPECT_EQ(session.current_performer, "Performer 1");
    EXPECT_DOUBLE_EQ(session.performers[0].measures.height_m, 1.75);
    EXPECT_FALSE(studio_->session().undoStack().canUndo());
}

TEST_F(SessionInWindow, TheSuitOfANewSessionFitsTheHeightThatWasGiven) {
    NewSessionDialog dialog(*studio_, window_.get());
    dialog.findChild<QDoubleSpinBox*>()->setValue(1.95);
    dialog.accept();
    ASSERT_TRUE(studio_->session().isOpen());
    const Performer& performer = studio_->session().session().performers.at(0);
    EXPECT_DOUBLE_EQ(performer.measures.height_m, 1.95);
    BodyMeasures measures;
    measures.height_m = 1.95;
    const Suit fitted = suitOnActor(defaultSuit(), defaultActor(measures)), unfitted = defaultSuit();
    for (size_t i = 0; i < fitted.boards.size(); ++i)
        EXPECT_LT((performer.suit.boards[i].p_segment_board_m - fitted.boards[i].p_segment_board_m).norm(),
                  1e-12);
    const auto shin = static_cast<size_t>(fitted.findBoard("l_leg"));
    EXPECT_GT((fitted.boards[shin].p_segment_board_m - unfitted.boards[shin].p_segment_board_m).norm(), 0.01);
}

TEST_F(SessionInWindow, AFolderWithFilesIsRefusedInPlace) {
    QDir().mkpath(QDir(home()).filePath("Full"));
    QFile file(QDir(home()).filePath("Full/notes.txt"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    NewSessionDialog dialog(*studio_, window_.get());
    auto* name = dialog.findChild<QLineEdit*>();
    name->clear();
    QTest::keyClicks(name, "Full");
    dialog.accept();
    EXPECT_FALSE(studio_->session().isOpen());
    EXPECT_NE(dialog.result(), QDialog::Accepted);
}

TEST_F(SessionInWindow, AnEmptySessionOpensAtConnectAndIsRemembered) {
    const QString folder = makeSession("Stage tests");
    EXPECT_EQ(window_->step(), Step::kConnect);
    EXPECT_TRUE(window_->windowTitle().contains("Stage tests"));
    restart();
    RecentSessions recent(studio_->settings(), studio_->jobs());
    ASSERT_EQ(recent.all().size(), 1U);
    EXPECT_EQ(recent.all()[0].folder, folder);
    window_->open(folder);
    EXPECT_TRUE(waitFor([this] { return studio_->session().isOpen(); }));
}

TEST_F(SessionInWindow, AClosedSessionLeavesNoMarkerAndACrashIsTold) {
    const QString folder = makeSession("Stage tests");
    EXPECT_TRUE(QFileInfo::exists(QDir(folder).filePath("session.lock")));
    restart();
    EXPECT_FALSE(QFileInfo::exists(QDir(folder).filePath("session.lock")));

    leaveMarkerBehind(folder);
    RecentSession left;
    left.folder = folder;
    EXPECT_TRUE(lookAt(left, {}).left_open);
    window_->open(folder);
    ASSERT_TRUE(waitFor([this] { return studio_->session().isOpen(); }));
    ASSERT_EQ(window_->notices().count(), 1);
    EXPECT_EQ(window_->notices().titles().first(), "“Stage tests” was not closed last time");
    EXPECT_FALSE(SessionMarker::wasLeftBehind(folder));
}

TEST_F(SessionInWindow, ASecondWindowIsTold) {
    const QString folder = makeSession("Stage tests");
    SessionMarker other;
    EXPECT_EQ(other.mark(folder), SessionMarker::Finding::kInUse);
}

TEST_F(SessionInWindow, MissingFoldersAreNamedAndCanBeTakenOffTheList) {
    auto& page = dynamic_cast<StartPage&>(window_->page(Step::kStart));
    RecentSessions recent(studio_->settings(), studio_->jobs());
    recent.remember("/nowhere/gone");
    SessionList list(recent);
    recent.look();
    ASSERT_TRUE(waitFor([&] { return recent.all()[0].known; }));
    EXPECT_EQ(stateWords(recent.all()[0]).state, "The folder is not there");
    list.setFilter("some other");
    EXPECT_EQ(list.shownRows(), 0);
    list.setFilter("gone");
    EXPECT_EQ(list.shownRows(), 1);
    list.setCurrentIndex(list.model()->index(0, 0));
    QTest::keyClick(&list, Qt::Key_Delete);
    EXPECT_EQ(list.shownRows(), 0);
    EXPECT_EQ(page.sessionList().shownRows(), 0);
}

TEST_F(SessionInWindow, ATakeOutsideOfSessionsOpensInReviewAndOffersToBeImported) {
    const QString path = folder_.filePath("walk_001.noctule");
    ASSERT_TRUE(test::makeQuickTake(path.toStdString(), {}));
    window_->open(path);
    ASSERT_TRUE(waitFor([this] { return studio_->take().isOpen(); }));
    EXPECT_EQ(window_->step(), Step::kReview);
    EXPECT_EQ(window_->notices().titles(), QStringList{"walk_001 belongs to no session"});
}

TEST_F(SessionInWindow, ADamagedTakeIsToldInWords) {
    const QString path = folder_.filePath("broken.noctule");
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("this is no take");
    file.close();
    window_->open(path);
    ASSERT_TRUE(waitFor([this] { return window_->notices().count() > 0; }));
    EXPECT_TRUE(window_->notices().titles().first().contains("broken"))
        << window_->notices().titles().first().toStdString();
}

TEST_F(SessionInWindow, AFileThatIsNoTakeLeavesOpenWhatIsOpen) {
    openSampleTake();
    ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
    const QString before = studio_->take().path();
    const QString path = folder_.filePath("letter.noctule");
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray(5000, 'a'));
    file.close();
    window_->open(path);
    ASSERT_TRUE(waitFor([this] { return window_->notices().count() > 0; }));
    EXPECT_TRUE(isTold("is not a take"));
    EXPECT_FALSE(isTold("SQLite"));
    EXPECT_EQ(studio_->take().path(), before);
    EXPECT_TRUE(studio_->take().isOpen());
    EXPECT_EQ(studio_->session().currentTake(), 0);
}

TEST_F(SessionInWindow, WhileATakeOfNoSessionIsOpenNoneOfTheListIsHighlighted) {
    openSampleTake();
    ASSERT_TRUE(waitFor([this] { return studio_->jobs().idle(); }));
    auto* list = window_->findChild<TakeList*>();
    ASSERT_TRUE(list);
    ASSERT_TRUE(list->currentIndex().isValid());
    const QString path = folder_.filePath("walk_001.noctule");
    ASSERT_TRUE(test::makeQuickTake(path.toStdString(), {}));
    window_->open(path);
    ASSERT_TRUE(waitFor([&] { return studio_->take().isOpen() && studio_->take().path() == path; }));
    EXPECT_FALSE(list->currentIndex().isValid());
    EXPECT_TRUE(list->selectionModel()->selectedIndexes().isEmpty());
}

/// The first page from behind its header on; the list of tables stands at the page's end.
void tear(const QString& path, int to = 4096) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadWrite));
    file.seek(100);
    file.write(QByteArray(to - 100, '\xff'));
}

TEST_F(SessionInWindow, ADamagedTakeOffersAButtonAndNoShell) {
    const QString path = folder_.filePath("torn.noctule");
    ASSERT_TRUE(test::makeQuickTake(path.toStdString(), {}));
    tear(path);
    window_->open(path);
    ASSERT_TRUE(waitFor([this] { return window_->notices().count() > 0; }));
    EXPECT_EQ(window_->notices().titles(), QStringList{"torn is damaged"});
    EXPECT_FALSE(isTold("--batch"));
    Button* save = noticeButton("Save what can be read");
    ASSERT_TRUE(save);
    QTest::mouseClick(save, Qt::LeftButton);
    ASSERT_TRUE(waitFor([this] { return studio_->take().isOpen(); }));
    EXPECT_TRUE(window_->notices().titles().contains("torn was damaged; what could be read of it is saved"))
        << window_->notices().titles().join('\n').toStdString();
    EXPECT_TRUE(isTold("more may be lost"));
    EXPECT_FALSE(isTold("--batch"));
    EXPECT_TRUE(QFile::exists(path));
}

TEST_F(SessionInWindow, ATakeOfWhichNothingCanBeReadIsTold) {
    const QString path = folder_.filePath("torn.noctule");
    ASSERT_TRUE(test::makeQuickTake(path.toStdString(), {}));
    tear(path, 16384);
    window_->open(path);
    ASSERT_TRUE(waitFor([this] { return window_->notices().count() > 0; }));
    Button* save = noticeButton("Save what can be read");
    ASSERT_TRUE(save);
    QTest::mouseClick(save, Qt::LeftButton);
    const QStringList told{"torn could not be recovered; its file stays as it is"};
    EXPECT_TRUE(waitFor([&] { return window_->notices().titles() == told; }))
        << window_->notices().titles().join('\n').toStdString();
    EXPECT_TRUE(isTold("the beginning of the file is damaged"));
    EXPECT_FALSE(isTold("--batch"));
}

TEST_F(SessionInWindow, ADamagedTakeOfASessionOffersTheSame) {
    const QString folder = makeSession("Falls");
    studio_->session().close();
    const QString path = QDir(folder).filePath("takes/torn_001.noctule");
    QDir().mkpath(QFileInfo(path).path());
    ASSERT_TRUE(test::makeQuickTake(path.toStdString(), {}));
    tear(path);
    window_->open(folder);
    ASSERT_TRUE(waitFor([this] { return window_->notices().count() > 0; }));
    EXPECT_EQ(window_->notices().titles(), QStringList{"torn_001 is damaged"});
    EXPECT_FALSE(isTold("--batch"));
    EXPECT_TRUE(noticeButton("Save what can be read"));
}

TEST_F(SessionInWindow, ReviewOffersToSaveATakeThatCannotBeOpened) {
    const QString path = folder_.filePath("torn.noctule");
    ASSERT_TRUE(test::makeQuickTake(path.toStdString(), {}));
    tear(path);
    window_->open(path);
    ASSERT_TRUE(waitFor([this] { return window_->notices().count() > 0; }));
    window_->goTo(Step::kReview);
    EmptyState& empty = dynamic_cast<ReviewPage&>(window_->page(Step::kReview)).unreadable();
    ASSERT_TRUE(empty.isVisible());
    const QString sentence = empty.findChild<QLabel*>()->text();
    EXPECT_TRUE(sentence.startsWith("torn is damaged: ")) << sentence.toStdString();
    EXPECT_EQ(empty.button()->text(), "Save what can be read");
    QTest::mouseClick(empty.button(), Qt::LeftButton);
    ASSERT_TRUE(waitFor([this] { return studio_->take().isOpen(); }));
    EXPECT_FALSE(empty.isVisible());
    studio_->take().close();
    EXPECT_FALSE(empty.isVisible()) << "it is not the damaged one that is missing now";
}

}  // namespace
}  // namespace noctule::ui
