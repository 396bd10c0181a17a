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
      queue_(static_cast<int64_t>(settings.queue_s * settings.sample_rate_hz)) {
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
            const std::optional<LiveItem> item = queue_.pop(next_commit);
            if (item && !write(*item))
                return;
            if (SteadyClock::now() >= next_commit) {
                if (!commit() || !hasRoom())
                    return;
                next_commit = SteadyClock::now() + kCommitEvery;
            }
            if (!item && queue_.drained())
                return complete(std::nullopt);
        }
    } catch (const std::exception& mistake) {
        endWith({ErrorKind::kInternal, sink_->path() + ": internal error: " + mistake.what(),
                 "Please report it"});
    }
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
                   sink_->path() + ": the recording was ended because only " + megabytes(*free_bytes) +
                       " are free on the disk; " + safeLength() + " are safe in the file",
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
        trouble->remedy = "Free some space and run `noctule --batch recover` on it";
    }
    const std::lock_guard lock(mutex_);
    state_.ended = true;
    if (!trouble)
        state_.committed_samples = state_.samples;
    state_.trouble = std::move(trouble);
}

}  // namespace noctule
