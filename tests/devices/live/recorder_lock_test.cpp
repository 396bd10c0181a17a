// SPDX-License-Identifier: Apache-2.0
// A recording beside other programs that read its file, lock it or try to: nothing is lost.
#include <gtest/gtest.h>

#include <atomic>

#include "core/recording/database.h"
#include "devices/live/recorder.h"
#include "tests/devices/live/made_sound.h"
#include "tests/support/files.h"

namespace noctule {
namespace {

using namespace std::chrono_literals;
using test::kMadeRate_hz;

constexpr int kLockedBoards = 18;
constexpr int64_t kBlock = 600;

/// A take that another program holds from one second on.
class LockedSink : public TakeSink {
public:
    LockedSink(std::unique_ptr<TakeSink> file, double locked_s, std::chrono::milliseconds per_write = 0ms)
        : file_(std::move(file)),
          begin_(std::chrono::steady_clock::now()),
          locked_s_(locked_s),
          per_write_(per_write) {}
    const std::string& path() const override { return file_->path(); }
    Result<bool> ready() override {
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin_;
        return passed.count() < 1 || passed.count() > 1 + locked_s_ ? file_->ready() : Result<bool>(false);
    }
    Status write(const LiveItem& item) override {
        std::this_thread::sleep_for(per_write_);
        return file_->write(item);
    }
    Status commit() override { return file_->commit(); }
    Status rollBack() override { return file_->rollBack(); }
    Status finish() override { return file_->finish(); }
    bool leftLog() const override { return file_->leftLog(); }
    std::optional<int64_t> freeBytes() const override { return file_->freeBytes(); }

private:
    std::unique_ptr<TakeSink> file_;
    std::chrono::steady_clock::time_point begin_;
    double locked_s_;
    std::chrono::milliseconds per_write_;
};

std::unique_ptr<TakeSink> lockableFile(const test::Folder& folder) {
    auto made = makeTakeFile(test::madePlan(folder.path(), kLockedBoards));
    EXPECT_TRUE(made) << made.error().text();
    return std::move(*made);
}

RecorderSettings lockedSettings() {
    RecorderSettings settings;
    settings.reserve_bytes = 1'000'000;
    return settings;
}

/// In its own time.
void pushSeconds(Recorder& recorder, double seconds) {
    const auto begin = std::chrono::steady_clock::now();
    for (int64_t at = 0; at < static_cast<int64_t>(seconds * kMadeRate_hz); at += kBlock) {
        recorder.push(test::madeBlock(at, kBlock, kLockedBoards));
        std::this_thread::sleep_until(begin + std::chrono::nanoseconds(static_cast<int64_t>(
                                                  static_cast<double>(at) / kMadeRate_hz * 1e9)));
    }
}

void expectWhole(const RecorderState& state, double seconds) {
    EXPECT_FALSE(state.trouble) << state.trouble->text();
    EXPECT_EQ(state.lost_samples, 0);
    const Result<Take> take = Take::open(state.path);
    ASSERT_TRUE(take) << take.error().text();
    const auto found = test::readMadeSound(*take, kLockedBoards);
    EXPECT_EQ(found.samples, static_cast<int64_t>(seconds * kMadeRate_hz));
    EXPECT_EQ(found.holes, 0);
    EXPECT_EQ(found.wrong_values, 0);
    EXPECT_EQ(take->meta().at("state"), "complete");
}

TEST(RecorderLock, LockOfAnotherProgramCostsNothingAndIsTold) {
    const test::Folder folder;
    Recorder recorder(std::make_unique<LockedSink>(lockableFile(folder), 4), lockedSettings());
    pushSeconds(recorder, 4);
    EXPECT_TRUE(recorder.state().is_locked);
    const RecorderState state = recorder.finish();
    expectWhole(state, 4);
    EXPECT_GT(state.longest_lock_s, 3);
    EXPECT_GT(state.backlog.most_memory_bytes, 10'000'000) << "three seconds of 5.4 MB waited";
    ASSERT_EQ(state.notices.size(), 1u);
    EXPECT_NE(state.notices[0].find("another program held the take"), std::string::npos);
    EXPECT_NE(state.notices[0].find("nothing was lost"), std::string::npos) << state.notices[0];
}

/// A block comes every 4 ms; what waited for two seconds is written while others come.
TEST(RecorderLock, WritingWhatWaitedCostsNothingThatComesMeanwhile) {
    const test::Folder folder;
    RecorderSettings settings = lockedSettings();
    settings.queue_s = 1;
    Recorder recorder(std::make_unique<LockedSink>(lockableFile(folder), 2, 2ms), settings);
    pushSeconds(recorder, 6);
    expectWhole(recorder.finish(), 6);
}

TEST(RecorderLock, AnotherProgramThatKeepsTryingToWriteCostsNothing) {
    const test::Folder folder;
    Recorder recorder(lockableFile(folder), lockedSettings());
    std::atomic<bool> ended{false};
    std::thread other([&] {
        auto database = Database::open(recorder.state().path, Access::kReadWrite);
        ASSERT_TRUE(database);
        database->setPatience_s(0);
        while (!ended) {
            (void)database->queryInteger("SELECT count(*) FROM adc_block");
            if (database->execute("BEGIN IMMEDIATE")) {
                std::this_thread::sleep_for(500ms);
                EXPECT_TRUE(database->execute("ROLLBACK"));
            }
        }
    });
    pushSeconds(recorder, 3);
    ended = true;
    other.join();
    expectWhole(recorder.finish(), 3);
}

TEST(RecorderLock, ReaderKeepsItsMomentAndTheTakeIsComplete) {
    const test::Folder folder;
    Recorder recorder(lockableFile(folder), lockedSettings());
    pushSeconds(recorder, 0.5);
    const auto reader = Take::open(recorder.state().path);
    ASSERT_TRUE(reader);
    const auto moment = reader->snapshot();
    ASSERT_TRUE(moment);
    const RecorderState state = recorder.finish();
    EXPECT_EQ(state.notices.size(), 1u);
    expectWhole(state, 0.5);
}

TEST(RecorderBacklog, KeepsTheOrderInMemoryAndBesideTheTake) {
    const test::Folder folder;
    constexpr int64_t kFew = 3 * kBlock * kLockedBoards * 2;
    RecorderBacklog backlog(folder.path(), kFew);
    for (int64_t i = 0; i < 10; ++i) {
        backlog.push(test::madeBlock(i * kBlock, kBlock, kLockedBoards));
        backlog.push(MarkerRow{i, "user", "x"});
    }
    EXPECT_EQ(backlog.extent().memory_bytes, kFew);
    EXPECT_EQ(backlog.extent().file_bytes, 7 * kFew / 3);
    for (int64_t i = 0; i < 10; ++i) {
        const LiveItem item = backlog.pop();
        ASSERT_TRUE(std::holds_alternative<ArrivedBlock>(item)) << i;
        const auto& block = std::get<ArrivedBlock>(item);
        EXPECT_EQ(block.firstSample(), i * kBlock);
        EXPECT_EQ(block.sound->values, test::madeBlock(i * kBlock, kBlock, kLockedBoards).sound->values);
        EXPECT_EQ(std::get<MarkerRow>(backlog.pop()).sample, i);
    }
    EXPECT_TRUE(backlog.empty());
    EXPECT_EQ(backlog.extent().memory_bytes + backlog.extent().file_bytes, 0);
}

TEST(RecorderBacklog, SoundThatCannotBeKeptIsAGap) {
    RecorderBacklog backlog("/no/such/folder", 0);
    backlog.push(test::madeBlock(0, kBlock, kLockedBoards));
    const LiveItem item = backlog.pop();
    ASSERT_TRUE(std::holds_alternative<GapRow>(item));
    EXPECT_EQ(std::get<GapRow>(item).sample_count, kBlock);
}

}  // namespace
}  // namespace noctule
