// SPDX-License-Identifier: Apache-2.0
// How a link fares, written on its thread and read from any other; and the newest command on its way there.
#pragma once

#include <mutex>

#include "devices/robot/robot_interface.h"

namespace noctule::robot_link {

/// Of an address whose name no network knows.
Error unknownName(const std::string& address);

class LinkBook {
public:
    LinkStatus status() const;

    /// True: the thread has to be woken; false: it already was for an older command, which is dropped.
    bool put(const RobotCommand& command);
    std::optional<RobotCommand> takeCommand();

    void sent(const RobotCommand& command, int64_t now_ns);
    void dropped();
    void received(RobotState state, int64_t now_ns);
    /// A message that could not be read.
    void refused(const Error& why);
    void connected();
    void lost(const Error& why);
    /// Nothing will be tried any more.
    void hopeless(const Error& why);

private:
    mutable std::mutex mutex_;
    LinkStatus status_;
    std::optional<RobotCommand> waiting_;
    bool was_connected_ = false;
};

}  // namespace noctule::robot_link
