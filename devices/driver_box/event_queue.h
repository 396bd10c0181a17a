// SPDX-License-Identifier: Apache-2.0
// Between the thread that reads the link and those that record and show (README.md, section 7): holds events
// in order and never more than two seconds of sound. Beyond that the oldest blocks go and a gap of reason
// `studio` stands in their place; nothing else is ever dropped. It locks nothing: its owner does.
#pragma once

#include <deque>

#include "devices/driver_box/studio_event.h"

namespace noctule::link {

class EventQueue {
public:
    static constexpr int64_t kMostSound_s = 2;

    void push(StudioEvent event);
    /// All that is held, oldest first.
    std::vector<StudioEvent> takeAll();

    int64_t heldSamples() const { return held_samples_; }
    int64_t droppedSamples() const { return dropped_samples_; }

private:
    void dropOldest();

    std::deque<StudioEvent> events_;
    int64_t most_samples_ = 0;  ///< known since Greeted
    int64_t held_samples_ = 0, dropped_samples_ = 0;
};

}  // namespace noctule::link
