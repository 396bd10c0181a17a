// SPDX-License-Identifier: Apache-2.0
// Copies of takes that are worked on aside, recordings that broke off, and reading while somebody writes.
#include "core/recording/take_copy.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/job/atomic_file.h"
#include "core/recording/recover_take.h"
#include "core/recording/take_edit.h"
#include "core/recording/take_writer.h"
#include "tests/core/recording/collect.h"

namespace noctule::test {
namespace {

namespace fs = std::filesystem;

class TakeCopies : public testing::Test {
protected:
    std::string path(const std::string& name) const { return folder_.file(name); }

    static TakeHeader header() {
        TakeHeader header;
        header.name = "walk_001";
        header.uuid = "0";
        header.created_utc = "2026-01-01T00:00:00Z";
        header.sample_rate_hz = 1000;
        header.board_count = 1;
        header.source_count = 1;
        return header;
    }
    /// A recording of two seconds of which the second one stands in the log only.
    void breakOff(const std::string& as) const {
        const std::vector<int16_t> second(1000, 7);
        auto take = TakeWriter::create(path("writing.noctule"), header(), {false, TakeWriter::Journal::kWal});
        ASSERT_TRUE(take);
        for (int s = 0; s < 2; ++s)
            ASSERT_TRUE(take->addBlock({s * 1000, second}, 1, 1));
        ASSERT_TRUE(take->commit());
        fs::copy_file(path("writing.noctule"), path(as));
        fs::copy_file(path("writing.noctule-wal"), path(as) + "-wal");
    }
    bool isThere(const std::string& name) const { return fs::exists(path(name)); }

    Folder folder_;
};

TEST_F(TakeCopies, CopyIsGoneUnlessPublished) {
    const std::string take = tinyTake(folder_);
    std::string aside;
    {
        auto copy = TakeCopy::make(take, path("copy.noctule"), {});
        ASSERT_TRUE(copy) << copy.error().text();
        aside = copy->path();
        EXPECT_TRUE(fs::exists(aside));
        EXPECT_EQ(copy->named({ErrorKind::kUnreadable, aside + ": torn", ""}).message, take + ": torn");
        EXPECT_EQ(copy->named({ErrorKind::kDisk, aside + ": full", ""}).message,
                  path("copy.noctule") + ": full");
    }
    EXPECT_FALSE(fs::exists(aside));
    EXPECT_FALSE(isThere("copy.noctule"));
    auto copy = TakeCopy::make(take, path("copy.noctule"), {});
    ASSERT_TRUE(copy->publish(false));
    EXPECT_EQ(readWholeFile(path("copy.noctule")).value(), readWholeFile(take).value());
}

TEST_F(TakeCopies, FoldedCopyHoldsWhatTheLogHeld) {
    breakOff("walk.noctule");
    auto copy = TakeCopy::make(path("walk.noctule"), path("copy.noctule"), {});
    ASSERT_TRUE(copy) << copy.error().text();
    ASSERT_TRUE(copy->foldLog());
    ASSERT_TRUE(copy->publish(false));
    EXPECT_FALSE(isThere("copy.noctule-wal"));
    EXPECT_EQ(Take::open(path("copy.noctule"))->sampleCount().value(), 2000);
}

TEST_F(TakeCopies, RecoveredTakeIsWholeAndTheRecordingUntouched) {
    breakOff("walk.noctule");
    const std::string file = readWholeFile(path("walk.noctule")).value();
    const std::string log = readWholeFile(path("walk.noctule-wal")).value();
    const auto recovered = recoverTake(path("walk.noctule"), path("whole.noctule"), {});
    ASSERT_TRUE(recovered) << recovered.error().text();
    EXPECT_FALSE(*recovered) << "nothing is lost";
    const auto take = Take::open(path("whole.noctule"));
    EXPECT_EQ(take->meta().at("state"), "recovered");
    EXPECT_EQ(take->meta().at("sample_count"), "2000");
    EXPECT_EQ(readWholeFile(path("walk.noctule")).value(), file);
    EXPECT_EQ(readWholeFile(path("walk.noctule-wal")).value(), log);
    const auto again = recoverTake(path("walk.noctule"), path("whole.noctule"), {});
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().kind, ErrorKind::kUsage);
}

TEST_F(TakeCopies, AskingWhetherATakeIsBeingWrittenHarmsNoWriterOfThisProcess) {
    breakOff("walk.noctule");
    EXPECT_FALSE(isBeingWritten(path("walk.noctule")));
    EXPECT_FALSE(isBeingWritten(path("none.noctule")));
    auto take = TakeWriter::create(path("now.noctule"), header(), {false, TakeWriter::Journal::kWal});
    ASSERT_TRUE(take);
    ASSERT_TRUE(take->commit());
    for (int i = 0; i < 2; ++i)
        EXPECT_TRUE(isBeingWritten(path("now.noctule"))) << "a lock that was lost the first time, if not now";
    ASSERT_TRUE(take->finish());
    EXPECT_FALSE(isBeingWritten(path("now.noctule")));
}

TEST_F(TakeCopies, OfADamagedRecordingWhatCanBeReadIsSaved) {
    breakOff("walk.noctule");
    ASSERT_TRUE(Take::open(path("walk.noctule"), Access::kReadWrite));  // SQLite brings the log into the file
    std::fstream file(path("walk.noctule"), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(fs::file_size(path("walk.noctule")) * 2 / 3));
    file << std::string(16384, '\x55');
    file.close();
    const std::string before = readWholeFile(path("walk.noctule")).value();
    const auto recovered = recoverTake(path("walk.noctule"), path("whole.noctule"), {});
    ASSERT_TRUE(recovered) << recovered.error().text();
    ASSERT_TRUE(*recovered);
    EXPECT_FALSE((*recovered)->empty());
    const auto take = Take::open(path("whole.noctule"));
    ASSERT_TRUE(take) << take.error().text();
    EXPECT_EQ(take->meta().at("state"), "recovered");
    EXPECT_EQ(take->sampleCount().value(), 2000);
    EXPECT_EQ(readWholeFile(path("walk.noctule")).value(), before);
}

TEST_F(TakeCopies, TakeIsReadWhileAnEditGrows) {
    const std::string path = tinyTake(folder_);
    auto take = Take::open(path, Access::kReadWrite);
    auto edit = TakeEdit::begin(*take);
    ASSERT_TRUE(edit);
    const auto run = edit->beginRun({0, "inertial", "grows", "", "", "", {}, {}});
    ASSERT_TRUE(run);
    // 10 MB, five times what SQLite keeps by itself.
    for (int frame = 0; frame < 200000; ++frame) {
        InertialReading reading{0, frame, static_cast<double>(frame), {}, {}, 0};
        ASSERT_TRUE(edit->addInertial(*run, reading));
    }
    const auto reader = Take::open(path);
    ASSERT_TRUE(reader) << reader.error().text();
    EXPECT_TRUE(reader->derivedRuns()->empty());
}

}  // namespace
}  // namespace noctule::test
