// SPDX-License-Identifier: Apache-2.0
// Writes what a device sends into a take, on a thread of its own, with a commit ten times a second: what was
// committed survives a crash. A disk that is slow for less than two seconds costs nothing; a longer one costs
// the oldest sound, marked as gaps. A disk that fills up or fails ends the take intact, with the reason.
// Another program that reads or locks the take costs nothing: what comes waits for it (recorder_backlog.h).
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "devices/live/live_queue.h"
#include "devices/live/recorder_backlog.h"
#include "devices/live/take_sink.h"

namespace noctule {

struct RecorderSettings {
    int sample_rate_hz = 150000;
    /// The take ends while this much is still free: SQLite needs some of it (16 MB) to make one file, and a
    /// system with a full disk is no good to anybody.
    int64_t reserve_bytes = 256'000'000;
    double queue_s = 2;  ///< of sound that may wait for the disk
};

/// How a recording fares.
struct RecorderState {
    std::string path;
    int64_t samples = 0;            ///< one after the last that was written
    int64_t committed_samples = 0;  ///< of those, safe
    int64_t lost_samples = 0;       ///< of all boards at once, in gaps
    int64_t gaps = 0;
    LiveQueue::Depth queue;
    int64_t commits = 0, slowest_commit_ns = 0;
    int64_t sound_bytes = 0;
    std::optional<int64_t> free_bytes;
    std::optional<double> remaining_s;  ///< until the reserve is reached, at the rate so far
    bool ended = false;                 ///< nothing more is written
    bool is_locked = false;             ///< another program holds the take; what comes waits
    double longest_lock_s = 0;
    RecorderBacklog::Extent backlog;
    std::vector<std::string> notices;  ///< whole sentences, when it has ended
    std::optional<Error> trouble;      ///< why it ended unasked, and what is safe
};

class Recorder {
public:
    static constexpr std::chrono::milliseconds kCommitEvery{100};
    /// After everything has come, so long at most for another program that holds the take.
    static constexpr std::chrono::seconds kLongestWaitAtEnd{120};

    Recorder(std::unique_ptr<TakeSink> sink, const RecorderSettings& settings);
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;
    /// finish()
    ~Recorder();

    /// From one thread at a time; never waits for the disk.
    void push(LiveItem item) { queue_.push(std::move(item)); }
    /// From any thread, never waits for the disk.
    RecorderState state() const;
    /// Writes what still waits and leaves one complete file; waits for that.
    RecorderState finish();

private:
    void work();
    bool drain();
    void noteLock(bool is_locked);
    bool waitsTooLong() const;
    bool write(const LiveItem& item);
    bool commit();
    bool hasRoom();
    void endWith(const Error& why);
    void complete(std::optional<Error> trouble);
    std::string safeLength() const;

    std::unique_ptr<TakeSink> sink_;
    const RecorderSettings settings_;
    LiveQueue queue_;
    RecorderBacklog backlog_;
    std::optional<std::chrono::steady_clock::time_point> locked_since_;
    mutable std::mutex mutex_;
    RecorderState state_;  ///< written by the thread only
    std::thread thread_;
};

}  // namespace noctule
