// SPDX-License-Identifier: Apache-2.0
// Recordings that end as no recording should: the process is killed, the power fails, the disk is full. What
// was committed must be there. NOCTULE_KILLS=200 kills that often, and as often the power fails.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <functional>
#include <random>

#include "core/recording/recover_take.h"
#include "devices/live/recorder.h"
#include "tests/devices/live/made_sound.h"
#include "tests/support/files.h"
#include "tests/support/fuzzing.h"
#include "tests/support/unsynced_disk.h"

namespace noctule {
namespace {

using namespace std::chrono_literals;
using test::Folder;
using test::kMadeRate_hz;

constexpr int kSuitBoards = 18;

/// How far the killed process had come, in memory that outlives it.
struct Reached {
    std::atomic<int64_t> pushed{0}, committed{0};
};
/// How far a recording had come when the accident happened.
struct Progress {
    int64_t pushed = 0, committed = 0;
};

class SharedReached {
public:
    SharedReached()
        : page_(mmap(nullptr, sizeof(Reached), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)),
          reached_(new (page_) Reached) {}
    ~SharedReached() { munmap(page_, sizeof(Reached)); }
    Reached& operator*() const { return *reached_; }
    Reached* operator->() const { return reached_; }

private:
    void* page_;
    Reached* reached_;
};

/// Tells after every commit what it made safe.
class TellingSink : public TakeSink {
public:
    TellingSink(std::unique_ptr<TakeSink> file, Reached& reached)
        : file_(std::move(file)), reached_(reached) {}
    const std::string& path() const override { return file_->path(); }
    Status write(const LiveItem& item) override {
        if (const auto* block = std::get_if<ArrivedBlock>(&item))
            written_ = block->endSample();
        return file_->write(item);
    }
    Status commit() override {
        const Status committed = file_->commit();
        if (committed)
            reached_.committed = written_;
        return committed;
    }
    Status rollBack() override { return file_->rollBack(); }
    Status finish() override { return file_->finish(); }
    std::optional<int64_t> freeBytes() const override { return file_->freeBytes(); }

private:
    std::unique_ptr<TakeSink> file_;
    Reached& reached_;
    int64_t written_ = 0;
};

/// Gives sound in real time as long as it is wanted.
void recordMadeSound(Recorder& recorder, Reached& reached, const std::function<bool()>& goes_on) {
    const auto begin = std::chrono::steady_clock::now();
    for (int64_t at = 0, pulse = 0; goes_on(); at += 600) {
        if (at % 1200 == 0) {
            recorder.push(std::vector<Pulse>{{pulse + 1, at, static_cast<int>(pulse % 8)}});
            ++pulse;
        }
        recorder.push(test::madeBlock(at, 600, kSuitBoards));
        reached.pushed = at + 600;
        std::this_thread::sleep_until(begin + std::chrono::nanoseconds(at * 1'000'000'000 / kMadeRate_hz));
    }
}

std::unique_ptr<Recorder> recorderInto(const std::filesystem::path& folder, Reached& reached) {
    auto file = makeTakeFile(test::madePlan(folder, kSuitBoards));
    if (!file)
        return nullptr;
    RecorderSettings settings;
    settings.reserve_bytes = 1'000'000;
    return std::make_unique<Recorder>(std::make_unique<TellingSink>(std::move(*file), reached), settings);
}

/// In the child, until it is killed.
[[noreturn]] void recordForEver(const std::filesystem::path& folder, Reached& reached) {
    const auto recorder = recorderInto(folder, reached);
    if (recorder)
        recordMadeSound(*recorder, reached, [] { return true; });
    _exit(1);
}

/// Recovers walk_001 of the folder and sees that it holds what had been `committed`. Gives how far it
/// reaches.
int64_t expectRecovered(const Folder& folder, int64_t committed, const std::string& which) {
    const std::string broken = folder.file("walk_001.noctule"), safe = folder.file("safe.noctule");
    const auto recovered = recoverTake(broken, safe, {});
    EXPECT_TRUE(recovered) << which << ": " << recovered.error().text();
    if (!recovered)
        return 0;
    const Result<Take> take = Take::open(safe);
    EXPECT_TRUE(take) << which << ": " << take.error().text();
    EXPECT_EQ(take->meta().at("state"), "recovered");
    const auto found = test::readMadeSound(*take, kSuitBoards);
    EXPECT_EQ(found.wrong_values, 0) << which;
    EXPECT_EQ(found.holes, 0) << which;
    EXPECT_GE(found.end, committed) << which;
    // A pulse is told before the sound that holds it.
    EXPECT_NEAR(static_cast<double>(take->pulses()->size()), static_cast<double>((found.end + 1199) / 1200),
                1)
        << which;
    return found.end;
}

/// How much was missing at the end, of all accidents.
class Losses {
public:
    void add(int64_t samples, const std::string& which) {
        EXPECT_LE(samples, 4 * kMadeRate_hz / 10) << which;
        lost_ms_.push_back(static_cast<double>(samples) * 1000 / kMadeRate_hz);
    }
    void print(const char* accident) {
        std::sort(lost_ms_.begin(), lost_ms_.end());
        std::printf("%zu %s, all recovered: %.0f ms lost in the median, %.0f ms at most\n", lost_ms_.size(),
                    accident, lost_ms_[lost_ms_.size() / 2], lost_ms_.back());
    }

private:
    std::vector<double> lost_ms_;
};

/// As many accidents as NOCTULE_KILLS says, each to a recording in a folder of its own. `accident(folder,
/// random)` gives its progress until then.
template <class Accident>
void recoverFrom(const char* name, unsigned seed, Accident accident) {
    std::mt19937 random(seed);
    Losses losses;
    const int64_t count = test::countFromEnvironment("NOCTULE_KILLS", 4);
    for (int64_t number = 0; number < count && !testing::Test::HasFailure(); ++number) {
        const std::string which =
            "seed " + std::to_string(seed) + ", of " + name + " number " + std::to_string(number);
        const Folder folder;
        const Progress progress = accident(folder, random);
        if (!testing::Test::HasFailure())
            losses.add(progress.pushed - expectRecovered(folder, progress.committed, which), which);
    }
    if (!testing::Test::HasFailure())
        losses.print(name);
}

TEST(BrokenRecording, KilledAtRandomMoments) {
    recoverFrom("kills", 20, [](const Folder& folder, std::mt19937& random) {
        const SharedReached reached;
        const pid_t child = fork();
        EXPECT_GE(child, 0);
        if (child < 0)
            return Progress{};
        if (child == 0)
            recordForEver(folder.path(), *reached);
        std::this_thread::sleep_for(std::chrono::milliseconds(300 + random() % 1500));
        EXPECT_EQ(kill(child, SIGKILL), 0);
        int status = 0;
        waitpid(child, &status, 0);
        if (!WIFSIGNALED(status)) {
            ADD_FAILURE() << "the recording ended by itself";
            return Progress{};
        }
        EXPECT_EQ(Take::open(folder.file("walk_001.noctule"))->meta().at("state"), "recording");
        return Progress{reached->pushed, reached->committed};
    });
}

TEST(BrokenRecording, WithoutPowerAtRandomMoments) {
    bool keeps_some = false;
    recoverFrom("power failures", 21, [&keeps_some](const Folder& folder, std::mt19937& random) {
        Progress progress;
        {
            Reached reached;
            test::UnsyncedDisk disk;
            const auto recorder = recorderInto(folder.path(), reached);
            EXPECT_TRUE(recorder);
            if (!recorder)
                return progress;
            const auto end =
                std::chrono::steady_clock::now() + std::chrono::milliseconds(300 + random() % 900);
            recordMadeSound(*recorder, reached, [&] { return std::chrono::steady_clock::now() < end; });
            progress.committed = reached.committed;
            disk.losePower(keeps_some ? &random : nullptr);
            keeps_some = !keeps_some;
            progress.pushed = reached.pushed;
            EXPECT_GT(disk.syncs(), 1) << "a commit that nobody syncs is none";
            recorder->finish();
        }
        // The computer starts again: what only lived in memory is gone.
        std::filesystem::remove(folder.file("walk_001.noctule-shm"));
        return progress;
    });
}

/// A disk of its own, gone with the object.
class SmallDisk {
public:
    explicit SmallDisk(int megabytes) {
        const std::string options = "size=" + std::to_string(megabytes) + "m";
        mounted_ = mount("tmpfs", folder_.path().c_str(), "tmpfs", 0, options.c_str()) == 0;
        problem_ = std::strerror(errno);
    }
    ~SmallDisk() {
        if (mounted_)
            umount2(folder_.path().c_str(), MNT_DETACH);
    }
    bool isThere() const { return mounted_; }
    const std::string& problem() const { return problem_; }
    const Folder& folder() const { return folder_; }

private:
    Folder folder_;
    bool mounted_ = false;
    std::string problem_;
};

#define SKIP_WITHOUT(disk) \
    if (!(disk).isThere()) \
    GTEST_SKIP() << "a small disk cannot be mounted here (" << (disk).problem() << "); run as root"

/// Ten times as fast as a suit, until the recording ends by itself.
RecorderState recordUntilItEnds(Recorder& recorder) {
    for (int64_t at = 0; !recorder.state().ended && at < 60 * kMadeRate_hz; at += 3000) {
        recorder.push(test::madeBlock(at, 3000, kSuitBoards));
        std::this_thread::sleep_for(2ms);
    }
    return recorder.finish();
}

TEST(BrokenRecording, EndsInGoodOrderBeforeASmallDiskIsFull) {
    const SmallDisk disk(96);
    SKIP_WITHOUT(disk);
    auto file = makeTakeFile(test::madePlan(disk.folder().path(), kSuitBoards));
    ASSERT_TRUE(file) << file.error().text();
    RecorderSettings settings;
    settings.reserve_bytes = 32'000'000;
    Recorder recorder(std::move(*file), settings);
    const RecorderState state = recordUntilItEnds(recorder);
    ASSERT_TRUE(state.trouble);
    EXPECT_NE(state.trouble->message.find("are free on the disk"), std::string::npos)
        << state.trouble->text();
    EXPECT_EQ(disk.folder().names(), std::vector<std::string>{"walk_001.noctule"});
    const Result<Take> take = Take::open(state.path);
    ASSERT_TRUE(take) << take.error().text();
    EXPECT_EQ(take->meta().at("state"), "complete");
    const auto found = test::readMadeSound(*take, kSuitBoards);
    EXPECT_EQ(found.wrong_values, 0);
    EXPECT_EQ(found.end, state.committed_samples);
    EXPECT_GT(found.samples * kSuitBoards * 2, 30'000'000);
}

TEST(BrokenRecording, ADiskThatIsFullAllTheSameKeepsWhatWasCommitted) {
    const SmallDisk disk(48);
    SKIP_WITHOUT(disk);
    auto file = makeTakeFile(test::madePlan(disk.folder().path(), kSuitBoards));
    ASSERT_TRUE(file) << file.error().text();
    RecorderSettings settings;
    settings.reserve_bytes = 0;
    Recorder recorder(std::move(*file), settings);
    const RecorderState state = recordUntilItEnds(recorder);
    ASSERT_TRUE(state.trouble);
    EXPECT_EQ(state.trouble->kind, ErrorKind::kDisk) << state.trouble->text();
    EXPECT_NE(state.trouble->message.find("are safe"), std::string::npos) << state.trouble->text();

    const Folder elsewhere;
    std::string safe = elsewhere.file("safe.noctule");
    const bool is_whole = [&] {
        const auto left = Take::open(state.path);  // may fail where no byte is free, not even for reading
        return left && left->meta().at("state") == "complete";
    }();
    if (is_whole)
        safe = state.path;
    else if (const auto recovered = recoverTake(state.path, safe, {}); !recovered)
        FAIL() << recovered.error().text();
    const auto take = Take::open(safe);
    ASSERT_TRUE(take) << take.error().text();
    const auto found = test::readMadeSound(*take, kSuitBoards);
    EXPECT_EQ(found.wrong_values, 0);
    EXPECT_EQ(found.end, state.committed_samples);
    EXPECT_GT(found.samples, 0);
}

}  // namespace
}  // namespace noctule
