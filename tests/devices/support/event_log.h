// SPDX-License-Identifier: Apache-2.0
// What a device said, collected on its thread and waited for on the test's.
#pragma once

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>
#include <vector>

#include "devices/device/device.h"
#include "tests/devices/support/test_box.h"

namespace noctule::test {

class EventLog {
public:
    Device::Listener listener() {
        return [this](DeviceEvent event) {
            const std::lock_guard lock(mutex_);
            EXPECT_GE(event.arrived_ns, last_ns_);
            last_ns_ = event.arrived_ns;
            events_.push_back(std::move(event.event));
            news_.notify_all();
        };
    }
    /// False when `count` of these have not come in time.
    template <class Event>
    bool waitFor(size_t count = 1, double seconds = 10) {
        std::unique_lock lock(mutex_);
        return news_.wait_for(lock, std::chrono::duration<double>(seconds),
                              [&] { return countLocked<Event>() >= count; });
    }
    template <class Event>
    size_t count() const {
        const std::lock_guard lock(mutex_);
        return countLocked<Event>();
    }
    template <class Event>
    Event last() const {
        const std::lock_guard lock(mutex_);
        for (auto event = events_.rbegin(); event != events_.rend(); ++event)
            if (const auto* one = std::get_if<Event>(&*event))
                return *one;
        ADD_FAILURE() << "no such event";
        return {};
    }
    std::vector<link::StudioEvent> all() const {
        const std::lock_guard lock(mutex_);
        return events_;
    }

    /// From the last Started on: every sample of the tiny take (silence behind its end) came once, bit for
    /// bit, or lies in a gap; every pulse came before its block, but for those that a lost link took along.
    /// Gives the end.
    int64_t expectTinySound() const {
        int64_t next = 0, gaps = 0;
        size_t pulse = 0;
        bool link_was_lost = false;
        const TakeSound& sound = TakeSound::tiny();
        for (const link::StudioEvent& event : sinceStarted()) {
            if (const auto* gap = std::get_if<link::Gap>(&event)) {
                EXPECT_EQ(gap->first_sample, next);
                next += gap->sample_count;
                gaps += gap->sample_count;
            } else if (const auto* block = std::get_if<link::SoundBlock>(&event)) {
                EXPECT_EQ(block->first_sample, next);
                EXPECT_TRUE(*block == sound.block(next, block->sampleCount())) << "block at " << next;
                next += block->sampleCount();
                EXPECT_TRUE(link_was_lost || pulse >= sound.pulses.size() ||
                            sound.pulses[pulse].sample >= next);
            } else if (const auto* pulses = std::get_if<link::Pulses>(&event)) {
                for (const link::EmittedPulse& one : *pulses) {
                    while (link_was_lost && pulse < sound.pulses.size() &&
                           sound.pulses[pulse].sample < one.sample)
                        ++pulse;
                    EXPECT_TRUE(pulse < sound.pulses.size() && one == sound.pulses[pulse++]);
                }
            } else if (std::holds_alternative<link::LinkLost>(event)) {
                link_was_lost = true;
            }
        }
        lost_samples_ = gaps;
        return next;
    }
    /// In gaps, of what expectTinySound() looked at.
    int64_t lostSamples() const { return lost_samples_; }

private:
    template <class Event>
    size_t countLocked() const {
        size_t count = 0;
        for (const link::StudioEvent& event : events_)
            count += std::holds_alternative<Event>(event) ? 1 : 0;
        return count;
    }
    std::vector<link::StudioEvent> sinceStarted() const {
        const auto events = all();
        auto begin = events.begin();
        for (auto event = events.begin(); event != events.end(); ++event)
            if (std::holds_alternative<link::Started>(*event))
                begin = event;
        return {begin, events.end()};
    }

    mutable std::mutex mutex_;
    std::condition_variable news_;
    std::vector<link::StudioEvent> events_;
    int64_t last_ns_ = 0;
    mutable int64_t lost_samples_ = 0;
};

}  // namespace noctule::test
