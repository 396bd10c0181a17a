// SPDX-License-Identifier: Apache-2.0
// Finds devices as long as it lives, on a thread of its own: boxes in the network appear within 2 s and are
// gone when they have not answered for 4 s; serial ports that look like a box (USB) are listed as they are
// plugged in and are asked only on wish, because another program's device may hang there. Nothing blocks.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/job/result.h"
#include "devices/discovery/found_device.h"
#include "devices/driver_box/discovery.h"

namespace noctule {

struct DiscoveryOptions {
    uint16_t udp_port = link::kDiscoveryPort;  ///< where boxes listen
    bool serial_ports = true;
    bool probe_serial_ports = false;  ///< each as soon as it is seen
};

class Discovery {
public:
    /// Called on discovery's thread with the whole list whenever it has changed; hands on and returns.
    using Listener = std::function<void(const std::vector<FoundDevice>&)>;

    explicit Discovery(const DiscoveryOptions& options = {}, Listener listener = {});
    Discovery(const Discovery&) = delete;
    Discovery& operator=(const Discovery&) = delete;
    /// No call comes any more when it returns.
    ~Discovery();

    std::vector<FoundDevice> found() const;
    /// The serial ports have been looked for, and every probe asked for so far has ended.
    bool isSettled() const;

    /// Asks at an address who is there, within 1.4 s; the list tells. Serial ports and pseudo-terminals that
    /// are not in the list join it. kUsage for what is no address. Not for a device that is open.
    Status probe(const std::string& address);

private:
    class Search;
    std::unique_ptr<Search> search_;
};

}  // namespace noctule
