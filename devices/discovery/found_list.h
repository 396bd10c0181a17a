// SPDX-License-Identifier: Apache-2.0
// The devices that are there at the moment, as a value: answers, serial ports and the time go in. A box that
// answers from several addresses of its computer is listed once, on loopback if it answers there. What has
// not answered for 4 s is gone. Every function tells whether the list has changed. Times are nanoseconds of
// any clock that does not go back.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "devices/discovery/found_device.h"
#include "devices/driver_box/hello.h"

namespace noctule {

class FoundList {
public:
    static constexpr int64_t kForgetAfter_ns = 4'000'000'000;

    /// `host`: the sender's address.
    bool announced(const link::Announcement& announcement, const std::string& host, int64_t now_ns);
    bool forgetSilent(int64_t now_ns);

    /// All ports that are there now; those known already keep what probing them has told.
    bool setPorts(const std::vector<FoundDevice>& ports);
    bool probing(const std::string& address);
    /// No HELLO: nobody answered.
    bool probed(const std::string& address, const std::optional<link::Hello>& hello);

    /// Boxes of the network first, by name and serial number, then the others by address.
    std::vector<FoundDevice> devices() const;

private:
    struct Heard {
        std::string host;
        int64_t when_ns = 0;
    };
    struct Box {
        link::Announcement announcement;
        std::vector<Heard> hosts;  ///< in the order in which they were first heard
    };
    static std::string addressOf(const Box& box);
    static FoundDevice deviceOf(const Box& box);

    /// Virtual suits on one computer may share a serial number, not a port.
    std::map<std::pair<std::string, uint16_t>, Box> boxes_;
    std::map<std::string, FoundDevice> ports_;  ///< by address; also what else was probed
};

}  // namespace noctule
