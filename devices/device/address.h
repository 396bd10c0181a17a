// SPDX-License-Identifier: Apache-2.0
// The address of a device as people type it, taken apart: "tcp://HOST[:PORT]" (41941 when left out, IPv6 in
// brackets), "serial:///dev/ttyACM0", "replay:TAKE.noctule". kUsage names what is wrong and what addresses
// look like.
#pragma once

#include <cstdint>
#include <string>

#include "core/job/result.h"

namespace noctule {

struct DeviceAddress {
    enum class Kind { kTcp, kSerial, kReplay };
    Kind kind = Kind::kTcp;
    std::string host;  ///< of kTcp, without brackets
    uint16_t port = 0;
    std::string path;  ///< of a serial port or a take

    /// In full: every spelling of an address gives the same text.
    std::string text() const;
};

Result<DeviceAddress> readDeviceAddress(const std::string& address);

}  // namespace noctule
