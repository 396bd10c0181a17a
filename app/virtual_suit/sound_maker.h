// SPDX-License-Identifier: Apache-2.0
// Makes a source's sound ahead, on a thread of its own, and hands it over block by block. After the source's
// end, or after trouble with it, comes silence: a converter does not stop.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "app/virtual_suit/sound_source.h"

namespace noctule::virtual_suit {

class SoundMaker {
public:
    /// Begins at once. `ahead_samples`: how much is made before it is wanted.
    SoundMaker(std::unique_ptr<SoundSource> source, int board_count, int64_t ahead_samples);
    ~SoundMaker();
    SoundMaker(const SoundMaker&) = delete;
    SoundMaker& operator=(const SoundMaker&) = delete;

    /// From sample 0 again, taken at that instant; nothing of before is handed over any more.
    void restart(int64_t begin_ns);
    /// The next block if it is made and ends at `due_samples` or before. Never waits.
    std::optional<SoundBlock> next(int64_t due_samples);
    /// The next block is made, and only not due yet.
    bool hasNext();
    /// Done with the source between two blocks.
    void ask(std::function<void(SoundSource&)> wish);

    /// Something is made: the first block of a simulation may take seconds.
    bool isReady();
    bool isSimulated() const { return simulated_; }
    bool isTimed() const { return timed_; }
    Status accepts(const ControlCommand& command) const { return source_->accepts(command); }
    /// The source's last block has been handed over.
    bool ended();
    /// Once each.
    std::optional<Error> takeTrouble();

private:
    void run();
    bool hasEnough() const;
    Result<SoundBlock> make(const std::vector<std::function<void(SoundSource&)>>& wishes,
                            std::optional<int64_t> begin_ns);
    Result<SoundBlock> makeNext(std::optional<int64_t> begin_ns);

    const std::unique_ptr<SoundSource> source_;
    const int board_count_;
    const int64_t ahead_samples_;
    const bool simulated_, timed_;

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<SoundBlock> made_;
    std::vector<std::function<void(SoundSource&)>> wishes_;
    std::optional<Error> trouble_;
    bool leaving_ = false, restart_wanted_ = true;
    int64_t begin_ns_;
    std::optional<int64_t> end_sample_;  ///< silence begins there
    int64_t handed_over_ = 0;

    // Of the thread alone
    bool source_is_over_ = false;
    int64_t next_sample_ = 0;

    std::thread thread_;
};

}  // namespace noctule::virtual_suit
