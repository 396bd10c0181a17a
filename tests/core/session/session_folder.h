// SPDX-License-Identifier: Apache-2.0
// A session in a temporary folder, and takes to put into it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>

#include "core/job/atomic_file.h"
#include "core/recording/take_edit.h"
#include "core/recording/take_writer.h"
#include "core/session/session.h"
#include "core/suit/default_suit.h"
#include "tests/support/files.h"

namespace noctule::test {

inline constexpr const char* kCreated = "2026-03-01T10:00:00Z";

class SessionFolder : public testing::Test {
protected:
    using Path = std::filesystem::path;

    void TearDown() override {
        std::filesystem::permissions(home_, std::filesystem::perms::owner_all);  // so that it can go
    }

    Path folder() const { return home_ / "session"; }
    Path takes() const { return folder() / "takes"; }

    Session newSession() {
        auto session = createSession(folder(), "Stage tests", kCreated);
        EXPECT_TRUE(session) << session.error().text();
        return *session;
    }
    Session opened() {
        auto session = openSession(folder(), {});
        EXPECT_TRUE(session) << session.error().text();
        return *session;
    }

public:
    static TakeHeader header(const std::string& created_utc) {
        TakeHeader header;
        header.name = "x";
        header.uuid = "0";
        header.created_utc = created_utc;
        header.sample_rate_hz = 1000;
        header.board_count = 1;
        header.source_count = 1;
        return header;
    }
    static void addSound(TakeWriter& take, int64_t first_sample, int samples) {
        const std::vector<int16_t> values(static_cast<size_t>(samples), 7);
        ASSERT_TRUE(take.addBlock({first_sample, values}, 1, 1));
    }

    /// A finished take of two seconds, worn by `performer`.
    static Path makeTake(const Path& path, const std::string& created_utc = kCreated,
                         const std::string& performer = "", const std::string& shot = "") {
        std::filesystem::create_directories(path.parent_path());
        auto take = TakeWriter::create(path.string(), header(created_utc));
        EXPECT_TRUE(take) << take.error().text();
        EXPECT_TRUE(take->addSuit(defaultSuit()));
        EXPECT_TRUE(take->addActor(defaultActor({1.9}), ""));
        if (!performer.empty()) {
            EXPECT_TRUE(take->setMeta("performer", performer));
        }
        if (!shot.empty()) {
            EXPECT_TRUE(take->setMeta("x_shot", shot));
        }
        addSound(*take, 0, 2000);
        EXPECT_TRUE(take->finish());
        return path;
    }

    /// What a crash leaves: a file and the log beside it, with `seconds` that only the log holds.
    static Path makeBrokenOff(const Path& path, int seconds) {
        const Path writing = path.parent_path() / "writing.tmp";
        std::filesystem::create_directories(path.parent_path());
        {
            auto take =
                TakeWriter::create(writing.string(), header(kCreated), {false, TakeWriter::Journal::kWal});
            EXPECT_TRUE(take) << take.error().text();
            for (int s = 0; s < seconds; ++s)
                addSound(*take, s * 1000, 1000);
            EXPECT_TRUE(take->commit());
            std::filesystem::copy_file(writing, path);
            std::filesystem::copy_file(writing.string() + "-wal", path.string() + "-wal");
        }
        for (const char* ending : {"", "-wal", "-shm"})
            std::filesystem::remove(writing.string() + ending);
        return path;
    }

protected:
    static void addPoseRun(const Path& path) {
        auto take = Take::open(path.string(), Access::kReadWrite);
        ASSERT_TRUE(take);
        auto edit = TakeEdit::begin(*take);
        ASSERT_TRUE(edit);
        ASSERT_TRUE(edit->beginRun({0, "pose", "AGD", "", "", "", {}, {}}));
        ASSERT_TRUE(edit->commit());
    }

    static std::string text(const Path& path) { return readWholeFile(path.string()).value(); }
    static bool isThere(const Path& path) { return std::filesystem::exists(path); }
    /// Tests of refused writing mean nothing to the superuser, who may write anywhere.
    static bool mayWriteAnywhere() { return ::geteuid() == 0; }

    const Folder home_folder_;
    const Path home_ = home_folder_.path();
};

}  // namespace noctule::test
