// SPDX-License-Identifier: Apache-2.0
// The datagram of the UDP interface: bytes <-> commands and states. Layout: README.md. No Qt, no sockets.
#pragma once

#include <span>

#include "core/job/result.h"
#include "devices/robot/link_types.h"

namespace noctule::robot_link {

inline constexpr uint16_t kDatagramVersion = 1;
inline constexpr size_t kDatagramHeader = 56;
inline constexpr size_t kMostDatagramBytes = kDatagramHeader + 16 * kMostJoints;

enum class DatagramKind { kCommand, kState, kQuery };

struct Datagram {
    DatagramKind kind = DatagramKind::kCommand;
    uint64_t sequence = 0;
    int64_t time_ns = 0;
    uint64_t joints_hash = 0;
    uint64_t obeyed_sequence = 0;  ///< of states
    uint32_t flags = 0;            ///< CommandFlag or StateFlag
    std::vector<double> q, v;      ///< empty in a query
};

/// FNV-1a, 64 bit, of the joints' names in order, each followed by a line feed.
uint64_t hashOf(const std::vector<std::string>& joints);

std::vector<uint8_t> encode(const Datagram& datagram);
/// kUnreadable says what is wrong with the bytes.
Result<Datagram> decode(std::span<const uint8_t> bytes);

}  // namespace noctule::robot_link
