// SPDX-License-Identifier: Apache-2.0
// A hash that names what a result was made from: FNV-1a, 64 bits, as 16 hexadecimal digits. It finds changes,
// it does not protect against forgery.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace noctule {

inline std::string textHash(std::string_view text) {
    uint64_t hash = 0xCBF29CE484222325u;
    for (const char c : text)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
    std::string digits(16, '0');
    for (size_t i = digits.size(); i-- > 0; hash >>= 4)
        digits[i] = "0123456789abcdef"[hash & 15];
    return digits;
}

}  // namespace noctule
