// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "devices/device/address.h"
#include "devices/device/driver_box_device.h"
#include "devices/device/replay_device.h"
#include "devices/device/serial_link.h"
#include "devices/device/tcp_link.h"

namespace noctule {

Result<std::unique_ptr<Device>> makeDevice(const std::string& address, const DeviceOptions& options) {
    const Result<DeviceAddress> read = readDeviceAddress(address);
    if (!read)
        return read.error();
    if (!std::isfinite(options.replay_speed) || options.replay_speed < 0)
        return Error{ErrorKind::kUsage, "a take cannot be played at this speed",
                     "1 is as fast as it was recorded, 2 twice as fast, 0 as fast as possible"};
    const std::string text = read->text();
    std::unique_ptr<Device> device;
    switch (read->kind) {
        case DeviceAddress::Kind::kTcp:
            device =
                std::make_unique<DriverBoxDevice>(text, std::make_unique<TcpLink>(read->host, read->port));
            break;
        case DeviceAddress::Kind::kSerial:
            device = std::make_unique<DriverBoxDevice>(text, std::make_unique<SerialLink>(read->path));
            break;
        case DeviceAddress::Kind::kReplay:
            device = std::make_unique<ReplayDevice>(text, read->path, options.replay_speed);
            break;
    }
    return device;
}

}  // namespace noctule
