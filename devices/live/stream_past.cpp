// SPDX-License-Identifier: Apache-2.0
#include "devices/live/stream_past.h"

#include <algorithm>

namespace noctule {
namespace {

bool isSound(const StreamEvent& event) {
    return std::holds_alternative<ArrivedBlock>(event);
}

bool reachesBeyond(const StreamEvent& event, int64_t sample) {
    if (const auto* block = std::get_if<ArrivedBlock>(&event))
        return block->endSample() > sample;
    const auto* gap = std::get_if<link::Gap>(&event);
    return gap && gap->first_sample + gap->sample_count > sample;
}

}  // namespace

void StreamPast::Earlier::note(const StreamEvent& event) {
    if (const auto* told = std::get_if<link::BoxStatus>(&event))
        status = *told;
    else if (const auto* announced = std::get_if<link::Pulses>(&event))
        pulses.insert(pulses.end(), announced->begin(), announced->end());
}

void StreamPast::add(const StreamEvent& event) {
    events_.push_back(event);
    const auto* block = std::get_if<ArrivedBlock>(&event);
    if (!block)
        return;
    end_sample_ = block->endSample();
    held_samples_ += block->sampleCount();
    while (held_samples_ - oldestBlock().sampleCount() >= hold_samples_)
        forgetOldestBlock();
}

const ArrivedBlock& StreamPast::oldestBlock() const {
    return std::get<ArrivedBlock>(*std::ranges::find_if(events_, isSound));
}

void StreamPast::forgetOldestBlock() {
    held_samples_ -= oldestBlock().sampleCount();
    for (; !isSound(events_.front()); events_.pop_front())
        forgotten_.note(events_.front());
    events_.pop_front();
    std::erase_if(forgotten_.pulses, [first = oldestBlock().firstSample()](const link::EmittedPulse& pulse) {
        return pulse.sample < first;
    });
}

int64_t StreamPast::boundaryAt(int64_t sample) const {
    const auto block = std::ranges::find_if(
        events_, [&](const StreamEvent& event) { return isSound(event) && reachesBeyond(event, sample); });
    return block == events_.end() ? end_sample_ : std::get<ArrivedBlock>(*block).firstSample();
}

std::vector<StreamEvent> StreamPast::since(int64_t first_sample) const {
    const auto begin = std::ranges::find_if(
        events_, [&](const StreamEvent& event) { return reachesBeyond(event, first_sample); });
    Earlier earlier = forgotten_;
    std::for_each(events_.begin(), begin, [&](const StreamEvent& event) { earlier.note(event); });
    std::vector<StreamEvent> told;
    if (earlier.status)
        told.push_back(*earlier.status);
    told.push_back(earlier.pulses);
    told.insert(told.end(), begin, events_.end());
    return told;
}

}  // namespace noctule
