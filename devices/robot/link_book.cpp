// SPDX-License-Identifier: Apache-2.0
#include "devices/robot/link_book.h"

namespace noctule::robot_link {

Error unknownName(const std::string& address) {
    return {ErrorKind::kDevice, address + ": the network knows no computer of this name",
            "Check how the name is written, or give its address in numbers"};
}

LinkStatus LinkBook::status() const {
    const std::lock_guard lock(mutex_);
    return status_;
}

bool LinkBook::put(const RobotCommand& command) {
    const std::lock_guard lock(mutex_);
    const bool was_waiting = waiting_.has_value();
    status_.dropped += was_waiting;
    waiting_ = command;
    return !was_waiting;
}

std::optional<RobotCommand> LinkBook::takeCommand() {
    const std::lock_guard lock(mutex_);
    return std::exchange(waiting_, std::nullopt);
}

void LinkBook::sent(const RobotCommand& command, int64_t now_ns) {
    const std::lock_guard lock(mutex_);
    ++status_.sent;
    if (command.pose_arrived_ns > 0)
        status_.latency.add(now_ns - command.pose_arrived_ns);
}

void LinkBook::dropped() {
    const std::lock_guard lock(mutex_);
    ++status_.dropped;
}

void LinkBook::received(RobotState state, int64_t now_ns) {
    const std::lock_guard lock(mutex_);
    ++status_.states;
    status_.is_connected = true;
    status_.trouble.reset();
    status_.state = std::move(state);
    status_.state_arrived_ns = now_ns;
}

void LinkBook::refused(const Error& why) {
    const std::lock_guard lock(mutex_);
    ++status_.refused_messages;
    status_.trouble = why;
}

void LinkBook::connected() {
    const std::lock_guard lock(mutex_);
    status_.reconnections += was_connected_;
    was_connected_ = true;
    status_.is_connected = true;
    status_.trouble.reset();
}

void LinkBook::hopeless(const Error& why) {
    const std::lock_guard lock(mutex_);
    status_.is_connected = false;
    status_.is_hopeless = true;
    status_.trouble = why;
}

void LinkBook::lost(const Error& why) {
    const std::lock_guard lock(mutex_);
    status_.is_connected = false;
    status_.trouble = why;
}

}  // namespace noctule::robot_link
