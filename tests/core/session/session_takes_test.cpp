// SPDX-License-Identifier: Apache-2.0
// Takes of a session: found, named, imported, moved to the trash and back, recovered.
#include <algorithm>
#include <fstream>

#include "core/session/take_folder.h"
#include "tests/core/session/session_folder.h"
#include "tests/support/stage_fractions.h"

namespace noctule::test {
namespace {

namespace fs = std::filesystem;

using SessionTakes = SessionFolder;

TEST_F(SessionTakes, TakesThatSessionFileDoesNotKnowAppearInOrderOfCreation) {
    newSession();
    makeTake(takes() / "b_001.noctule", "2026-03-01T12:00:00Z");
    makeTake(takes() / "a_001.noctule", "2026-03-01T13:00:00Z", "Ada");
    addPoseRun(takes() / "a_001.noctule");
    std::ofstream(takes() / ".hidden.noctule") << "x";
    std::ofstream(takes() / "notes.txt") << "x";
    const Session session = opened();
    ASSERT_EQ(session.takes.size(), 2u);
    EXPECT_EQ(session.takes[0].name, "b_001");
    EXPECT_EQ(session.takes[0].duration_s, 2);
    EXPECT_FALSE(session.takes[0].processed);
    EXPECT_EQ(session.takes[1].file, "takes/a_001.noctule");
    EXPECT_EQ(session.takes[1].performer, "Ada");
    EXPECT_TRUE(session.takes[1].processed);
}

TEST_F(SessionTakes, MissingAndDamagedTakesAreListedWithTheirProblem) {
    newSession();
    makeTake(takes() / "gone_001.noctule");
    Session session = opened();
    session.takes[0].rating = 4;
    ASSERT_TRUE(saveSession(session));
    fs::remove(takes() / "gone_001.noctule");
    std::ofstream(takes() / "bad_001.noctule") << "no database at all, but long enough to look at";
    session = opened();
    ASSERT_EQ(session.takes.size(), 2u);
    const SessionTake& gone = session.takes[static_cast<size_t>(session.findTake("gone_001"))];
    EXPECT_EQ(gone.state, TakeState::kDamaged);
    EXPECT_EQ(gone.rating, 4);
    EXPECT_NE(gone.problem.find("takes/gone_001.noctule is not there"), std::string::npos) << gone.problem;
    const SessionTake& bad = session.takes[static_cast<size_t>(session.findTake("bad_001"))];
    EXPECT_EQ(bad.state, TakeState::kDamaged);
    EXPECT_EQ(bad.problem.find(home_.string()), std::string::npos) << bad.problem;
    EXPECT_NE(bad.problem.find("takes/bad_001.noctule"), std::string::npos) << bad.problem;
}

TEST_F(SessionTakes, NextNameLooksAtFolderTrashAndList) {
    Session session = newSession();
    EXPECT_EQ(nextTakeName(session, "walk"), "walk_001");
    makeTake(takes() / "walk_001.noctule");
    EXPECT_EQ(nextTakeName(session, "walk"), "walk_002");
    makeTake(folder() / "trash" / "walk_002.noctule");
    EXPECT_EQ(nextTakeName(session, "walk"), "walk_003");
    session.takes.emplace_back().name = "walk_003";
    EXPECT_EQ(nextTakeName(session, "walk_001"), "walk_004");
    EXPECT_EQ(nextTakeName(session, ""), "take_001");
    EXPECT_EQ(nextTakeName(session, "../over/there"), "___over_there_001");
    EXPECT_EQ(nextTakeName(session, "Grüße"), "Grüße_001");
}

TEST_F(SessionTakes, TheTrashBesideAFolderIsFoundHoweverTheFolderIsWritten) {
    newSession();
    makeTake(folder() / "trash" / "walk_001.noctule");
    for (const Path& written : {takes(), takes() / "", takes() / ".", folder() / "trash" / ".." / "takes"})
        EXPECT_EQ(nextTakePath(written, "walk").filename(), "walk_002.noctule") << written;
}

TEST_F(SessionTakes, ImportCopiesAndNeverOverwrites) {
    Session session = newSession();
    const Path original = makeTake(home_ / "elsewhere" / "walk_001.noctule", kCreated, "Ada");
    const auto first = importTake(session, original, {});
    ASSERT_TRUE(first) << first.error().text();
    EXPECT_EQ(first->name, "walk_001");
    EXPECT_EQ(first->performer, "Ada");
    EXPECT_TRUE(isThere(original));
    const auto second = importTake(session, original, {});
    ASSERT_TRUE(second);
    EXPECT_EQ(second->name, "walk_002");
    EXPECT_EQ(session.takes.size(), 2u);
    EXPECT_EQ(text(original), text(takes() / "walk_001.noctule"));
}

TEST_F(SessionTakes, ImportBringsTheLogAlong) {
    Session session = newSession();
    const Path original = makeBrokenOff(home_ / "elsewhere" / "walk_001.noctule", 3);
    const std::string log = text(original.string() + "-wal");
    const auto take = importTake(session, original, {});
    ASSERT_TRUE(take) << take.error().text();
    EXPECT_EQ(take->duration_s, 3);
    EXPECT_EQ(take->state, TakeState::kRecording);
    EXPECT_FALSE(isThere((takes() / "walk_001.noctule-wal")));
    EXPECT_EQ(text(original.string() + "-wal"), log);
}

TEST_F(SessionTakes, ImportOfSomethingElseLeavesNothing) {
    Session session = newSession();
    std::ofstream(home_ / "song.noctule") << "no take";
    const auto song = importTake(session, home_ / "song.noctule", {});
    ASSERT_FALSE(song);
    EXPECT_NE(song.error().message.find("song.noctule"), std::string::npos);
    EXPECT_FALSE(importTake(session, home_ / "nothing.noctule", {}));
    EXPECT_TRUE(session.takes.empty());
    EXPECT_TRUE(fs::is_empty(takes()));
}

TEST_F(SessionTakes, CancelledImportLeavesNothing) {
    Session session = newSession();
    const Path original = makeTake(home_ / "elsewhere" / "walk_001.noctule");
    CancelFlag cancel;
    cancel.cancel();
    const auto take = importTake(session, original, {nullptr, &cancel});
    ASSERT_FALSE(take);
    EXPECT_EQ(take.error().kind, ErrorKind::kCancelled);
    EXPECT_TRUE(fs::is_empty(takes()));
}

TEST_F(SessionTakes, TrashIsAWayBack) {
    Session session = newSession();
    makeTake(takes() / "walk_001.noctule", "2026-03-01T10:00:00Z");
    makeTake(takes() / "walk_002.noctule", "2026-03-01T11:00:00Z");
    session = opened();
    session.takes[0].rating = 5;
    const SessionTake first = session.takes[0];
    ASSERT_TRUE(trashTake(session, "walk_001"));
    EXPECT_EQ(session.findTake("walk_001"), -1);
    EXPECT_FALSE(isThere(takes() / "walk_001.noctule"));
    EXPECT_TRUE(isThere(folder() / "trash" / "walk_001.noctule"));
    ASSERT_TRUE(restoreTake(session, first));
    EXPECT_EQ(session.findTake("walk_001"), 0);
    EXPECT_EQ(session.takes[0].rating, 5);
    EXPECT_TRUE(isThere(takes() / "walk_001.noctule"));
    EXPECT_FALSE(trashTake(session, "walk_009"));
    EXPECT_FALSE(restoreTake(session, first));
}

TEST_F(SessionTakes, TrashKeepsAnOlderTakeOfTheSameName) {
    Session session = newSession();
    makeTake(takes() / "walk_001.noctule", "2026-03-01T10:00:00Z", "first");
    session = opened();
    ASSERT_TRUE(trashTake(session, "walk_001"));
    makeTake(takes() / "walk_001.noctule", "2026-03-01T11:00:00Z", "second");
    session = opened();
    const SessionTake second = session.takes[0];
    ASSERT_TRUE(trashTake(session, "walk_001"));
    ASSERT_TRUE(restoreTake(session, second));
    EXPECT_EQ(Take::open((takes() / "walk_001.noctule").string())->meta().at("performer"), "second");
    EXPECT_EQ(Take::open((folder() / "trash" / "walk_001.1.noctule").string())->meta().at("performer"),
              "first");
}

TEST_F(SessionTakes, TrashTakesTheLogAlong) {
    newSession();
    makeBrokenOff(takes() / "walk_001.noctule", 3);
    Session session = opened();
    const SessionTake take = session.takes.at(0);
    EXPECT_EQ(take.duration_s, 3);
    ASSERT_TRUE(trashTake(session, "walk_001"));
    EXPECT_TRUE(fs::is_empty(takes()));
    ASSERT_TRUE(restoreTake(session, take));
    EXPECT_EQ(session.takes.at(0).duration_s, 3);
}

TEST_F(SessionTakes, EntryWithoutAFileCanBeRemovedAndComesBack) {
    newSession();
    makeTake(takes() / "walk_001.noctule");
    Session session = opened();
    fs::remove(takes() / "walk_001.noctule");
    const SessionTake take = session.takes[0];
    ASSERT_TRUE(trashTake(session, "walk_001"));
    EXPECT_TRUE(session.takes.empty());
    ASSERT_TRUE(restoreTake(session, take));
    EXPECT_EQ(session.takes.at(0).state, TakeState::kDamaged);
}

TEST_F(SessionTakes, RecordingThatBrokeOffIsRecovered) {
    newSession();
    const Path path = makeBrokenOff(takes() / "walk_001.noctule", 3);
    const std::string file = text(path), log = text(path.string() + "-wal");
    Session session = opened();
    session.takes[0].notes = "the fall";
    EXPECT_EQ(session.takes[0].state, TakeState::kRecording);
    EXPECT_NE(session.takes[0].problem.find("safe"), std::string::npos);
    const auto recovered = recoverTake(session, "walk_001", {});
    ASSERT_TRUE(recovered) << recovered.error().text();
    ASSERT_EQ(session.takes.size(), 1u);
    EXPECT_EQ(session.takes[0].state, TakeState::kRecovered);
    EXPECT_EQ(session.takes[0].duration_s, 3);
    EXPECT_EQ(session.takes[0].notes, "the fall");
    EXPECT_EQ(session.takes[0].problem, "");
    const auto take = Take::open(path.string());
    ASSERT_TRUE(take);
    EXPECT_EQ(take->meta().at("state"), "recovered");
    EXPECT_EQ(take->meta().at("sample_count"), "3000");
    EXPECT_FALSE(isThere(path.string() + "-wal"));
    EXPECT_EQ(text(folder() / "trash" / "walk_001.noctule"), file);
    EXPECT_EQ(text(folder() / "trash" / "walk_001.noctule-wal"), log);
    EXPECT_FALSE(recoverTake(session, "walk_001", {}));
}

TEST_F(SessionTakes, OfADamagedRecordingWhatCanBeReadIsSaved) {
    newSession();
    const Path path = makeBrokenOff(takes() / "walk_001.noctule", 20);
    ASSERT_TRUE(Take::open(path.string(), Access::kReadWrite));  // SQLite brings the log into the file
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(fs::file_size(path) / 2));
    file << std::string(40000, '\x55');
    file.close();
    const std::string before = text(path);
    Session session = opened();
    ASSERT_EQ(session.takes.size(), 1u);
    const auto recovered = recoverTake(session, "walk_001", {});
    ASSERT_TRUE(recovered) << recovered.error().text();
    ASSERT_TRUE(*recovered);
    EXPECT_FALSE((*recovered)->empty());
    EXPECT_EQ(session.takes[0].state, TakeState::kRecovered);
    EXPECT_EQ(session.takes[0].duration_s, 20);
    EXPECT_EQ(text(folder() / "trash" / "walk_001.noctule"), before);
}

TEST_F(SessionTakes, RecordingOfWhichNothingCanBeReadIsLeftAsItIs) {
    newSession();
    const Path path = makeBrokenOff(takes() / "walk_001.noctule", 2);
    ASSERT_TRUE(Take::open(path.string(), Access::kReadWrite));  // SQLite brings the log into the file
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(100);
    file << std::string(16384 - 100, '\x55');  // the whole list of tables
    file.close();
    const std::string before = text(path);
    Session session = opened();
    ASSERT_EQ(session.takes.size(), 1u);
    EXPECT_FALSE(recoverTake(session, "walk_001", {}));
    EXPECT_EQ(text(path), before);
    EXPECT_FALSE(isThere(folder() / "trash" / "walk_001.noctule"));
}

TEST_F(SessionTakes, DamageThatOpeningDoesNotSeeIsMendedToo) {
    newSession();
    const Path path = takes() / "walk_001.noctule";
    fs::copy_file(NOCTULE_TEST_DATA "/takes/tiny_take.noctule", path);
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(fs::file_size(path) / 2));
    file << std::string(40000, '\xff');
    file.close();
    Session session = opened();
    ASSERT_EQ(session.takes.at(0).state, TakeState::kComplete) << session.takes[0].problem;
    StageFractions cancelled("Checking", 0.02);
    const auto stopped = recoverTake(session, "walk_001", cancelled.job());
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().kind, ErrorKind::kCancelled);
    StageFractions checking("Checking");
    const auto recovered = recoverTake(session, "walk_001", checking.job());
    ASSERT_TRUE(recovered) << recovered.error().text();
    ASSERT_TRUE(*recovered);
    EXPECT_EQ((*recovered)->tables.at(0).table, "adc_block");
    EXPECT_EQ(session.takes[0].state, TakeState::kRecovered);
    EXPECT_FALSE(checking.told.empty());
    EXPECT_TRUE(std::ranges::is_sorted(checking.told)) << "it is checked once";
}

TEST_F(SessionTakes, WhatCanBeReadOfATornTakeTakesItsPlace) {
    newSession();
    const Path path = takes() / "walk_001.noctule";
    fs::copy_file(NOCTULE_TEST_DATA "/takes/tiny_take.noctule", path);
    fs::resize_file(path, fs::file_size(path) / 2);
    const std::string torn = text(path);
    Session session = opened();
    ASSERT_EQ(session.takes.size(), 1u);
    ASSERT_TRUE(session.takes[0].is_torn) << session.takes[0].problem;
    const auto recovered = recoverTake(session, "walk_001", {});
    ASSERT_TRUE(recovered) << recovered.error().text();
    EXPECT_EQ(session.takes[0].state, TakeState::kRecovered);
    EXPECT_FALSE(session.takes[0].is_torn);
    EXPECT_EQ(text(folder() / "trash" / "walk_001.noctule"), torn);
}

TEST_F(SessionTakes, RenamingMovesTheFileAndKeepsWhatWasSaid) {
    newSession();
    makeBrokenOff(takes() / "walk_001.noctule", 2);
    Session session = opened();
    session.takes.at(0).rating = 4;
    ASSERT_TRUE(renameTake(session, "walk_001", "kick"));
    EXPECT_EQ(session.takes.at(0).name, "kick");
    EXPECT_EQ(session.takes.at(0).file, "takes/kick.noctule");
    EXPECT_EQ(session.takes.at(0).rating, 4);
    EXPECT_FALSE(isThere(takes() / "walk_001.noctule"));
    EXPECT_TRUE(isThere(takes() / "kick.noctule"));
    EXPECT_TRUE(isThere(takes() / "kick.noctule-wal")) << "what only the log holds comes along";
    ASSERT_TRUE(saveSession(session));
    session = opened();
    ASSERT_EQ(session.takes.size(), 1u);
    EXPECT_EQ(session.takes[0].rating, 4);
}

TEST_F(SessionTakes, RenamingNeverOverwrites) {
    newSession();
    for (const char* name : {"a", "b", "c"})
        makeTake(takes() / (std::string(name) + ".noctule"));
    Session session = opened();
    ASSERT_TRUE(trashTake(session, "c"));
    for (const char* taken : {"b", "c", "", "__", "x/y", "two words"}) {
        const Status status = renameTake(session, "a", taken);
        ASSERT_FALSE(status) << taken;
        EXPECT_EQ(status.error().kind, ErrorKind::kUsage);
    }
    EXPECT_TRUE(isThere(takes() / "a.noctule"));
    EXPECT_GE(session.findTake("a"), 0);
    EXPECT_EQ(cleanTakeName("two words"), "two_words");
    EXPECT_TRUE(renameTake(session, "a", "a"));
}

TEST_F(SessionTakes, RefreshSeesWhatProcessingAdded) {
    newSession();
    makeTake(takes() / "walk_001.noctule");
    Session session = opened();
    EXPECT_FALSE(session.takes[0].processed);
    addPoseRun(takes() / "walk_001.noctule");
    refreshTake(session, session.takes[0]);
    EXPECT_TRUE(session.takes[0].processed);
}

TEST_F(SessionTakes, OnlyTakesOfTheFolderAreAdded) {
    Session session = newSession();
    EXPECT_EQ(addTake(session, makeTake(home_ / "other" / "walk_001.noctule")), -1);
    EXPECT_EQ(addTake(session, takes() / "nothing.noctule"), -1);
    EXPECT_EQ(addTake(session, makeTake(takes() / "walk_001.noctule")), 0);
    EXPECT_EQ(addTake(session, takes() / "walk_001.noctule"), 0);
    EXPECT_EQ(session.takes.size(), 1u);
}

}  // namespace
}  // namespace noctule::test
