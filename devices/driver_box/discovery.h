// SPDX-License-Identifier: Apache-2.0
// Finding boxes (README.md, section 5): what goes into the datagrams, and how long to ask. Whoever owns the
// sockets sends the question to the multicast group on every interface and to the broadcast address; a box
// answers the sender's address and port with its announcement.
#pragma once

#include <optional>
#include <string_view>

#include "devices/driver_box/hello.h"

namespace noctule::link {

inline constexpr std::string_view kDiscoveryQuestion = "NOCTULE-DISCOVER";
inline constexpr std::string_view kDiscoveryGroup = "239.255.41.94";
inline constexpr uint16_t kDiscoveryPort = 41940;
inline constexpr int kDiscoveryTtl = 1;
inline constexpr int kDiscoveryQuestions = 3, kDiscoveryEvery_ms = 300;

inline constexpr int kSerialBaud = 3'000'000;
/// A port is probed with QUERY this often, each time waiting that long for HELLO.
inline constexpr int kSerialProbes = 2, kSerialProbe_ms = 700;

bool isDiscoveryQuestion(ByteView datagram);
Bytes announcementDatagram(const Announcement& announcement);
/// Nothing for anything but one whole ANNOUNCE of this protocol. `where`: the sender's address.
std::optional<Announcement> readAnnouncementDatagram(ByteView datagram, const std::string& where);

/// What a box says about itself.
Announcement announcementOf(const Hello& hello, uint16_t tcp_port, bool busy);

}  // namespace noctule::link
