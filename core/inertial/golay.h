// SPDX-License-Identifier: Apache-2.0
// Extended binary Golay code (24,12), distance 8: data bits 23..12, check bits 11..1, even parity bit 0, as
// core/inertial/README.md section 4. Corrects up to three wrong bits; a word at distance 4 is never guessed.
#pragma once

#include <cstdint>
#include <optional>

namespace noctule {

/// The 24-bit codeword of 12 data bits; higher bits of `data` are ignored.
uint32_t golayEncode(uint32_t data);

struct GolayDecoded {
    uint32_t data = 0;       ///< 12 bits
    int corrected_bits = 0;  ///< 0..3
};

/// The codeword within distance 3 of a 24-bit word; absent when there is none (uncorrectable).
std::optional<GolayDecoded> golayDecode(uint32_t word);

}  // namespace noctule
