// SPDX-License-Identifier: Apache-2.0
// Takes go from one session to another and back: by another name within a file system, by a copy elsewhere.
#include "core/session/take_transfer.h"

#include <algorithm>

#include "core/recording/database.h"
#include "core/session/take_folder.h"
#include "tests/core/session/session_folder.h"
#include "tests/support/take_files.h"

namespace noctule::test {
namespace {

namespace fs = std::filesystem;

class TakeTransferTest : public SessionFolder {
protected:
    void SetUp() override {
        Session session = newSession();
        session.performers[0].name = "Ada";
        session.performers[0].measures.height_m = 1.93;
        session.current_performer = "Ada";
        ASSERT_TRUE(saveSession(session));
        makeTake(takes() / "walk_001.noctule", kCreated, "Ada");
        addPoseRun(takes() / "walk_001.noctule");
        ASSERT_TRUE(createSession(other(), "Other stage", kCreated));
        here_ = opened();
        SessionTake& take = here_.takes[0];
        take.rating = 4;
        take.notes = "strap was loose";
        take.in_s = 0.5;
        take.unknown["x_mine"] = 7;
    }

    Path other() const { return home_ / "other"; }
    Session there() const { return openSession(other(), {}).value(); }
    TakeTransfer arranged() const { return arrangeTransfer(here_, "walk_001", other()).value(); }
    Path makeAnotherTake(const Path& path) const {
        makeTake(path, "2026-01-01T00:00:00Z", "Bea");
        runSql(path.string(), "UPDATE meta SET value='another' WHERE key='uuid'");
        return path;
    }
    /// Nothing is left that is being written.
    static bool isTidy(const Path& folder) {
        return std::ranges::all_of(fs::directory_iterator(folder), [](const fs::directory_entry& entry) {
            return entry.path().extension() == kTakeExtension;
        });
    }
    void expectAsItWas(const SessionTake& take, const std::string& name) const {
        EXPECT_EQ(take.name, name);
        EXPECT_EQ(take.rating, 4);
        EXPECT_EQ(take.notes, "strap was loose");
        EXPECT_EQ(take.in_s, 0.5);
        EXPECT_EQ(take.unknown["x_mine"], 7);
        EXPECT_EQ(take.performer, "Ada");
        EXPECT_TRUE(take.processed) << "its result came along";
        EXPECT_EQ(take.problem, "");
    }

    Session here_;
};

TEST_F(TakeTransferTest, AMoveAndItsWayBack) {
    const std::string bytes = text(takes() / "walk_001.noctule");
    for (const bool by_copy : {false, true}) {
        TakeTransfer transfer = arranged();
        EXPECT_EQ(transfer.to_name, "Other stage");
        EXPECT_TRUE(canBeRenamed(here_, transfer));
        if (by_copy) {
            ASSERT_TRUE(copyThere(here_, transfer, {}));
        }
        for (int round = 0; round < 2; ++round) {
            ASSERT_TRUE(moveThere(here_, transfer));
            EXPECT_TRUE(here_.takes.empty());
            EXPECT_FALSE(isThere(takes() / "walk_001.noctule"));
            const Session there = this->there();
            ASSERT_EQ(there.takes.size(), 1U);
            expectAsItWas(there.takes[0], "walk_001");
            ASSERT_TRUE(there.findPerformer("Ada"));
            EXPECT_EQ(there.findPerformer("Ada")->measures.height_m, 1.93);
            EXPECT_EQ(text(other() / "takes" / "walk_001.noctule"), bytes);

            ASSERT_TRUE(moveBack(here_, transfer));
            ASSERT_EQ(here_.takes.size(), 1U);
            expectAsItWas(here_.takes[0], "walk_001");
            EXPECT_EQ(text(takes() / "walk_001.noctule"), bytes);
            EXPECT_TRUE(this->there().takes.empty());
            EXPECT_FALSE(this->there().findPerformer("Ada"));
        }
        EXPECT_TRUE(isTidy(takes()) && isTidy(other() / "takes"));
        fs::remove_all(other() / "trash");  // what the way back of a copy leaves there
    }
}

TEST_F(TakeTransferTest, AnotherTakeThatHasTheNameByNowStays) {
    for (const bool by_copy : {false, true}) {
        TakeTransfer transfer = arranged();
        if (by_copy) {
            ASSERT_TRUE(copyThere(here_, transfer, {}));
        }
        ASSERT_TRUE(moveThere(here_, transfer));
        const Path place = other() / "takes" / "walk_001.noctule";
        fs::rename(place, home_ / "aside");
        makeAnotherTake(place);
        const std::string bytes = text(place);
        EXPECT_NE(moveBack(here_, transfer).error().text().find("another take"), std::string::npos);
        EXPECT_EQ(text(place), bytes);
        fs::rename(home_ / "aside", place);
        ASSERT_TRUE(moveBack(here_, transfer));
        if (by_copy) {
            makeAnotherTake(place);
            EXPECT_FALSE(moveThere(here_, transfer));
            EXPECT_TRUE(isThere(takes() / "walk_001.noctule"));
            EXPECT_EQ(text(place), bytes);
            fs::remove(place);
        }
        fs::remove_all(other() / "trash");
    }
}

TEST_F(TakeTransferTest, ANameThatIsTakenKeepsBoth) {
    makeTake(other() / "takes" / "walk_001.noctule", "2026-01-01T00:00:00Z", "Bea");
    makeTake(other() / "trash" / "walk_002.noctule");
    const std::string bytes = text(other() / "takes" / "walk_001.noctule");
    TakeTransfer transfer = arranged();
    EXPECT_EQ(transfer.take.name, "walk_003");
    ASSERT_TRUE(copyThere(here_, transfer, {}));
    EXPECT_EQ(here_.takes.size(), 1U) << "a copy leaves the original";
    const Session there = this->there();
    ASSERT_EQ(there.takes.size(), 2U);
    expectAsItWas(there.takes[1], "walk_003");
    EXPECT_EQ(text(other() / "takes" / "walk_001.noctule"), bytes);
    EXPECT_FALSE(copyThere(here_, transfer, {})) << "somebody took the name meanwhile";
    EXPECT_EQ(this->there().takes.size(), 2U);
}

TEST_F(TakeTransferTest, CancelledItLeavesNothing) {
    CancelFlag cancel;
    cancel.cancel();
    TakeTransfer transfer = arranged();
    EXPECT_EQ(copyThere(here_, transfer, {nullptr, &cancel}).error().kind, ErrorKind::kCancelled);
    EXPECT_TRUE(fs::is_empty(other() / "takes"));
    EXPECT_TRUE(there().takes.empty());
}

TEST_F(TakeTransferTest, WhatCannotGoSaysWhy) {
    EXPECT_EQ(arrangeTransfer(here_, "walk_001", folder()).error().kind, ErrorKind::kUsage);
    EXPECT_EQ(arrangeTransfer(here_, "walk_009", other()).error().kind, ErrorKind::kUsage);
    EXPECT_EQ(arrangeTransfer(here_, "walk_001", home_ / "nowhere").error().kind, ErrorKind::kUnreadable);
    here_.takes[0].state = TakeState::kRecording;
    EXPECT_NE(arrangeTransfer(here_, "walk_001", other()).error().text().find("Recover it"),
              std::string::npos);
}

TEST_F(TakeTransferTest, WhatTheListSaysMeanwhileGoesAlong) {
    for (const bool by_copy : {false, true}) {
        TakeTransfer transfer = arranged();
        if (by_copy) {
            ASSERT_TRUE(copyThere(here_, transfer, {}));
        }
        here_.takes[0].rating = by_copy ? 1 : 2;
        here_.takes[0].notes = "better than it looked";
        here_.takes[0].out_s = 1.5;
        followList(here_, transfer);
        ASSERT_TRUE(moveThere(here_, transfer));
        const Session there = this->there();
        ASSERT_EQ(there.takes.size(), 1U);
        EXPECT_EQ(there.takes[0].rating, by_copy ? 1 : 2);
        EXPECT_EQ(there.takes[0].notes, "better than it looked");
        EXPECT_EQ(there.takes[0].out_s, 1.5);
        ASSERT_TRUE(moveBack(here_, transfer));
        ASSERT_EQ(here_.takes.size(), 1U);
        EXPECT_EQ(here_.takes[0].rating, by_copy ? 1 : 2);
    }
}

TEST_F(TakeTransferTest, ATakeThatWasChangedAfterItsCopyStays) {
    TakeTransfer transfer = arranged();
    ASSERT_TRUE(copyThere(here_, transfer, {}));
    ASSERT_TRUE(moveThere(here_, transfer));
    ASSERT_TRUE(moveBack(here_, transfer));
    addPoseRun(takes() / "walk_001.noctule");  // the copy in the trash there lacks it
    const std::string bytes = text(takes() / "walk_001.noctule");
    EXPECT_EQ(moveThere(here_, transfer).error().kind, ErrorKind::kUnusable);
    EXPECT_EQ(here_.takes.size(), 1U);
    EXPECT_EQ(text(takes() / "walk_001.noctule"), bytes);
    EXPECT_TRUE(there().takes.empty());

    TakeTransfer anew = arranged();
    ASSERT_TRUE(copyThere(here_, anew, {}));
    addPoseRun(takes() / "walk_001.noctule");
    EXPECT_EQ(moveThere(here_, anew).error().kind, ErrorKind::kUnusable);
    EXPECT_EQ(here_.takes.size(), 1U);
    EXPECT_TRUE(isThere(takes() / "walk_001.noctule"));
}

/// Somebody is in the midst of writing: pages of before and after would be mixed.
TEST_F(TakeTransferTest, ATakeThatIsBeingWrittenIsNotCopied) {
    const auto writer = Database::open((takes() / "walk_001.noctule").string(), Access::kReadWrite);
    ASSERT_TRUE(writer);
    ASSERT_TRUE(writer->execute("BEGIN IMMEDIATE; CREATE TABLE x_mine (a)"));
    TakeTransfer transfer = arranged();
    EXPECT_EQ(copyThere(here_, transfer, {}).error().kind, ErrorKind::kUnusable);
    EXPECT_TRUE(fs::is_empty(other() / "takes"));
    ASSERT_TRUE(writer->execute("ROLLBACK"));
    EXPECT_TRUE(copyThere(here_, transfer, {}));
}

/// The list there cannot be written: the take stays, in its file and in the list here.
TEST_F(TakeTransferTest, AMoveThatFailsHalfWayIsTakenBack) {
    const TakeTransfer transfer = arranged();
    fs::remove(other() / "session.json");
    EXPECT_FALSE(moveThere(here_, transfer));
    EXPECT_TRUE(isThere(takes() / "walk_001.noctule"));
    EXPECT_EQ(here_.takes.size(), 1U);
    EXPECT_TRUE(fs::is_empty(other() / "takes"));
}

}  // namespace
}  // namespace noctule::test
