// SPDX-License-Identifier: Apache-2.0
#include "ui/models/session_model.h"

#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <fstream>

#include "core/session/session_json.h"
#include "tests/core/session/session_folder.h"
#include "tests/ui/support/wait.h"

namespace noctule::ui {
namespace {

class SessionModelTest : public noctule::test::SessionFolder {
protected:
    void SetUp() override {
        QSettings().clear();
        newSession();
        makeTake(takes() / "walk_001.noctule", "2026-03-01T10:00:00Z", "Performer 1");
        makeTake(takes() / "walk_002.noctule", "2026-03-01T11:00:00Z", "Performer 1");
        makeTake(takes() / "turn_001.noctule", "2026-03-01T12:00:00Z", "Performer 1");
    }

    QString qfolder() const { return QString::fromStdString(folder().string()); }
    bool openAndWait() {
        model_.open(qfolder());
        return waitFor([this] { return model_.isOpen() && jobs_.idle(); });
    }
    nlohmann::json shown() const { return toJson(model_.session()); }
    nlohmann::json onDisk() const { return nlohmann::json::parse(text(folder() / "session.json")); }
    const Performer& performer() const { return model_.session().performers.at(0); }

    Jobs jobs_;
    SessionModel model_{jobs_, [this] { return QString::fromStdString(folder().parent_path().string()); }};
};

TEST_F(SessionModelTest, OpensWithTheNewestTakeCurrent) {
    QSignalSpy opened(&model_, &SessionModel::opened);
    EXPECT_FALSE(model_.isOpen());
    ASSERT_TRUE(openAndWait());
    EXPECT_EQ(opened.count(), 1);
    EXPECT_EQ(model_.session().takes.size(), 3u);
    EXPECT_EQ(model_.currentTake(), 2);
    EXPECT_FALSE(model_.undoStack().canUndo());
}

TEST_F(SessionModelTest, CurrentTakeIsRememberedAndCanBeAskedFor) {
    ASSERT_TRUE(openAndWait());
    model_.setCurrentTake(0);
    model_.close();
    EXPECT_EQ(model_.currentTake(), -1);
    ASSERT_TRUE(openAndWait());
    EXPECT_EQ(model_.currentTake(), 0);
    QSignalSpy opened(&model_, &SessionModel::opened);
    model_.open(qfolder(), "walk_002");
    ASSERT_TRUE(waitFor([&] { return opened.count() == 1; }));
    EXPECT_EQ(model_.currentTake(), 1);
}

TEST_F(SessionModelTest, EveryCommandIsUndoneAndDoneAgain) {
    ASSERT_TRUE(openAndWait());
    Performer second = performer();
    second.name = "Ada";
    Performer taller = performer();
    taller.measures.height_m = 1.9;
    Performer renamed = performer();
    renamed.name = "Grace";
    const std::function<void()> commands[] = {
        [&] { model_.rate(1, 4); },
        [&] { model_.setTakeNotes(0, "Good one"); },
        [&] { model_.setTakeRange(2, 0.5, 1.5); },
        [&] { model_.renameSession("Other"); },
        [&] { model_.setNotes("Tuesday"); },
        [&] { model_.addPerformer(second); },
        [&] { model_.changePerformer(0, taller, "Height"); },
        [&] { model_.changePerformer(0, renamed, "Name"); },
        [&] { model_.setCurrentPerformer("Ada"); },
        [&] { model_.removePerformer(1); },
        [&] { model_.renameTake(1, "high kick"); },
        [&] { model_.trashTake(1); },
    };
    for (const auto& command : commands) {
        const nlohmann::json before = shown();
        const int count = model_.undoStack().count();
        QSignalSpy changed(&model_, &SessionModel::changed);
        command();
        const nlohmann::json after = shown();
        EXPECT_NE(after, before);
        ASSERT_EQ(model_.undoStack().count(), count + 1);
        EXPECT_FALSE(model_.undoStack().undoText().isEmpty());
        model_.undoStack().undo();
        EXPECT_EQ(shown(), before) << model_.undoStack().redoText().toStdString();
        model_.undoStack().redo();
        EXPECT_EQ(shown(), after) << model_.undoStack().undoText().toStdString();
        EXPECT_EQ(changed.count(), 3);
    }
    const nlohmann::json last = shown();
    while (model_.undoStack().canUndo())
        model_.undoStack().undo();
    while (model_.undoStack().canRedo())
        model_.undoStack().redo();
    EXPECT_EQ(shown(), last);
}

TEST_F(SessionModelTest, NothingIsPushedWhenNothingChanges) {
    ASSERT_TRUE(openAndWait());
    model_.rate(0, 0);
    model_.setTakeNotes(0, "");
    model_.renameSession("Stage tests");
    model_.setCurrentPerformer("Performer 1");
    model_.removePerformer(0);  // the last one stays
    model_.rate(17, 3);
    EXPECT_EQ(model_.undoStack().count(), 0);
    EXPECT_EQ(model_.session().performers.size(), 1u);
}

TEST_F(SessionModelTest, ChangesWithOneKeyAreOneStep) {
    ASSERT_TRUE(openAndWait());
    const nlohmann::json before = shown();
    for (int i = 1; i <= 50; ++i) {
        Performer dragged = performer();
        dragged.suit.boards[3].p_segment_board_m.x() = i * 0.001;
        model_.changePerformer(0, dragged, "Move", "board 3");
    }
    Performer other = performer();
    other.suit.boards[4].p_segment_board_m.x() = 1;
    model_.changePerformer(0, other, "Move", "board 4");
    EXPECT_EQ(model_.undoStack().count(), 2);
    model_.undoStack().undo();
    EXPECT_EQ(performer().suit.boards[3].p_segment_board_m.x(), 0.05);
    model_.undoStack().undo();
    EXPECT_EQ(shown(), before);
}

TEST_F(SessionModelTest, NewNameGoesToTheTakes) {
    ASSERT_TRUE(openAndWait());
    Performer renamed = performer();
    renamed.name = "Grace";
    model_.changePerformer(0, renamed, "Name");
    EXPECT_EQ(model_.session().current_performer, "Grace");
    EXPECT_EQ(model_.session().takes[1].performer, "Grace");
}

TEST_F(SessionModelTest, ChangesAreOnDiskWithinASecond) {
    ASSERT_TRUE(openAndWait());
    model_.rate(0, 3);
    model_.setTakeNotes(0, "fine");
    ASSERT_TRUE(QTest::qWaitFor([&] { return onDisk() == shown(); }, 240'000));
    model_.undoStack().undo();
    ASSERT_TRUE(QTest::qWaitFor([&] { return onDisk() == shown(); }, 240'000));
    EXPECT_EQ(onDisk()["takes"][0]["notes"], "");
}

TEST_F(SessionModelTest, ClosingAndSaveNowWriteAtOnce) {
    ASSERT_TRUE(openAndWait());
    model_.rate(0, 3);
    model_.saveNow();
    EXPECT_EQ(onDisk(), shown());
    model_.rate(0, 4);
    model_.close();
    EXPECT_EQ(onDisk()["takes"][0]["rating"], 4);
}

TEST_F(SessionModelTest, SavingThatFailsIsToldOnceAndTriedAgain) {
    ASSERT_TRUE(openAndWait());
    QSignalSpy failed(&model_, &SessionModel::notSaved);
    std::filesystem::rename(folder(), home_ / "away");
    model_.rate(0, 3);
    ASSERT_TRUE(waitFor([&] { return failed.count() == 1; }));
    EXPECT_TRUE(failed[0][0].toString().contains("is not there any more"));
    EXPECT_FALSE(model_.whyNotHere().isEmpty());
    model_.rate(0, 4);
    QTest::qWait(600);
    EXPECT_EQ(failed.count(), 1);
    std::filesystem::rename(home_ / "away", folder());
    model_.rate(0, 5);
    ASSERT_TRUE(waitFor([&] { return onDisk() == shown(); }));
    EXPECT_EQ(model_.whyNotHere(), "");
}

TEST_F(SessionModelTest, WhereNothingCanBeWrittenTakesAreSafe) {
    ASSERT_TRUE(openAndWait());
    QSignalSpy failed(&model_, &SessionModel::notSaved);
    std::filesystem::remove(folder() / "session.json");
    std::filesystem::create_directory(folder() / "session.json");
    model_.rate(0, 3);
    ASSERT_TRUE(waitFor([&] { return failed.count() == 1; }));
    EXPECT_TRUE(failed[0][0].toString().contains("Your takes are safe"));
    std::filesystem::remove(folder() / "session.json");
}

TEST_F(SessionModelTest, TrashMovesTheFileAndTheCurrentTakeFollows) {
    ASSERT_TRUE(openAndWait());
    model_.setCurrentTake(1);
    QSignalSpy current(&model_, &SessionModel::currentTakeChanged);
    model_.trashTake(0);
    EXPECT_FALSE(isThere(takes() / "walk_001.noctule"));
    EXPECT_EQ(model_.currentTake(), 0);
    EXPECT_EQ(model_.session().takes[0].name, "walk_002");
    model_.undoStack().undo();
    EXPECT_TRUE(isThere(takes() / "walk_001.noctule"));
    EXPECT_EQ(model_.currentTake(), 1);
    model_.trashTake(1);
    EXPECT_EQ(model_.session().takes.at(static_cast<size_t>(model_.currentTake())).name, "turn_001");
    EXPECT_EQ(current.count(), 3);
}

TEST_F(SessionModelTest, RenamingMovesTheFileAndTheCurrentTakeStays) {
    ASSERT_TRUE(openAndWait());
    model_.setCurrentTake(0);
    QSignalSpy current(&model_, &SessionModel::currentTakeChanged);
    QSignalSpy renamed(&model_, &SessionModel::takeRenamed);
    model_.renameTake(0, " kick 7 ");
    EXPECT_EQ(model_.session().takes[0].name, "kick_7");
    EXPECT_TRUE(isThere(takes() / "kick_7.noctule"));
    EXPECT_EQ(renamed.count(), 1);
    EXPECT_TRUE(renamed[0][0].toString().endsWith("/walk_001.noctule"));
    EXPECT_TRUE(renamed[0][1].toString().endsWith("/kick_7.noctule"));
    model_.undoStack().undo();
    EXPECT_TRUE(isThere(takes() / "walk_001.noctule"));
    EXPECT_FALSE(isThere(takes() / "kick_7.noctule"));
    EXPECT_EQ(model_.currentTake(), 0);
    EXPECT_EQ(current.count(), 0);
}

TEST_F(SessionModelTest, RenamingOverwritesNothing) {
    ASSERT_TRUE(openAndWait());
    QSignalSpy failed(&model_, &SessionModel::failed);
    model_.renameTake(0, "walk_002");
    EXPECT_EQ(failed.count(), 1);
    EXPECT_EQ(model_.undoStack().count(), 0);
    model_.renameTake(0, "  ");
    model_.renameTake(0, "walk_001");
    EXPECT_EQ(failed.count(), 1);
    EXPECT_EQ(model_.session().takes[0].name, "walk_001");
}

TEST_F(SessionModelTest, ThatItCouldNotBeSavedIsOverWithTheNextSave) {
    ASSERT_TRUE(openAndWait());
    QSignalSpy failed(&model_, &SessionModel::notSaved), again(&model_, &SessionModel::savedAgain);
    const auto away = folder().parent_path() / "away";
    std::filesystem::rename(folder(), away);
    model_.rate(0, 4);
    ASSERT_TRUE(waitFor([&] { return failed.count() == 1; }));
    std::filesystem::rename(away, folder());
    model_.rate(0, 5);
    ASSERT_TRUE(waitFor([&] { return again.count() == 1; }));
    EXPECT_EQ(again[0][0], failed[0][0]) << "what was told";
    model_.rate(0, 3);
    EXPECT_TRUE(waitFor([&] { return jobs_.idle(); }));
    EXPECT_EQ(again.count(), 1);
}

TEST_F(SessionModelTest, ATakeThatAJobWorksOnStaysWhereItIs) {
    ASSERT_TRUE(openAndWait());
    QSignalSpy failed(&model_, &SessionModel::failed);
    auto kept = model_.keepInPlace(QString::fromStdString((takes() / "walk_001.noctule").string()));
    model_.renameTake(0, "kick");
    model_.trashTake(0);
    EXPECT_EQ(failed.count(), 2);
    EXPECT_TRUE(isThere(takes() / "walk_001.noctule"));
    kept.reset();
    model_.renameTake(0, "kick");
    EXPECT_TRUE(isThere(takes() / "kick.noctule"));
}

TEST_F(SessionModelTest, AStepThatIsRefusedStaysWhereItIs) {
    ASSERT_TRUE(openAndWait());
    const std::unique_ptr<QAction> undo(model_.undoStack().createUndoAction(nullptr)),
        redo(model_.undoStack().createRedoAction(nullptr));
    model_.rate(0, 4);
    model_.renameTake(0, "kick");
    auto kept = model_.keepInPlace(QString::fromStdString((takes() / "kick.noctule").string()));
    QSignalSpy failed(&model_, &SessionModel::failed);
    undo->trigger();
    EXPECT_EQ(failed.count(), 1);
    EXPECT_EQ(model_.undoStack().index(), 2);
    EXPECT_EQ(model_.session().takes[0].rating, 4);
    kept.reset();
    undo->trigger();
    EXPECT_EQ(model_.session().takes[0].name, "walk_001");
    undo->trigger();
    EXPECT_EQ(model_.session().takes[0].rating, 0);

    redo->trigger();
    kept = model_.keepInPlace(QString::fromStdString((takes() / "walk_001.noctule").string()));
    redo->trigger();
    EXPECT_EQ(failed.count(), 2);
    EXPECT_EQ(model_.undoStack().index(), 1);
    model_.trashTake(0);
    EXPECT_EQ(failed.count(), 3);
    EXPECT_EQ(model_.undoStack().count(), 2) << "what fails costs nothing that could be done again";
    kept.reset();
    redo->trigger();
    EXPECT_TRUE(isThere(takes() / "kick.noctule"));
}

TEST_F(SessionModelTest, ClosingForgetsSteps) {
    ASSERT_TRUE(openAndWait());
    model_.rate(0, 4);
    model_.close();
    EXPECT_EQ(model_.undoStack().count(), 0);
    model_.undoStack().push(new QUndoCommand("a marker of a take that belongs to no session"));
    ASSERT_TRUE(openAndWait());
    EXPECT_EQ(model_.undoStack().count(), 0);
}

TEST_F(SessionModelTest, TrashThatFailsChangesNothing) {
    ASSERT_TRUE(openAndWait());
    std::filesystem::create_directories(folder() / "trash" / "walk_001.noctule");
    std::filesystem::remove_all(folder() / "trash");
    std::filesystem::copy_file(takes() / "walk_001.noctule", folder() / "trash");  // a file in the way
    QSignalSpy failed(&model_, &SessionModel::failed);
    model_.trashTake(0);
    EXPECT_EQ(failed.count(), 1);
    EXPECT_EQ(model_.session().takes.size(), 3u);
    EXPECT_EQ(model_.undoStack().count(), 0);
    EXPECT_TRUE(isThere(takes() / "walk_001.noctule"));
}

TEST_F(SessionModelTest, ImportedTakesAppearAndBadOnesAreTold) {
    ASSERT_TRUE(openAndWait());
    makeTake(home_ / "elsewhere" / "walk_001.noctule");
    QSignalSpy failed(&model_, &SessionModel::failed);
    const auto path = [&](const char* name) {
        return QString::fromStdString((home_ / "elsewhere" / name).string());
    };
    model_.importTakes({path("walk_001.noctule"), path("nothing.noctule")});
    ASSERT_TRUE(waitFor([&] { return jobs_.idle(); }));
    ASSERT_EQ(model_.session().takes.size(), 4u);
    EXPECT_EQ(model_.session().takes[static_cast<size_t>(model_.currentTake())].name, "walk_003");
    ASSERT_EQ(failed.count(), 1);
    EXPECT_TRUE(failed[0][0].toString().contains("nothing.noctule"));
}

TEST_F(SessionModelTest, InterruptedTakeIsRecovered) {
    makeBrokenOff(takes() / "fall_001.noctule", 2);
    ASSERT_TRUE(openAndWait());
    const int index = model_.session().findTake("fall_001");
    ASSERT_GE(index, 0);
    EXPECT_EQ(model_.session().takes[static_cast<size_t>(index)].state, TakeState::kRecording);
    model_.recover(index);
    ASSERT_TRUE(waitFor(
        [&] { return model_.session().takes[static_cast<size_t>(index)].state == TakeState::kRecovered; }));
}

TEST_F(SessionModelTest, HowMuchOfADamagedTakeIsSavedIsTold) {
    const auto torn = takes() / "torn_001.noctule";
    std::filesystem::copy_file(NOCTULE_TEST_DATA "/takes/tiny_take.noctule", torn);
    std::filesystem::resize_file(torn, std::filesystem::file_size(torn) / 2);
    ASSERT_TRUE(openAndWait());
    QSignalSpy warned(&model_, &SessionModel::warned);
    model_.recover(model_.session().findTake("torn_001"));
    ASSERT_TRUE(waitFor([&] { return warned.count() == 1; }));
    const QString told = warned[0][0].toString();
    EXPECT_TRUE(told.startsWith("torn_001 was damaged; what could be read of it is saved. Saved of it: 1."))
        << told.toStdString();
    EXPECT_TRUE(told.contains(" s of 2.02 s of the sound, ")) << told.toStdString();
    EXPECT_TRUE(told.endsWith("; everything else is complete.")) << told.toStdString();
}

TEST_F(SessionModelTest, DamagedSessionIsToldAndRebuilt) {
    noctule::test::SessionFolder::makeTake(takes() / "walk_004.noctule");
    std::ofstream(folder() / "session.json", std::ios::trunc) << "{";
    QSignalSpy failed(&model_, &SessionModel::failed), damaged(&model_, &SessionModel::damaged);
    model_.open(qfolder());
    ASSERT_TRUE(waitFor([&] { return damaged.count() == 1; }));
    EXPECT_EQ(failed.count(), 0) << "it is told once";
    EXPECT_TRUE(damaged[0][1].toString().contains("4 takes are safe"));
    EXPECT_FALSE(model_.isOpen());
    model_.rebuild(damaged[0][0].toString());
    ASSERT_TRUE(waitFor([&] { return model_.isOpen(); }));
    EXPECT_EQ(model_.session().takes.size(), 4u);
}

TEST_F(SessionModelTest, FailedOpeningKeepsTheOpenSession) {
    ASSERT_TRUE(openAndWait());
    QSignalSpy failed(&model_, &SessionModel::failed);
    model_.open(qfolder() + "/nowhere");
    ASSERT_TRUE(waitFor([&] { return failed.count() == 1; }));
    EXPECT_TRUE(model_.isOpen());
}

TEST_F(SessionModelTest, CreatingOpensAndRefusesAFullFolder) {
    QSignalSpy failed(&model_, &SessionModel::failed);
    EXPECT_FALSE(model_.create(qfolder(), "Second"));
    EXPECT_EQ(failed.count(), 1);
    EXPECT_FALSE(model_.isOpen());
    EXPECT_TRUE(model_.create(QString::fromStdString((home_ / "second").string()), "Second"));
    EXPECT_EQ(model_.session().name, "Second");
    EXPECT_EQ(model_.currentTake(), -1);
}

TEST_F(SessionModelTest, RefreshFindsNewTakesOfTheFolder) {
    ASSERT_TRUE(openAndWait());
    const auto path = makeTake(takes() / "walk_009.noctule", "2026-03-01T09:00:00Z");
    model_.setCurrentTake(0);
    model_.refresh(QString::fromStdString(path.string()));
    EXPECT_EQ(model_.session().takes.front().name, "walk_009");
    EXPECT_EQ(model_.session().takes[static_cast<size_t>(model_.currentTake())].name, "walk_001");
}

}  // namespace
}  // namespace noctule::ui
