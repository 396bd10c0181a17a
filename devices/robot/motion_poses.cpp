// SPDX-License-Identifier: Apache-2.0
#include "devices/robot/motion_poses.h"

#include <algorithm>
#include <cmath>

#include "devices/machine/clock.h"

namespace noctule::robot_link {
namespace {

constexpr std::chrono::milliseconds kAgain{5};  ///< the same pose while paused

}  // namespace

MotionPoses::MotionPoses(TimedMotion motion, PoseFeed& feed, AtEnd at_end, bool plays)
    : motion_(std::move(motion)),
      feed_(feed),
      at_end_(at_end),
      playing_(plays),
      time_ns_(motion_.frames.front().time_ns),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

void MotionPoses::setPlaying(bool playing) {
    if (playing && !playing_ && at_end_ == AtEnd::kStays)
        from_start_ = true;
    playing_ = playing;
    woken_.notify_all();
}

/// False: that was the last one.
bool MotionPoses::next(std::chrono::steady_clock::time_point& due) {
    if (at_ + 1 < motion_.frames.size()) {
        due += std::chrono::nanoseconds(motion_.frames[at_ + 1].time_ns - motion_.frames[at_].time_ns);
        ++at_;
        return true;
    }
    due += std::chrono::nanoseconds(std::max<int64_t>(usualStep_ns(motion_), 1'000'000));
    if (at_end_ == AtEnd::kStays)
        playing_ = false;
    else
        at_ = 0;
    return at_end_ != AtEnd::kEnds;
}

void MotionPoses::run(const std::stop_token& stop) {
    auto due = std::chrono::steady_clock::now();
    while (!stop.stop_requested()) {
        time_ns_ = motion_.frames[at_].time_ns;
        feed_.put(motion_.frames[at_], steadyNow_ns());
        const bool plays = playing_;
        if (plays && from_start_.exchange(false) && at_ + 1 == motion_.frames.size()) {
            at_ = 0;
            continue;
        }
        if (!plays)
            due = std::chrono::steady_clock::now() + kAgain;
        else if (!next(due))
            break;
        std::unique_lock lock(mutex_);
        woken_.wait_until(lock, stop, due, [&] { return playing_ != plays; });
    }
    ended_ = true;
}

TimedMotion joinedEnds(TimedMotion motion, double seconds) {
    const int64_t step_ns = usualStep_ns(motion);
    if (motion.frames.size() < 2 || step_ns <= 0)
        return motion;
    const TimedPose last = motion.frames.back(), first = motion.frames.front();
    if (!last.pose || !first.pose)
        return motion;
    const auto steps = static_cast<int>(std::ceil(seconds * 1e9 / static_cast<double>(step_ns)));
    for (int i = 1; i < steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        const double eased = t * t * t * (10 + t * (-15 + 6 * t));
        motion.frames.push_back(
            {last.time_ns + i * step_ns, interpolate(*last.pose, *first.pose, eased), {}});
    }
    return motion;
}

}  // namespace noctule::robot_link
