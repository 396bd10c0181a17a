// SPDX-License-Identifier: Apache-2.0
#include "devices/live/recorder.h"

#include <algorithm>
#include <cstdio>

namespace noctule {
namespace {

using SteadyClock = std::chrono::steady_clock;

std::string megabytes(int64_t bytes) {
    return std::to_string(bytes / 1'000'000) + " MB";
}

constexpr int kAtOnce = 64;  // of a backlog, before the queue is looked at again
constexpr std::chrono::milliseconds kLookAtLock{10};
constexpr double kWorthTelling_s = 1;

std::string lockNotice(const RecorderState& state) {
    char text[80];
    std::snprintf(text, sizeof text, ": another program held the take for up to %.1f s; ",
                  state.longest_lock_s);
    return state.path + text + megabytes(state.backlog.most_memory_bytes) +
           " of sound waited in memory and " + megabytes(state.backlog.most_file_bytes) + " beside the take" +
           (state.lost_samples == 0 && !state.trouble ? ", nothing was lost." : ".");
}

/// What a row does to the counts.
struct RowCounter {
    RecorderState& state;

    void operator()(const ArrivedBlock& block) const {
        state.samples = std::max(state.samples, block.endSample());
        state.sound_bytes += static_cast<int64_t>(block.sound->values.size() * sizeof(int16_t));
    }
    void operator()(const GapRow& gap) const {
        ++state.gaps;
        state.lost_samples += gap.board ? 0 : gap.sample_count;
    }
    template <class Other>
    void operator()(const Other&) const {}
};

}  // namespace

Recorder::Recorder(std::unique_ptr<TakeSink> sink, const RecorderSettings& settings)
    : sink_(std::move(sink)),
      settings_(settings),
      queue_(static_cast<int64_t>(settings.queue_s * settings.sample_rate_hz),
             LiveQueue::WhenFull::kOldestGoes),
      backlog_(std::filesystem::absolute(sink_->path()).parent_path()) {
    state_.path = sink_->path();
    thread_ = std::thread([this] { work(); });
}

Recorder::~Recorder() {
    finish();
}

RecorderState Recorder::state() const {
    const std::lock_guard lock(mutex_);
    RecorderState state = state_;
    state.queue = queue_.depth();
    return state;
}

RecorderState Recorder::finish() {
    queue_.close();
    if (thread_.joinable())
        thread_.join();
    return state();
}

void Recorder::work() {
    try {
        auto next_commit = SteadyClock::now();
        while (true) {
            const bool waits = !backlog_.empty();
            const bool behind = waits && !locked_since_;
            std::optional<LiveItem> item = queue_.pop(behind ? SteadyClock::now() : next_commit);
            const bool came = item.has_value();
            // While older items wait, the short queue must not fill up.
            for (; item; item = waits ? queue_.pop(SteadyClock::now()) : std::nullopt)
                backlog_.push(std::move(*item));
            if (!drain())
                return;
            if (SteadyClock::now() >= next_commit) {
                if ((!locked_since_ && !commit()) || !hasRoom())
                    return;
                next_commit = SteadyClock::now() + kCommitEvery;
            }
            if (came || !queue_.drained())
                continue;
            if (backlog_.empty())
                return complete(std::nullopt);
            if (waitsTooLong())
                return endWith({ErrorKind::kUnreadable,
                                sink_->path() + ": another program has locked the take for two minutes",
                                "Close the other program"});
            std::this_thread::sleep_for(kLookAtLock);
        }
    } catch (const std::exception& mistake) {
        endWith(
            {ErrorKind::kInternal, state_.path + ": internal error: " + mistake.what(), "Please report it"});
    }
}

/// Writes what waits, some blocks at a time, as far as no other program holds the take.
bool Recorder::drain() {
    for (int n = 0; n < kAtOnce && !backlog_.empty(); ++n) {
        const Result<bool> ready = sink_->ready();
        if (!ready) {
            endWith(ready.error());
            return false;
        }
        noteLock(!*ready);
        if (!*ready)
            return true;
        if (!write(backlog_.pop()))
            return false;
    }
    return true;
}

void Recorder::noteLock(bool is_locked) {
    const auto now = SteadyClock::now();
    if (is_locked && !locked_since_)
        locked_since_ = now;
    const std::lock_guard lock(mutex_);
    state_.is_locked = is_locked;
    state_.backlog = backlog_.extent();
    if (locked_since_)
        state_.longest_lock_s =
            std::max(state_.longest_lock_s, std::chrono::duration<double>(now - *locked_since_).count());
    if (!is_locked)
        locked_since_.reset();
}

bool Recorder::waitsTooLong() const {
    return locked_since_ && SteadyClock::now() - *locked_since_ > kLongestWaitAtEnd;
}

bool Recorder::write(const LiveItem& item) {
    if (const Status written = sink_->write(item); !written) {
        endWith(written.error());
        return false;
    }
    const std::lock_guard lock(mutex_);
    std::visit(RowCounter{state_}, item);
    return true;
}

bool Recorder::commit() {
    const auto begin = SteadyClock::now();
    const Status committed = sink_->commit();
    const int64_t took_ns =
        std::chrono::duration_cast<std::chrono::nanoseconds>(SteadyClock::now() - begin).count();
    if (!committed) {
        endWith(committed.error());
        return false;
    }
    const std::lock_guard lock(mutex_);
    ++state_.commits;
    state_.slowest_commit_ns = std::max(state_.slowest_commit_ns, took_ns);
    state_.committed_samples = state_.samples;
    return true;
}

bool Recorder::hasRoom() {
    const std::optional<int64_t> free_bytes = sink_->freeBytes();
    {
        const std::lock_guard lock(mutex_);
        state_.free_bytes = free_bytes;
        state_.remaining_s.reset();
        // Lost sound takes no room: it counts as time in which it might have come.
        const double bytes_per_s =
            static_cast<double>(state_.sound_bytes) * settings_.sample_rate_hz /
            static_cast<double>(std::max<int64_t>(1, state_.samples - state_.lost_samples));
        if (free_bytes && bytes_per_s > 0)
            state_.remaining_s =
                std::max(0.0, static_cast<double>(*free_bytes - settings_.reserve_bytes) / bytes_per_s);
    }
    if (!free_bytes || *free_bytes >= settings_.reserve_bytes)
        return true;
    complete(Error{ErrorKind::kDisk,
                   "The recording was ended because only " + megabytes(*free_bytes) +
                       " are free on the disk of " + sink_->path() + "; " + safeLength() +
                       " are safe in the file",
                   "Free some space, or record to another disk"});
    return false;
}

std::string Recorder::safeLength() const {
    char text[64];
    std::snprintf(text, sizeof text, "%.1f s",
                  static_cast<double>(state_.committed_samples) / settings_.sample_rate_hz);
    return text;
}

void Recorder::endWith(const Error& why) {
    Error told = why;
    told.message += "; the recording has ended, the first " + safeLength() + " are safe in " + sink_->path();
    {
        const std::lock_guard lock(mutex_);
        state_.samples = state_.committed_samples;
    }
    if (const Status back = sink_->rollBack(); !back)
        told.message += " (not yet as one file)";
    complete(told);
}

void Recorder::complete(std::optional<Error> trouble) {
    queue_.abandon();
    if (const Status finished = sink_->finish(); !finished) {
        if (!trouble)
            trouble = finished.error();
        trouble->message += "; the file could not be completed, the first " + safeLength() +
                            " stand in it and in the -wal file beside it";
        trouble->remedy = (trouble->kind == ErrorKind::kDisk ? "Free some space and run" : "Run") +
                          std::string(" `noctule --batch recover` on it");
    }
    const bool left_log = sink_->leftLog();
    const std::string path = sink_->path();
    sink_.reset();  // an ended recording holds no file: whoever recovers it need not wait for this object
    const std::lock_guard lock(mutex_);
    state_.ended = true;
    if (state_.longest_lock_s >= kWorthTelling_s)
        state_.notices.push_back(lockNotice(state_));
    if (left_log)
        state_.notices.push_back(path +
                                 ": another program reads the take, so a -wal file stands beside it; keep "
                                 "both together until the take is opened again.");
    if (!trouble)
        state_.committed_samples = state_.samples;
    state_.trouble = std::move(trouble);
}

}  // namespace noctule
