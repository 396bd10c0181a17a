// SPDX-License-Identifier: Apache-2.0
// The poses of a recorded motion as a source of poses for driving, each at its time, from a thread of its
// own. Paused it gives the same pose again and again, so that a robot can be synchronised to its beginning.
#pragma once

#include <atomic>
#include <condition_variable>
#include <thread>

#include "devices/robot/pose_feed.h"

namespace noctule::robot_link {

class MotionPoses {
public:
    enum class AtEnd {
        kEnds,     ///< no pose comes any more
        kStays,    ///< paused at its last pose; from the beginning when it is played again
        kRepeats,  ///< from the beginning
    };
    /// `plays`: at once. The motion has frames; the feed outlives this.
    MotionPoses(TimedMotion motion, PoseFeed& feed, AtEnd at_end, bool plays);

    /// From where it stands.
    void setPlaying(bool playing);
    void setAtEnd(AtEnd at_end) { at_end_ = at_end; }
    bool isPlaying() const { return playing_; }
    /// The last pose has been given, and none will come.
    bool ended() const { return ended_; }
    /// Of the pose that was given last, in the motion's own time.
    int64_t time_ns() const { return time_ns_; }

private:
    void run(const std::stop_token& stop);
    bool next(std::chrono::steady_clock::time_point& due);

    const TimedMotion motion_;
    PoseFeed& feed_;
    size_t at_ = 0;
    std::atomic<AtEnd> at_end_;
    std::atomic<bool> playing_, from_start_ = false, ended_ = false;
    std::atomic<int64_t> time_ns_;
    std::mutex mutex_;
    std::condition_variable_any woken_;
    std::jthread thread_;
};

/// The motion with a way from its last pose back to its first, so that it can be repeated without a jump:
/// joints turn the short way, slowly at both ends.
TimedMotion joinedEnds(TimedMotion motion, double seconds);

}  // namespace noctule::robot_link
