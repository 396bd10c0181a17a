// SPDX-License-Identifier: Apache-2.0
#include "devices/live/recorder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <random>

#include "tests/devices/live/made_sound.h"
#include "tests/support/files.h"

namespace noctule {
namespace {

using namespace std::chrono_literals;
using test::Folder;
using test::kMadeRate_hz;
using test::madeBlock;

constexpr int kBoards = 18;

RecorderSettings smallReserve() {
    RecorderSettings settings;
    settings.reserve_bytes = 1'000'000;
    return settings;
}

std::unique_ptr<TakeSink> takeFile(const Folder& folder) {
    auto made = makeTakeFile(test::madePlan(folder.path(), kBoards));
    EXPECT_TRUE(made) << made.error().text();
    return std::move(*made);
}

/// A take file on a disk that is slow, fills up or breaks when told to.
class TroubledSink : public TakeSink {
public:
    struct Trouble {
        std::chrono::milliseconds commit_takes{0};
        std::chrono::milliseconds first_commit_takes{0};
        int64_t fail_write_from_sample = INT64_MAX;
        int64_t full_from_sample = INT64_MAX;
        bool fail_finish = false;
    };
    TroubledSink(std::unique_ptr<TakeSink> file, const Trouble& trouble)
        : file_(std::move(file)), trouble_(trouble) {}

    const std::string& path() const override { return file_->path(); }
    Status write(const LiveItem& item) override {
        if (const auto* block = std::get_if<ArrivedBlock>(&item)) {
            reached_ = block->endSample();
            if (block->firstSample() >= trouble_.fail_write_from_sample)
                return Error{ErrorKind::kDisk, path() + ": the disk broke", "Check the disk"};
        }
        return file_->write(item);
    }
    Status commit() override {
        std::this_thread::sleep_for(
            std::max(trouble_.commit_takes, std::exchange(trouble_.first_commit_takes, 0ms)));
        return file_->commit();
    }
    Status rollBack() override { return file_->rollBack(); }
    Status finish() override {
        return trouble_.fail_finish
                   ? Status(Error{ErrorKind::kDisk, path() + ": the disk is full", "Free some space"})
                   : file_->finish();
    }
    std::optional<int64_t> freeBytes() const override {
        return reached_ >= trouble_.full_from_sample ? 999'000 : file_->freeBytes();
    }

private:
    std::unique_ptr<TakeSink> file_;
    Trouble trouble_;
    int64_t reached_ = 0;
};

/// Blocks of 4 ms, as a box sends them, at `speed` times their own time.
void pushSound(Recorder& recorder, double seconds, double speed, int64_t from = 0) {
    const auto begin = std::chrono::steady_clock::now();
    for (int64_t at = 0; at < static_cast<int64_t>(seconds * kMadeRate_hz); at += 600) {
        recorder.push(madeBlock(from + at, 600, kBoards));
        std::this_thread::sleep_until(begin + std::chrono::nanoseconds(static_cast<int64_t>(
                                                  static_cast<double>(at) / kMadeRate_hz / speed * 1e9)));
    }
}

TEST(Recorder, WritesEverythingBitForBitIntoOneFile) {
    const Folder folder;
    Recorder recorder(takeFile(folder), smallReserve());
    std::mt19937 random(3);
    int64_t at = 0, pulse_id = 0;
    for (int block = 0; block < 200; ++block) {
        recorder.push(std::vector<Pulse>{{++pulse_id, at + 7, block % 8}, {++pulse_id, at + 9, 1}});
        const auto count = static_cast<int64_t>(1 + random() % 4096);
        recorder.push(madeBlock(at, count, kBoards));
        at += count;
        std::this_thread::sleep_for(2ms);
    }
    recorder.push(StatusRow{at, 21.5, {}, 3.9, 55});
    recorder.push(GapRow{at, 600, {}, kGapOfLink});
    recorder.push(madeBlock(at + 600, 600, kBoards));
    recorder.push(MarkerRow{42, "sync", "clap"});
    recorder.push(NoteRow{"2026-01-01T00:00:00Z", "strap slipped"});
    const RecorderState state = recorder.finish();
    EXPECT_FALSE(state.trouble) << state.trouble->text();
    EXPECT_TRUE(state.ended);
    EXPECT_EQ(state.samples, at + 1200);
    EXPECT_EQ(state.committed_samples, at + 1200);
    EXPECT_EQ(state.lost_samples, 600);
    EXPECT_EQ(state.gaps, 1);
    EXPECT_GE(state.commits, 2);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"walk_001.noctule"});

    const Result<Take> take = Take::open(folder.file("walk_001.noctule"));
    ASSERT_TRUE(take) << take.error().text();
    const auto found = test::readMadeSound(*take, kBoards);
    EXPECT_EQ(found.samples, at + 600);
    EXPECT_EQ(found.end, at + 1200);
    EXPECT_EQ(found.holes, 600);
    EXPECT_EQ(found.wrong_values, 0);
    EXPECT_EQ(take->meta().at("state"), "complete");
    EXPECT_EQ(take->meta().at("sample_count"), std::to_string(at + 1200));
    EXPECT_EQ(take->header().name, "walk_001");
    EXPECT_EQ(take->header().uuid.size(), 36u);
    EXPECT_EQ(take->pulses()->size(), 400u);
    EXPECT_EQ(take->statusRows()->at(0).battery_percent, 55);
    EXPECT_EQ(take->gaps()->at(0).reason, "link");
    EXPECT_EQ(take->markers()->at(0).label, "clap");
    EXPECT_EQ(take->notes()->at(0).text, "strap slipped");
    EXPECT_TRUE(take->missingParts()->size() <= 2u);
}

TEST(Recorder, CountsTheNamesAndNeverOverwrites) {
    const Folder folder;
    std::filesystem::create_directories(folder.path() / "takes");
    std::filesystem::create_directories(folder.path() / "trash");
    test::writeBytes(folder.file("takes/walk_001.noctule"), "old");
    test::writeBytes(folder.file("trash/walk_002.noctule"), "thrown away");
    test::writeBytes(folder.file("takes/walk_003.noctule-wal"), "of a recording that broke off");
    auto first = makeTakeFile(test::madePlan(folder.path() / "takes", kBoards));
    ASSERT_TRUE(first) << first.error().text();
    EXPECT_EQ(std::filesystem::path((*first)->path()).filename(), "walk_004.noctule");
    const auto second = makeTakeFile(test::madePlan(folder.path() / "takes", kBoards));
    ASSERT_TRUE(second);
    EXPECT_EQ(std::filesystem::path((*second)->path()).filename(), "walk_005.noctule");
    EXPECT_EQ(test::readBytes(folder.file("takes/walk_001.noctule")), "old");
    TakePlan elsewhere = test::madePlan(folder.file("takes/walk_001.noctule"), kBoards);
    const auto refused = makeTakeFile(elsewhere);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kDisk);
}

TEST(Recorder, ADiskThatPausesCostsNothing) {
    const Folder folder;
    Recorder recorder(
        std::make_unique<TroubledSink>(takeFile(folder), TroubledSink::Trouble{0ms, 1200ms, INT64_MAX}),
        smallReserve());
    pushSound(recorder, 1.5, 1);
    const RecorderState state = recorder.finish();
    EXPECT_FALSE(state.trouble);
    EXPECT_EQ(state.lost_samples, 0);
    EXPECT_GT(state.queue.deepest_samples, kMadeRate_hz);
    EXPECT_GT(state.slowest_commit_ns, 1'200'000'000);
    EXPECT_EQ(test::readMadeSound(*Take::open(state.path), kBoards).samples, 225000);
}

TEST(Recorder, ADiskThatIsTooSlowCostsTheOldestSoundAndSaysWhere) {
    const Folder folder;
    RecorderSettings settings = smallReserve();
    settings.queue_s = 0.25;
    Recorder recorder(
        std::make_unique<TroubledSink>(takeFile(folder), TroubledSink::Trouble{400ms, 0ms, INT64_MAX}),
        settings);
    pushSound(recorder, 2, 1);
    EXPECT_LE(recorder.state().queue.samples, 37500);
    const RecorderState state = recorder.finish();
    EXPECT_FALSE(state.trouble);
    EXPECT_GT(state.lost_samples, 0);
    EXPECT_EQ(state.queue.dropped_samples, state.lost_samples);
    const Result<Take> take = Take::open(state.path);
    const auto found = test::readMadeSound(*take, kBoards);
    EXPECT_EQ(found.wrong_values, 0);
    EXPECT_EQ(found.end, 300000) << "the newest sound is there";
    EXPECT_EQ(found.holes, state.lost_samples);
    int64_t marked = 0;
    const auto gaps = take->gaps();
    for (const GapRow& gap : *gaps) {
        EXPECT_EQ(gap.reason, "studio");
        marked += gap.sample_count;
    }
    EXPECT_EQ(marked, found.holes);
}

TEST(Recorder, EndsBeforeTheDiskIsFull) {
    const Folder folder;
    Recorder recorder(
        std::make_unique<TroubledSink>(takeFile(folder), TroubledSink::Trouble{0ms, 0ms, INT64_MAX, 60000}),
        smallReserve());
    pushSound(recorder, 1, 2);
    const RecorderState state = recorder.finish();
    ASSERT_TRUE(state.trouble);
    EXPECT_EQ(state.trouble->kind, ErrorKind::kDisk);
    EXPECT_NE(state.trouble->message.find("walk_001.noctule"), std::string::npos);
    EXPECT_NE(state.trouble->message.find("s are safe"), std::string::npos) << state.trouble->message;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"walk_001.noctule"});
    const Result<Take> take = Take::open(state.path);
    EXPECT_EQ(take->meta().at("state"), "complete");
    EXPECT_EQ(test::readMadeSound(*take, kBoards).end, state.committed_samples);
    EXPECT_GE(state.committed_samples, 60000);
}

TEST(Recorder, AWriteThatFailsEndsTheTakeAtTheLastCommit) {
    const Folder folder;
    Recorder recorder(
        std::make_unique<TroubledSink>(takeFile(folder), TroubledSink::Trouble{0ms, 0ms, 90000}),
        smallReserve());
    pushSound(recorder, 0.6, 1);
    for (int i = 0; i < 60'000 && recorder.state().committed_samples < 90000; ++i)
        std::this_thread::sleep_for(1ms);
    pushSound(recorder, 0.4, 1, 90000);
    const RecorderState state = recorder.finish();
    ASSERT_TRUE(state.trouble);
    EXPECT_NE(state.trouble->message.find("the disk broke"), std::string::npos);
    EXPECT_NE(state.trouble->message.find("are safe"), std::string::npos);
    const Result<Take> take = Take::open(state.path);
    ASSERT_TRUE(take);
    EXPECT_EQ(take->meta().at("state"), "complete");
    const auto found = test::readMadeSound(*take, kBoards);
    EXPECT_EQ(found.end, state.committed_samples);
    EXPECT_EQ(take->meta().at("sample_count"), std::to_string(state.committed_samples));
    EXPECT_EQ(found.end, 90000) << "all that was committed before";
    EXPECT_EQ(found.wrong_values, 0);
}

TEST(Recorder, AFileThatCannotBeCompletedIsNamedWithTheRemedy) {
    const Folder folder;
    TroubledSink::Trouble trouble;
    trouble.fail_finish = true;
    Recorder recorder(std::make_unique<TroubledSink>(takeFile(folder), trouble), smallReserve());
    pushSound(recorder, 0.3, 1);
    const RecorderState state = recorder.finish();
    ASSERT_TRUE(state.trouble);
    EXPECT_NE(state.trouble->remedy.find("recover"), std::string::npos);
}

int64_t residentBytes() {
    std::ifstream statm("/proc/self/statm");
    int64_t size = 0, resident = 0;
    statm >> size >> resident;
    return resident * sysconf(_SC_PAGESIZE);
}

TEST(Recorder, MemoryDoesNotGrowWithTheTakeNorWithADiskThatHangs) {
    const Folder folder;
    TroubledSink::Trouble trouble;
    trouble.first_commit_takes = 3000ms;
    Recorder recorder(std::make_unique<TroubledSink>(takeFile(folder), trouble), smallReserve());
    const ArrivedBlock model = madeBlock(0, 600, kBoards);
    const auto pushMinute = [&](int64_t minute) {
        for (int64_t at = 0; at < 60 * kMadeRate_hz; at += 600) {
            link::SoundBlock block = *model.sound;
            block.first_sample = minute * 60 * kMadeRate_hz + at;
            recorder.push(ArrivedBlock{std::make_shared<const link::SoundBlock>(std::move(block)), 0});
        }
    };
    pushMinute(0);
    const int64_t after_one = residentBytes();
    for (int64_t minute = 1; minute < 5; ++minute)
        pushMinute(minute);
    EXPECT_LT(residentBytes() - after_one, 8'000'000) << "1.3 GB of sound were offered since";
    EXPECT_LE(recorder.state().queue.deepest_samples, 2 * kMadeRate_hz);
    const RecorderState state = recorder.finish();
    EXPECT_EQ(state.samples, 5 * 60 * kMadeRate_hz);
    EXPECT_EQ(state.lost_samples + std::llround(static_cast<double>(state.sound_bytes) / 36), state.samples);
    EXPECT_LE(state.gaps, 50) << "one after the other makes one";
}

TEST(Recorder, TellsHowLongTheDiskWillLast) {
    const Folder folder;
    Recorder recorder(takeFile(folder), smallReserve());
    pushSound(recorder, 0.5, 1);
    const RecorderState state = recorder.state();
    ASSERT_TRUE(state.free_bytes && state.remaining_s);
    // 18 boards of two bytes at 150 kHz are 5.4 MB/s.
    EXPECT_NEAR(*state.remaining_s, static_cast<double>(*state.free_bytes - 1'000'000) / 5.4e6,
                0.01 * *state.remaining_s);
}

}  // namespace
}  // namespace noctule
