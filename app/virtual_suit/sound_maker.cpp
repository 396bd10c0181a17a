// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/sound_maker.h"

#include <exception>

#include "app/virtual_suit/clock.h"

namespace noctule::virtual_suit {

SoundMaker::SoundMaker(std::unique_ptr<SoundSource> source, int board_count, int64_t ahead_samples)
    : source_(std::move(source)),
      board_count_(board_count),
      ahead_samples_(ahead_samples),
      simulated_(source_->isSimulated()),
      timed_(source_->isTimed()),
      begin_ns_(nowNs()),
      thread_([this] { run(); }) {}

SoundMaker::~SoundMaker() {
    {
        const std::lock_guard lock(mutex_);
        leaving_ = true;
    }
    changed_.notify_one();
    thread_.join();
}

void SoundMaker::restart(int64_t begin_ns) {
    {
        const std::lock_guard lock(mutex_);
        restart_wanted_ = true;
        begin_ns_ = begin_ns;
        made_.clear();
        end_sample_.reset();
        handed_over_ = 0;
    }
    changed_.notify_one();
}

void SoundMaker::ask(std::function<void(SoundSource&)> wish) {
    {
        const std::lock_guard lock(mutex_);
        wishes_.push_back(std::move(wish));
    }
    changed_.notify_one();
}

std::optional<SoundBlock> SoundMaker::next(int64_t due_samples) {
    std::optional<SoundBlock> block;
    {
        const std::lock_guard lock(mutex_);
        if (made_.empty() || made_.front().end() > due_samples)
            return block;
        block = std::move(made_.front());
        made_.pop_front();
        handed_over_ = block->end();
    }
    changed_.notify_one();
    return block;
}

bool SoundMaker::hasNext() {
    const std::lock_guard lock(mutex_);
    return !made_.empty();
}

bool SoundMaker::isReady() {
    const std::lock_guard lock(mutex_);
    return !made_.empty() || trouble_;
}

bool SoundMaker::ended() {
    const std::lock_guard lock(mutex_);
    return end_sample_ && handed_over_ > *end_sample_;
}

std::optional<Error> SoundMaker::takeTrouble() {
    const std::lock_guard lock(mutex_);
    return std::exchange(trouble_, std::nullopt);
}

void SoundMaker::run() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [&] { return leaving_ || restart_wanted_ || !wishes_.empty() || !hasEnough(); });
        if (leaving_)
            return;
        const auto wishes = std::exchange(wishes_, {});
        const auto begin_ns = std::exchange(restart_wanted_, false) ? std::optional(begin_ns_) : std::nullopt;
        lock.unlock();
        Result<SoundBlock> block = make(wishes, begin_ns);
        lock.lock();
        if (restart_wanted_)
            continue;  // what was made belongs to the time before
        if (!block)
            trouble_ = block.error();
        else
            made_.push_back(std::move(*block));
        if (source_is_over_ && !end_sample_)
            end_sample_ = block ? made_.back().adc.first_sample : next_sample_;
    }
}

bool SoundMaker::hasEnough() const {
    return !made_.empty() && made_.back().end() - handed_over_ >= ahead_samples_;
}

/// No exception leaves the thread. After an error comes silence.
Result<SoundBlock> SoundMaker::make(const std::vector<std::function<void(SoundSource&)>>& wishes,
                                    std::optional<int64_t> begin_ns) {
    try {
        for (const auto& wish : wishes)
            wish(*source_);
        Result<SoundBlock> block = makeNext(begin_ns);
        source_is_over_ = source_is_over_ || !block;
        return block;
    } catch (const std::exception& mistake) {
        source_is_over_ = true;
        return Error{ErrorKind::kInternal, std::string("internal error: ") + mistake.what(),
                     "Report it with the command line and the input"};
    }
}

Result<SoundBlock> SoundMaker::makeNext(std::optional<int64_t> begin_ns) {
    if (begin_ns) {
        next_sample_ = 0;
        source_is_over_ = false;
        if (Status begun = source_->restart(*begin_ns); !begun)
            return begun.error();
    }
    if (!source_is_over_) {
        auto block = source_->next();
        if (!block)
            return block.error();
        if (*block) {
            next_sample_ = (**block).end();
            return std::move(**block);
        }
        source_is_over_ = true;
    }
    const std::vector<int16_t> zeros(static_cast<size_t>(link::kUsualBlockSamples * board_count_));
    SoundBlock silence{{next_sample_, board_count_, zeros}, {}};
    next_sample_ = silence.end();
    return silence;
}

}  // namespace noctule::virtual_suit
