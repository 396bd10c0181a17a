// SPDX-License-Identifier: Apache-2.0
// The newest pose of the performer, from whoever makes poses to the loop that drives.
#pragma once

#include <mutex>
#include <optional>

#include "core/motion/timed_poses.h"
#include "core/robot/live_drive.h"

namespace noctule::robot_link {

class PoseFeed {
public:
    struct Newest {
        robot::PerformerSeen seen;
        int64_t time_ns = 0;  ///< of the take or the suit
        int64_t count = 0;    ///< of poses so far
    };

    PoseFeed(const Skeleton& skeleton, const robot::PerformerArms& performer)
        : skeleton_(skeleton), performer_(performer) {}

    /// A pose that was not seen or is no number is no pose.
    void put(const TimedPose& timed, int64_t arrived_ns) {
        if (!timed.pose || !isUsable(*timed.pose) ||
            timed.pose->q_parent_joint.size() != skeleton_.joints().size())
            return;
        Newest next;
        next.seen.arrived_ns = arrived_ns;
        next.seen.frame = performer_.at(globalPose(skeleton_, *timed.pose));
        next.seen.confidence = robot::confidenceFor(performer_.worstSigma_rad(timed.sigma_rad));
        next.seen.trunk_confidence = robot::confidenceFor(performer_.trunkSigma_rad(timed.sigma_rad));
        next.time_ns = timed.time_ns;
        const std::lock_guard lock(mutex_);
        next.count = newest_ ? newest_->count + 1 : 1;
        newest_ = next;
    }
    std::optional<Newest> newest() const {
        const std::lock_guard lock(mutex_);
        return newest_;
    }

private:
    const Skeleton skeleton_;
    const robot::PerformerArms performer_;
    mutable std::mutex mutex_;
    std::optional<Newest> newest_;
};

}  // namespace noctule::robot_link
