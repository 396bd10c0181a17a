// SPDX-License-Identifier: Apache-2.0
// CRC-32 as zlib and Ethernet have it (ISO-HDLC): polynomial 0x04C11DB7 reflected, start and final XOR
// 0xFFFFFFFF. Of ASCII "123456789" it is 0xCBF43926, of nothing 0. README.md, section 1.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace noctule::link {

namespace detail {

constexpr std::array<uint32_t, 256> crcTable() {
    std::array<uint32_t, 256> table{};
    for (uint32_t i = 0; i < table.size(); ++i) {
        uint32_t remainder = i;
        for (int bit = 0; bit < 8; ++bit)
            remainder = (remainder & 1) ? (remainder >> 1) ^ 0xEDB88320u : remainder >> 1;
        table[i] = remainder;
    }
    return table;
}

inline constexpr std::array<uint32_t, 256> kCrcTable = crcTable();

}  // namespace detail

constexpr uint32_t crc32(std::span<const uint8_t> bytes) {
    uint32_t crc = 0xFFFFFFFFu;
    for (const uint8_t byte : bytes)
        crc = detail::kCrcTable[(crc ^ byte) & 0xFF] ^ (crc >> 8);
    return ~crc;
}

}  // namespace noctule::link
