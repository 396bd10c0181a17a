// SPDX-License-Identifier: Apache-2.0
// How long the interface did not answer: a timer asks to be called every few milliseconds, and the longest
// time between two calls is what a click at the worst moment would have waited. Our code is to blame for all
// of it, computing as well as waiting for a lock, a disk or another thread, except for what the machine had
// no core for: core_queue.h.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <algorithm>

#include "tests/ui/support/core_queue.h"

namespace noctule::ui::test {

constexpr double kLongestStall_ms = 50;
constexpr const char* kWhyNotJudged = "times are judged where nothing else needs the cores: NOCTULE_ALONE=1";
/// Whether the caller promises that nothing else needs the cores, as packaging/acceptance.sh does.
inline bool timesAreJudged() {
    return qEnvironmentVariableIsSet("NOCTULE_ALONE");
}

class StallWatch {
public:
    StallWatch() {
        timer_.setTimerType(Qt::PreciseTimer);
        timer_.setInterval(kTick_ms);
        QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { tick(); });
        restart();
        timer_.start();
    }

    void restart() {
        queue_.passed();
        clock_.start();
        longest_ms_ = longest_own_ms_ = 0;
    }
    /// Between two calls of the timer, by the clock on the wall.
    double longest_ms() const { return longest_ms_; }
    /// Likewise, without the time for which the machine had no core.
    double longestOwn_ms() const { return longest_own_ms_; }
    bool seesQueue() const { return queue_.isKept(); }

private:
    static constexpr int kTick_ms = 2;

    void tick() {
        const double gap_ms = static_cast<double>(clock_.nsecsElapsed()) * 1e-6;
        const CoreQueue::Passed passed = queue_.passed();
        clock_.start();
        longest_ms_ = std::max(longest_ms_, gap_ms);
        longest_own_ms_ = std::max(longest_own_ms_, passed.withoutQueues_ms(gap_ms));
    }

    QTimer timer_;
    QElapsedTimer clock_;
    CoreQueue queue_;
    double longest_ms_ = 0, longest_own_ms_ = 0;
};

}  // namespace noctule::ui::test
