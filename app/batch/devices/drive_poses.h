// SPDX-License-Identifier: Apache-2.0
// Who leads a robot that the verb `drive` moves: a take, or a suit that is worn right now.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/batch/verb.h"
#include "core/motion/timed_poses.h"
#include "devices/live/live_session.h"
#include "devices/robot/motion_poses.h"

namespace noctule::batch {

/// Poses that go into a feed, from a thread of their own.
class LivePoses {
public:
    virtual ~LivePoses() = default;
    virtual bool ended() const = 0;
    virtual std::optional<Error> trouble() const { return std::nullopt; }
    virtual void tell(nlohmann::json&) const {}
    /// Of a take that is being recorded.
    virtual std::optional<LiveSession::TakeInput> takeInput() const { return std::nullopt; }
    /// Ends the take that is being recorded, if there is one.
    virtual std::optional<StreamResult> endTake() { return std::nullopt; }
};

/// A take's poses at the times at which they were made, again and again when it `repeats`.
std::unique_ptr<LivePoses> posesOfTake(TimedMotion motion, robot_link::PoseFeed& feed, bool repeats);

/// Those of the suit at `address`, once its box has answered; `request` says where they go.
Result<std::unique_ptr<LivePoses>> posesOfSuit(const StreamRequest& request, const std::string& address,
                                               const JobContext& job);

}  // namespace noctule::batch
