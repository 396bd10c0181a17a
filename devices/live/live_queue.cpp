// SPDX-License-Identifier: Apache-2.0
#include "devices/live/live_queue.h"

#include <algorithm>
#include <utility>

namespace noctule {
namespace {

bool isBlock(const LiveItem& item) {
    return std::holds_alternative<ArrivedBlock>(item);
}

}  // namespace

LiveQueue::LiveQueue(int64_t limit_samples, WhenFull when_full)
    : limit_samples_(limit_samples), when_full_(when_full) {}

void LiveQueue::push(LiveItem item) {
    {
        const std::lock_guard lock(mutex_);
        if (closed_ || abandoned_)
            return;
        int64_t newest = 0;
        if (const auto* block = std::get_if<ArrivedBlock>(&item))
            newest = block->sound->sampleCount();
        depth_.samples += newest;
        items_.push_back(std::move(item));
        if (oldest_block_ == items_.end() && isBlock(items_.back()))
            oldest_block_ = std::prev(items_.end());
        if (depth_.samples > limit_samples_) {
            const int64_t stays = when_full_ == WhenFull::kNewestStays ? newest : limit_samples_;
            while (depth_.samples > std::min(stays, limit_samples_))
                dropOldestBlock();
        }
        depth_.deepest_samples = std::max(depth_.deepest_samples, depth_.samples);
    }
    something_.notify_one();
}

void LiveQueue::dropOldestBlock() {
    const ArrivedBlock block = std::get<ArrivedBlock>(*oldest_block_);
    const auto dropped = oldest_block_;
    oldest_block_ = std::find_if(std::next(dropped), items_.end(), isBlock);
    const int64_t count = block.sound->sampleCount();
    depth_.samples -= count;
    depth_.dropped_samples += count;
    if (last_gap_ != items_.end()) {
        GapRow& gap = std::get<GapRow>(*last_gap_);
        if (gap.first_sample + gap.sample_count == block.firstSample()) {
            gap.sample_count += count;
            items_.erase(dropped);
            return;
        }
    }
    *dropped = GapRow{block.firstSample(), count, std::nullopt, kGapOfStudio};
    last_gap_ = dropped;
}

void LiveQueue::close() {
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }
    something_.notify_one();
}

void LiveQueue::abandon() {
    Items thrown_away;
    const std::lock_guard lock(mutex_);
    abandoned_ = true;
    items_.swap(thrown_away);
    oldest_block_ = last_gap_ = items_.end();
    depth_.dropped_samples += std::exchange(depth_.samples, 0);
}

void LiveQueue::forget(Items::iterator item) {
    if (item == oldest_block_)
        oldest_block_ = std::find_if(std::next(item), items_.end(), isBlock);
    if (item == last_gap_)
        last_gap_ = items_.end();
}

std::optional<LiveItem> LiveQueue::pop(std::chrono::steady_clock::time_point until) {
    std::unique_lock lock(mutex_);
    something_.wait_until(lock, until, [this] { return !items_.empty() || closed_ || abandoned_; });
    if (items_.empty())
        return std::nullopt;
    forget(items_.begin());
    std::optional<LiveItem> item = std::move(items_.front());
    items_.pop_front();
    if (const auto* block = std::get_if<ArrivedBlock>(&*item))
        depth_.samples -= block->sound->sampleCount();
    return item;
}

bool LiveQueue::drained() const {
    const std::lock_guard lock(mutex_);
    return items_.empty() && (closed_ || abandoned_);
}

LiveQueue::Depth LiveQueue::depth() const {
    const std::lock_guard lock(mutex_);
    return depth_;
}

}  // namespace noctule
