// SPDX-License-Identifier: Apache-2.0
#include "devices/driver_box/discovery.h"

#include <algorithm>

#include "devices/driver_box/frame.h"
#include "devices/driver_box/messages.h"

namespace noctule::link {

bool isDiscoveryQuestion(ByteView datagram) {
    return std::equal(datagram.begin(), datagram.end(), kDiscoveryQuestion.begin(), kDiscoveryQuestion.end());
}

Bytes announcementDatagram(const Announcement& announcement) {
    return encodeFrame(static_cast<uint8_t>(Type::kAnnounce), 0, toPayload(announcement));
}

std::optional<Announcement> readAnnouncementDatagram(ByteView datagram, const std::string& where) {
    std::optional<Announcement> announcement;
    FrameReader reader;
    reader.push(datagram, 0, [&](const LinkFrame& frame) {
        const bool is_whole = frame.payload.size() + kHeaderBytes + kTailBytes == datagram.size();
        if (!is_whole || frame.header.type != static_cast<uint8_t>(Type::kAnnounce))
            return;
        const Result<Announcement> read = readAnnouncement(frame.payload, where);
        if (read)
            announcement = read.value();
    });
    return announcement;
}

Announcement announcementOf(const Hello& hello, uint16_t tcp_port, bool busy) {
    Announcement announcement;
    announcement.serial = hello.serial;
    announcement.name = hello.name;
    announcement.model = hello.model;
    announcement.tcp_port = tcp_port;
    announcement.sample_rate_hz = hello.sample_rate_hz;
    announcement.boards = hello.boardCount();
    announcement.sources = static_cast<int>(hello.suit.sources.size());
    announcement.busy = busy;
    return announcement;
}

}  // namespace noctule::link
