// SPDX-License-Identifier: Apache-2.0
// "Recording begins" and "recording has ended", as capture programs tell one another (the UDP capture trigger
// of Vicon, OptiTrack, Xsens, Qualisys): one datagram, one XML element <CaptureStart> or <CaptureStop>, in it
// elements with an attribute VALUE, a NUL at the end or not. What we have no use for is passed over.
#pragma once

#include <QByteArray>
#include <optional>
#include <string>

namespace noctule {

struct CaptureMessage {
    enum class Kind { kStart, kStop };
    Kind kind = Kind::kStart;
    std::string name;
    std::string notes, description;  ///< of kStart
    std::string packet_id;           ///< the same in repetitions; empty: not told
    bool operator==(const CaptureMessage&) const = default;
};

/// More is not looked at: such a message fits one packet of the network.
inline constexpr int kMostMessageBytes = 8192;

/// Nothing for anything else.
std::optional<CaptureMessage> readCaptureMessage(const QByteArray& datagram);

}  // namespace noctule
