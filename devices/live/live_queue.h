// SPDX-License-Identifier: Apache-2.0
// From the device's thread to one that works more slowly. push() never waits for the reader: when more sound
// waits than the limit allows, blocks are dropped, and where they were stands a gap of the studio (link
// protocol, section 7). Everything else is small (3 kB a second) and stays, in order.
#pragma once

#include <chrono>
#include <condition_variable>
#include <list>
#include <mutex>
#include <optional>

#include "devices/live/live_item.h"

namespace noctule {

class LiveQueue {
public:
    enum class WhenFull {
        kOldestGoes,   ///< as little as possible is lost
        kNewestStays,  ///< one long gap: a reader whose work needs sound in one piece goes on with the
                       ///< present
    };
    /// `limit_samples`: of sound that waits at most.
    LiveQueue(int64_t limit_samples, WhenFull when_full);

    void push(LiveItem item);
    /// Nothing more will be pushed.
    void close();
    /// The reader has gone: what waits is dropped, what still comes is ignored.
    void abandon();

    /// The next item; nothing when none came until then, or when drained().
    std::optional<LiveItem> pop(std::chrono::steady_clock::time_point until);
    bool drained() const;

    struct Depth {
        int64_t samples = 0, deepest_samples = 0;  ///< of sound that waits; the most so far
        int64_t dropped_samples = 0;
    };
    Depth depth() const;

private:
    using Items = std::list<LiveItem>;
    void dropOldestBlock();
    void forget(Items::iterator item);

    const int64_t limit_samples_;
    const WhenFull when_full_;
    mutable std::mutex mutex_;
    std::condition_variable something_;
    Items items_;
    Items::iterator oldest_block_ = items_.end();  ///< no block lies before it
    Items::iterator last_gap_ = items_.end();      ///< the last one made here, while it waits
    Depth depth_;
    bool closed_ = false, abandoned_ = false;
};

}  // namespace noctule
