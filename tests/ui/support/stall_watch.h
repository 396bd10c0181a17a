// SPDX-License-Identifier: Apache-2.0
// How long the interface did not answer: a timer asks to be called every few milliseconds, and the longest
// time by which a call came too late is what a click at the worst moment would have waited. It counts
// everything that the interface's thread does and also when the machine gives the thread no core; the
// processor time that the thread itself used in the same gap tells the two apart.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <algorithm>
#include <ctime>

namespace noctule::ui::test {

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
        clock_.start();
        cpu_ms_ = threadTime_ms();
        longest_ms_ = longest_busy_ms_ = 0;
    }
    /// Between two calls of the timer.
    double longest_ms() const { return longest_ms_; }
    /// Of these the time in which the thread itself was computing: what our code is to blame for.
    double longestBusy_ms() const { return longest_busy_ms_; }

private:
    static constexpr int kTick_ms = 2;

    static double threadTime_ms() {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
    }
    void tick() {
        const double cpu_ms = threadTime_ms();
        longest_ms_ = std::max(longest_ms_, static_cast<double>(clock_.nsecsElapsed()) * 1e-6);
        longest_busy_ms_ = std::max(longest_busy_ms_, cpu_ms - cpu_ms_);
        cpu_ms_ = cpu_ms;
        clock_.start();
    }

    QTimer timer_;
    QElapsedTimer clock_;
    double cpu_ms_ = 0, longest_ms_ = 0, longest_busy_ms_ = 0;
};

}  // namespace noctule::ui::test
