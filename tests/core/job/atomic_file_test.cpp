// SPDX-License-Identifier: Apache-2.0
#include "core/job/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>

namespace noctule {
namespace {

namespace fs = std::filesystem;

/// Every test works in a folder of its own.
class AtomicFile : public testing::Test {
protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::path(testing::TempDir()) / (std::string("noctule_atomic_file_") + info->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    size_t fileCount() const {
        return static_cast<size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }
    void put(const std::string& name, const std::string& content) const {
        std::ofstream(path(name)) << content;
    }

    fs::path folder_;
};

TEST_F(AtomicFile, WritesWhatReadsBack) {
    const std::string content = std::string("a\0b\r\n", 5) + std::string(300000, 'x');
    ASSERT_TRUE(writeFileAtomically(path("new"), content, false).ok());
    EXPECT_EQ(readWholeFile(path("new")).value(), content);
    EXPECT_EQ(fileCount(), 1u);
}

TEST_F(AtomicFile, AnExistingFileNeedsOverwrite) {
    put("old", "old");
    const Status refused = writeFileAtomically(path("old"), "new", false);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
    EXPECT_NE(refused.error().message.find(path("old")), std::string::npos);
    EXPECT_NE(refused.error().remedy.find("--overwrite"), std::string::npos);
    EXPECT_EQ(readWholeFile(path("old")).value(), "old");
    ASSERT_TRUE(writeFileAtomically(path("old"), "new", true).ok());
    EXPECT_EQ(readWholeFile(path("old")).value(), "new");
    EXPECT_EQ(fileCount(), 1u);
}

TEST_F(AtomicFile, AFileThatAppearsMeanwhileIsNotReplaced) {
    const Status refused = writeFileAtomically(path("file"), "ours", false, [&](const std::string&) {
        put("file", "theirs");
        return Status(Done{});
    });
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
    EXPECT_EQ(readWholeFile(path("file")).value(), "theirs");
    EXPECT_EQ(fileCount(), 1u);
}

TEST_F(AtomicFile, AFailedCheckLeavesNothing) {
    put("old", "old");
    std::string seen;
    const Status failed = writeFileAtomically(path("old"), "new", true, [&](const std::string& aside) {
        seen = readWholeFile(aside).value();
        return Status(Error{ErrorKind::kDisk, "differs", "Try again"});
    });
    ASSERT_FALSE(failed.ok());
    EXPECT_EQ(failed.error().message, "differs");
    EXPECT_EQ(seen, "new");
    EXPECT_EQ(readWholeFile(path("old")).value(), "old");
    EXPECT_EQ(fileCount(), 1u);
}

TEST_F(AtomicFile, AMissingFolderIsADiskErrorThatNamesIt) {
    const Status failed = writeFileAtomically(path("missing/file"), "x", false);
    ASSERT_FALSE(failed.ok());
    EXPECT_EQ(failed.error().kind, ErrorKind::kDisk);
    EXPECT_NE(failed.error().remedy.find(path("missing")), std::string::npos) << failed.error().remedy;
}

TEST_F(AtomicFile, AFolderOrADeviceIsNoOutput) {
    EXPECT_EQ(writeFileAtomically(folder_.string(), "x", true).error().kind, ErrorKind::kUsage);
    EXPECT_EQ(writeFileAtomically("/dev/null", "x", true).error().kind, ErrorKind::kUsage);
    EXPECT_EQ(writeFileAtomically("", "x", true).error().kind, ErrorKind::kUsage);
}

TEST_F(AtomicFile, AFullDiskKeepsTheOldFile) {
    put("old", "old");
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit small = before;
    small.rlim_cur = 1000;
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const Status failed = writeFileAtomically(path("old"), std::string(5000, 'x'), true);
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    ASSERT_FALSE(failed.ok());
    EXPECT_EQ(failed.error().kind, ErrorKind::kDisk);
    EXPECT_FALSE(failed.error().remedy.empty());
    EXPECT_EQ(readWholeFile(path("old")).value(), "old");
    EXPECT_EQ(fileCount(), 1u);
}

TEST_F(AtomicFile, ErrorsNameTheFileThatWasAskedFor) {
    const std::string aside = asidePath(path("result"));
    const Status failed = publishFile(aside, path("result"), false);
    ASSERT_FALSE(failed.ok());
    EXPECT_TRUE(failed.error().message.starts_with(path("result") + ": ")) << failed.error().message;
    const Error named =
        namedAs({ErrorKind::kDisk, aside + ": the disk is full", "Free " + aside}, aside, path("result"));
    EXPECT_EQ(named.message, path("result") + ": the disk is full");
    EXPECT_EQ(named.remedy, "Free " + path("result"));
}

TEST_F(AtomicFile, FilesGetTheUsualPermissions) {
    put("usual", "x");
    ASSERT_TRUE(writeFileAtomically(path("ours"), "x", false).ok());
    EXPECT_EQ(fs::status(path("ours")).permissions(), fs::status(path("usual")).permissions());
}

TEST_F(AtomicFile, PublishingRenamesAFinishedFile) {
    put("aside", "content");
    put("taken", "old");
    EXPECT_EQ(publishFile(path("aside"), path("taken"), false).error().kind, ErrorKind::kUsage);
    EXPECT_EQ(readWholeFile(path("aside")).value(), "content");
    ASSERT_TRUE(publishFile(path("aside"), path("taken"), true).ok());
    EXPECT_EQ(readWholeFile(path("taken")).value(), "content");
    EXPECT_EQ(publishFile(path("aside"), path("other"), false).error().kind, ErrorKind::kDisk);
}

TEST_F(AtomicFile, UnreadableInputIsNamed) {
    for (const std::string& wrong : {path("missing"), folder_.string()}) {
        const Result<std::string> failed = readWholeFile(wrong);
        ASSERT_FALSE(failed.ok());
        EXPECT_EQ(failed.error().kind, ErrorKind::kUnreadable);
        EXPECT_NE(failed.error().message.find(wrong), std::string::npos);
    }
}

}  // namespace
}  // namespace noctule
