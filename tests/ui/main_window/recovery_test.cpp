// SPDX-License-Identifier: Apache-2.0
// What the studio offers after a program died: recordings that broke off, and a session.json that cannot be
// read.
#include <QContextMenuEvent>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QSysInfo>

#include "tests/core/session/session_folder.h"
#include "tests/ui/main_window/studio_fixture.h"
#include "ui/style/theme.h"
#include "ui/views/session/recent_sessions.h"
#include "ui/views/session/session_list.h"
#include "ui/views/session/start_page.h"
#include "ui/views/take_list.h"
#include "ui/widgets/button.h"
#include "ui/widgets/problem_card.h"

namespace noctule::ui {
namespace {

using Takes = noctule::test::SessionFolder;

class Recovery : public test::StudioWindow {
protected:
    /// A session with one whole take, known to the start page, not open.
    void SetUp() override {
        StudioWindow::SetUp();
        QDir().mkpath(home());
        session_ = QDir(home()).filePath("Falls");
        ASSERT_TRUE(studio_->session().create(session_, "Falls"));
        studio_->session().close();
        Takes::makeTake(take("walk_001"));
    }

    std::filesystem::path take(const char* name) const {
        return QDir(session_).filePath(QString("takes/%1.noctule").arg(name)).toStdString();
    }
    void writeInto(const char* file, const QByteArray& bytes) {
        QFile written(QDir(session_).filePath(file));
        ASSERT_TRUE(written.open(QIODevice::WriteOnly));
        written.write(bytes);
    }
    bool openAndWait() {
        window_->open(session_);
        return waitFor([this] { return studio_->session().isOpen(); });
    }
    StartPage& startPage() { return dynamic_cast<StartPage&>(window_->page(Step::kStart)); }
    /// The cards of the start page after it has looked at the folders.
    QStringList cardsAfterALook() {
        window_->goTo(Step::kConnect);
        window_->goTo(Step::kStart);
        waitFor([this] { return studio_->jobs().idle(); });
        QStringList titles;
        for (const ProblemCard* card : startPage().problemCards())
            titles.append(card->title());
        return titles;
    }
    static void click(const QWidget& where, const QString& text) {
        Button* found = nullptr;
        waitFor([&] {
            for (Button* button : where.findChildren<Button*>())
                if (button->isVisible() && button->text() == text)
                    found = button;
            return found != nullptr;
        });
        ASSERT_TRUE(found) << "no button " << text.toStdString();
        QTest::mouseClick(found, Qt::LeftButton);
    }
    TakeState state(const char* name) const {
        const Session& session = studio_->session().session();
        return session.takes.at(static_cast<size_t>(session.findTake(name))).state;
    }
    /// Texts of the menu that a take has in the list.
    QStringList menuOf(const char* name) {
        auto* takes = window_->findChild<TakeList*>();
        const int row = studio_->session().session().findTake(name);
        if (!takes || row < 0)
            return {"there is no list or no such take"};
        QStringList texts;
        QTimer::singleShot(0, takes, [&texts] {
            if (QWidget* menu = QApplication::activePopupWidget()) {
                for (const QAction* action : menu->actions())
                    texts.append(action->text());
                menu->close();
            }
        });
        const QPoint at = takes->visualRect(takes->model()->index(row, 0)).center();
        QContextMenuEvent event(QContextMenuEvent::Mouse, at, takes->viewport()->mapToGlobal(at));
        QApplication::sendEvent(takes->viewport(), &event);
        return texts;
    }
    bool isRecovered(const char* name) {
        return waitFor([&] { return studio_->session().isOpen() && state(name) == TakeState::kRecovered; });
    }

    QString session_;
};

TEST_F(Recovery, ABrokenOffRecordingIsOfferedWithTheSession) {
    Takes::makeBrokenOff(take("fall_001"), 2);
    ASSERT_TRUE(openAndWait());
    EXPECT_EQ(state("fall_001"), TakeState::kRecording);
    ASSERT_EQ(window_->notices().titles(), QStringList{"Take fall_001 broke off"});
    click(window_->notices(), "Recover fall_001");
    ASSERT_TRUE(isRecovered("fall_001"));
    EXPECT_EQ(window_->notices().count(), 0);
    EXPECT_TRUE(QFile::exists(QDir(session_).filePath("trash/fall_001.noctule"))) << "the recording is kept";
    const auto overview = [this] { return studio_->take().overview(); };
    studio_->session().setCurrentTake(studio_->session().session().findTake("fall_001"));
    EXPECT_TRUE(waitFor([&] { return overview() && overview()->state == "recovered"; }));
}

TEST_F(Recovery, SeveralAreRecoveredAtOnceAndAClosedNoticeStaysClosed) {
    Takes::makeBrokenOff(take("fall_001"), 1);
    Takes::makeBrokenOff(take("fall_002"), 1);
    ASSERT_TRUE(openAndWait());
    ASSERT_EQ(window_->notices().titles(), QStringList{"2 takes broke off"});
    click(window_->notices(), "Recover all");
    EXPECT_EQ(window_->notices().count(), 0);
    studio_->session().rate(0, 3);
    EXPECT_EQ(window_->notices().count(), 0);
    EXPECT_TRUE(isRecovered("fall_001"));
    EXPECT_TRUE(isRecovered("fall_002"));
}

TEST_F(Recovery, TheStartPageRecoversATake) {
    Takes::makeBrokenOff(take("fall_001"), 2);
    ASSERT_EQ(cardsAfterALook(), QStringList{"Take fall_001 broke off"});
    click(startPage(), "Recover fall_001");
    ASSERT_TRUE(isRecovered("fall_001"));
    EXPECT_EQ(window_->step(), Step::kReview);
    EXPECT_EQ(window_->notices().titles().join('\n').toStdString(), "")
        << "nothing is offered that is being done, and nothing reads the file that is replaced";
    studio_->session().close();
    EXPECT_EQ(cardsAfterALook(), QStringList{"Take fall_001 was recovered"});
    ProblemCard& card = *startPage().problemCards().first();
    EXPECT_EQ(card.grab().toImage().pixelColor(1, card.height() / 2).name(), Theme::get().tokens().ok.name())
        << "it went well";
    EXPECT_FALSE(stateWords(startPage().sessionList().sessions().at(0)).state.contains("interrupted"));
}

TEST_F(Recovery, WhatAnotherProgramRecordsIsNotOffered) {
    Takes::makeBrokenOff(take("fall_001"), 1);
    RecentSession recent;
    recent.folder = session_;
    EXPECT_EQ(lookAt(recent, {}).interrupted.size(), 1U);
    writeInto("session.lock", QString("1\nnoctule\n%1\n").arg(QSysInfo::machineHostName()).toUtf8());
    EXPECT_TRUE(lookAt(recent, {}).interrupted.empty()) << "the first process of a machine lives";
}

TEST_F(Recovery, WhatAnotherProgramRecordsIsNotRecovered) {
    Takes::makeBrokenOff(take("fall_001"), 1);
    ASSERT_EQ(cardsAfterALook(), QStringList{"Take fall_001 broke off"});
    QProcess other;
    other.start("sleep", {"60"});
    ASSERT_TRUE(other.waitForStarted());
    writeInto("session.lock",
              QString("%1\nsleep\n%2\n").arg(other.processId()).arg(QSysInfo::machineHostName()).toUtf8());
    click(startPage(), "Recover fall_001");
    ASSERT_TRUE(waitFor([this] { return studio_->session().isOpen() && studio_->jobs().idle(); }));
    EXPECT_EQ(state("fall_001"), TakeState::kRecording);
    EXPECT_FALSE(menuOf("fall_001").contains("Recover"));
    other.kill();
    other.waitForFinished();
}

TEST_F(Recovery, TheTakeListRecoversATake) {
    Takes::makeBrokenOff(take("fall_001"), 1);
    ASSERT_TRUE(openAndWait());
    EXPECT_TRUE(menuOf("fall_001").contains("Recover"));
    EXPECT_FALSE(menuOf("walk_001").contains("Recover"));
}

TEST_F(Recovery, ADamagedSessionIsNotRecoveredWhenItIsOpenedLater) {
    Takes::makeBrokenOff(take("fall_001"), 1);
    ASSERT_EQ(cardsAfterALook(), QStringList{"Take fall_001 broke off"});
    writeInto("session.json", "{");
    click(startPage(), "Recover fall_001");
    ASSERT_TRUE(waitFor([this] { return window_->notices().count() == 1 && studio_->jobs().idle(); }));
    click(window_->notices(), "Rebuild session");
    ASSERT_TRUE(waitFor([this] { return studio_->session().isOpen() && studio_->jobs().idle(); }));
    EXPECT_EQ(state("fall_001"), TakeState::kRecording) << "nobody asked for it now";
}

TEST_F(Recovery, ADamagedSessionIsToldOnceAndRebuilt) {
    writeInto("session.json", "{\"format\": ");
    window_->open(session_);
    ASSERT_TRUE(waitFor([this] { return window_->notices().count() == 1; }));
    EXPECT_EQ(window_->notices().titles().first(), "“Falls” cannot be opened as it is");
    EXPECT_FALSE(studio_->session().isOpen());
    click(window_->notices(), "Rebuild session");
    ASSERT_TRUE(waitFor([this] { return studio_->session().isOpen(); }));
    EXPECT_EQ(studio_->session().session().findTake("walk_001"), 0);
    EXPECT_EQ(window_->notices().count(), 0);
    EXPECT_TRUE(QFile::exists(QDir(session_).filePath("session.json.damaged-1")));
}

TEST_F(Recovery, TheStartPageRebuildsASession) {
    writeInto("session.json", "nonsense");
    ASSERT_EQ(cardsAfterALook(), QStringList{"The list of “Falls” is damaged"});
    EXPECT_EQ(stateWords(startPage().sessionList().sessions().at(0)).state, "Can be rebuilt from its takes");
    click(startPage(), "Rebuild session");
    ASSERT_TRUE(waitFor([this] { return studio_->session().isOpen(); }));
    studio_->session().close();
    EXPECT_TRUE(cardsAfterALook().isEmpty());
}

TEST_F(Recovery, TakesWhoseListIsGoneMakeASessionAgain) {
    ASSERT_TRUE(QFile::remove(QDir(session_).filePath("session.json")));
    window_->open(session_);
    ASSERT_TRUE(waitFor([this] { return window_->notices().count() == 1; }));
    click(window_->notices(), "Rebuild session");
    EXPECT_TRUE(waitFor([this] { return studio_->session().isOpen(); }));
}

}  // namespace
}  // namespace noctule::ui
