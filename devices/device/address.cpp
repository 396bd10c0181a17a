// SPDX-License-Identifier: Apache-2.0
#include "devices/device/address.h"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "devices/driver_box/hello.h"

namespace noctule {

namespace {

constexpr std::string_view kTcp = "tcp://", kSerial = "serial://", kReplay = "replay:";

Error badAddress(const std::string& address, const std::string& why) {
    return {ErrorKind::kUsage, "'" + address + "' is no address of a device: " + why,
            "Addresses look like tcp://10.0.0.7:41941, serial:///dev/ttyACM0 or replay:walk_001.noctule"};
}

bool isHostName(const std::string& host) {
    return !host.empty() && std::all_of(host.begin(), host.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-' || c == '_';
    });
}

/// With a zone as in fe80::1%eth0.
bool isIpv6(const std::string& host) {
    const std::string digits = host.substr(0, host.find('%'));
    return std::count(digits.begin(), digits.end(), ':') >= 2 &&
           std::all_of(digits.begin(), digits.end(), [](char c) {
               return std::isxdigit(static_cast<unsigned char>(c)) || c == ':' || c == '.';
           });
}

uint16_t readPort(const std::string& text) {
    int port = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
    const bool good = error == std::errc() && end == text.data() + text.size() && port >= 1 && port <= 65535;
    return good ? static_cast<uint16_t>(port) : uint16_t{0};
}

Result<DeviceAddress> readTcp(const std::string& address) {
    std::string rest = address.substr(kTcp.size());
    if (rest.ends_with('/'))
        rest.pop_back();
    DeviceAddress tcp{DeviceAddress::Kind::kTcp, rest, link::kDefaultTcpPort, {}};
    const bool in_brackets = rest.starts_with('[') && rest.find(']') != std::string::npos;
    const size_t host_end = in_brackets ? rest.find(']') + 1 : std::min(rest.find(':'), rest.size());
    const std::string after = rest.substr(host_end);
    tcp.host = in_brackets ? rest.substr(1, host_end - 2) : rest.substr(0, host_end);
    if (tcp.host.empty())
        return badAddress(address, "it names no computer");
    if (!after.empty() && after[0] == ':')
        tcp.port = readPort(after.substr(1));
    if (!(in_brackets ? isIpv6(tcp.host) : isHostName(tcp.host)) || (!after.empty() && after[0] != ':'))
        return badAddress(address, "'" + rest + "' is no name or number of a computer");
    if (tcp.port == 0)
        return badAddress(address, "a port is a number from 1 to 65535");
    return tcp;
}

}  // namespace

std::string DeviceAddress::text() const {
    if (kind == Kind::kSerial)
        return std::string(kSerial) + path;
    if (kind == Kind::kReplay)
        return std::string(kReplay) + path;
    const bool is_ipv6 = host.find(':') != std::string::npos;
    return std::string(kTcp) + (is_ipv6 ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

Result<DeviceAddress> readDeviceAddress(const std::string& address) {
    if (address.starts_with(kTcp))
        return readTcp(address);
    if (address.starts_with(kSerial)) {
        const std::string path = address.substr(kSerial.size());
        if (path.size() < 2 || path[0] != '/')
            return badAddress(address, "a serial port is named by its whole path, after three slashes");
        return DeviceAddress{DeviceAddress::Kind::kSerial, {}, 0, path};
    }
    if (address.starts_with(kReplay)) {
        const std::string path = address.substr(kReplay.size());
        if (path.empty())
            return badAddress(address, "it names no take");
        return DeviceAddress{DeviceAddress::Kind::kReplay, {}, 0, path};
    }
    return badAddress(address, "it begins with none of tcp://, serial:// and replay:");
}

}  // namespace noctule
