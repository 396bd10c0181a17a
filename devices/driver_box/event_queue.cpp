// SPDX-License-Identifier: Apache-2.0
#include "devices/driver_box/event_queue.h"

#include <algorithm>
#include <iterator>

namespace noctule::link {

void EventQueue::push(StudioEvent event) {
    if (const auto* greeted = std::get_if<Greeted>(&event))
        most_samples_ = kMostSound_s * greeted->hello.sample_rate_hz;
    if (const auto* block = std::get_if<AdcBlock>(&event))
        held_samples_ += block->sampleCount();
    events_.push_back(std::move(event));
    while (held_samples_ > most_samples_ && held_samples_ > 0)
        dropOldest();
}

/// A gap that ends where this one begins grows; other gaps stay as they are.
void EventQueue::dropOldest() {
    const auto oldest = std::find_if(events_.begin(), events_.end(), [](const StudioEvent& event) {
        return std::holds_alternative<AdcBlock>(event);
    });
    const auto& block = std::get<AdcBlock>(*oldest);
    const Gap gap{block.first_sample, block.sampleCount(), GapReason::kStudio};
    held_samples_ -= gap.sample_count;
    dropped_samples_ += gap.sample_count;
    Gap* before = oldest == events_.begin() ? nullptr : std::get_if<Gap>(&*std::prev(oldest));
    if (before && before->reason == GapReason::kStudio &&
        before->first_sample + before->sample_count == gap.first_sample) {
        before->sample_count += gap.sample_count;
        events_.erase(oldest);
    } else {
        *oldest = gap;
    }
}

std::vector<StudioEvent> EventQueue::takeAll() {
    std::vector<StudioEvent> all(std::make_move_iterator(events_.begin()),
                                 std::make_move_iterator(events_.end()));
    events_.clear();
    held_samples_ = 0;
    return all;
}

}  // namespace noctule::link
