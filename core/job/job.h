// SPDX-License-Identifier: Apache-2.0
// What a long piece of work is given: where to report progress and how to learn that it should stop.
// The work itself starts no thread and reads no clock.
#pragma once

#include <atomic>
#include <string>

#include "core/job/result.h"

namespace noctule {

/// Receives progress. fraction is 0..1 and never falls within one stage; stage is a short text for people.
class ProgressSink {
public:
    virtual ~ProgressSink() = default;
    virtual void progress(double fraction, const std::string& stage) = 0;
};

/// Set from any thread (or a signal handler); the work looks at it at least ten times a second.
class CancelFlag {
public:
    void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
    bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

private:
    std::atomic<bool> cancelled_{false};
};

/// Handed down through long work by value; both parts may be absent.
struct JobContext {
    ProgressSink* sink = nullptr;
    const CancelFlag* cancel = nullptr;

    void progress(double fraction, const std::string& stage) const {
        if (sink)
            sink->progress(fraction, stage);
    }
    bool cancelled() const { return cancel && cancel->cancelled(); }
    static Error cancelledError() { return {ErrorKind::kCancelled, "Cancelled", ""}; }
};

}  // namespace noctule
