// SPDX-License-Identifier: Apache-2.0
// A UDP socket without Qt: ROS has its own loop.
#pragma once

#include <netinet/in.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/job/result.h"

namespace noctule::ros_bridge {

class UdpSocket {
public:
    /// "127.0.0.1:41950"; kUsage names what is wrong with the text, kDevice why the port cannot be had.
    static Result<UdpSocket> listen(const std::string& address);
    UdpSocket(UdpSocket&& other) noexcept;
    UdpSocket& operator=(UdpSocket&&) = delete;
    ~UdpSocket();

    int handle() const { return handle_; }
    std::string address() const;  ///< with the port that was chosen
    /// The next datagram; nothing when none waits.
    std::optional<std::vector<uint8_t>> receive();
    /// From now on send() goes to who sent the last datagram.
    void answerLast() { peer_ = sender_; }
    /// A datagram that does not get out is lost, as UDP's are.
    void send(const std::vector<uint8_t>& bytes) const;

private:
    explicit UdpSocket(int handle) : handle_(handle) {}

    int handle_;
    sockaddr_in sender_{};
    std::optional<sockaddr_in> peer_;
};

}  // namespace noctule::ros_bridge
