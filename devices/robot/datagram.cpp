// SPDX-License-Identifier: Apache-2.0
#include "devices/robot/datagram.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "devices/driver_box/crc32.h"

namespace noctule::robot_link {
namespace {

constexpr size_t kCrcAt = 48;
constexpr char kMagics[][5] = {"NRC1", "NRS1", "NRQ1"};  // by DatagramKind

template <class Value>
void put(std::vector<uint8_t>& bytes, Value value) {
    for (size_t i = 0; i < sizeof value; ++i)
        bytes.push_back(static_cast<uint8_t>(value >> (8 * i)));
}

template <class Value>
Value get(std::span<const uint8_t> bytes, size_t at) {
    Value value = 0;
    for (size_t i = 0; i < sizeof value; ++i)
        value = static_cast<Value>(value | (static_cast<Value>(bytes[at + i]) << (8 * i)));
    return value;
}

Error malformed(const std::string& what) {
    return {ErrorKind::kUnreadable, "a datagram " + what,
            "Send datagrams as devices/robot/README.md lays them out, version " +
                std::to_string(kDatagramVersion)};
}

uint32_t checksum(std::span<const uint8_t> bytes) {
    std::vector<uint8_t> without(bytes.begin(), bytes.end());
    std::fill_n(without.begin() + kCrcAt, 4, uint8_t{0});
    return link::crc32(without);
}

}  // namespace

bool areSound(const std::vector<double>& q, const std::vector<double>& v, size_t joints) {
    const auto sound = [](double value) { return std::abs(value) <= kLargestValue; };  // false for NaN
    return q.size() == joints && v.size() == joints && std::ranges::all_of(q, sound) &&
           std::ranges::all_of(v, sound);
}

uint64_t hashOf(const std::vector<std::string>& joints) {
    uint64_t hash = 0xCBF29CE484222325u;
    const auto add = [&](char letter) { hash = (hash ^ static_cast<uint8_t>(letter)) * 0x100000001B3u; };
    for (const std::string& joint : joints) {
        std::ranges::for_each(joint, add);
        add('\n');
    }
    return hash;
}

std::vector<uint8_t> encode(const Datagram& datagram) {
    require(datagram.q.size() <= kMostJoints && datagram.v.size() == datagram.q.size(),
            "a datagram holds as many speeds as places, and not too many");
    std::vector<uint8_t> bytes;
    bytes.reserve(kDatagramHeader + 16 * datagram.q.size());
    for (int i = 0; i < 4; ++i)
        bytes.push_back(static_cast<uint8_t>(kMagics[static_cast<size_t>(datagram.kind)][i]));
    put<uint16_t>(bytes, kDatagramVersion);
    put<uint16_t>(bytes, static_cast<uint16_t>(datagram.q.size()));
    put<uint64_t>(bytes, datagram.sequence);
    put<uint64_t>(bytes, static_cast<uint64_t>(datagram.time_ns));
    put<uint64_t>(bytes, datagram.joints_hash);
    put<uint64_t>(bytes, datagram.obeyed_sequence);
    put<uint32_t>(bytes, datagram.flags);
    put<uint32_t>(bytes, 0);
    put<uint32_t>(bytes, 0);  // kCrcAt
    put<uint32_t>(bytes, 0);
    for (const auto* values : {&datagram.q, &datagram.v})
        for (const double value : *values)
            put<uint64_t>(bytes, std::bit_cast<uint64_t>(value));
    const uint32_t crc = link::crc32(bytes);
    for (size_t i = 0; i < 4; ++i)
        bytes[kCrcAt + i] = static_cast<uint8_t>(crc >> (8 * i));
    return bytes;
}

Result<Datagram> decode(std::span<const uint8_t> bytes) {
    if (bytes.size() < kDatagramHeader)
        return malformed("of " + std::to_string(bytes.size()) + " bytes is too short");
    const auto magic = std::ranges::find_if(
        kMagics, [&](const char* candidate) { return std::memcmp(candidate, bytes.data(), 4) == 0; });
    if (magic == std::end(kMagics))
        return malformed("does not begin with NRC1, NRS1 or NRQ1");
    if (const auto version = get<uint16_t>(bytes, 4); version != kDatagramVersion)
        return malformed("has version " + std::to_string(version));
    const size_t joints = get<uint16_t>(bytes, 6);
    if (joints > kMostJoints || bytes.size() != kDatagramHeader + 16 * joints)
        return malformed("of " + std::to_string(bytes.size()) + " bytes does not fit its " +
                         std::to_string(joints) + " joints");
    if (get<uint32_t>(bytes, kCrcAt) != checksum(bytes))
        return malformed("is damaged: its checksum is wrong");
    Datagram datagram;
    datagram.kind = static_cast<DatagramKind>(magic - std::begin(kMagics));
    datagram.sequence = get<uint64_t>(bytes, 8);
    datagram.time_ns = static_cast<int64_t>(get<uint64_t>(bytes, 16));
    datagram.joints_hash = get<uint64_t>(bytes, 24);
    datagram.obeyed_sequence = get<uint64_t>(bytes, 32);
    datagram.flags = get<uint32_t>(bytes, 40);
    for (size_t i = 0; i < joints; ++i) {
        datagram.q.push_back(std::bit_cast<double>(get<uint64_t>(bytes, kDatagramHeader + 8 * i)));
        datagram.v.push_back(std::bit_cast<double>(get<uint64_t>(bytes, kDatagramHeader + 8 * (joints + i))));
    }
    if (!areSound(datagram.q, datagram.v, joints))
        return malformed("holds a joint value that is no number or beyond " +
                         std::to_string(static_cast<int>(kLargestValue)));
    if ((datagram.kind == DatagramKind::kQuery) != (joints == 0))
        return malformed(joints == 0 ? "that is no query has no joints" : "that is a query has joints");
    return datagram;
}

}  // namespace noctule::robot_link
