// SPDX-License-Identifier: Apache-2.0
#include "core/inertial/golay.h"

#include <array>
#include <bit>

namespace noctule {
namespace {

constexpr uint32_t kGenerator = 0xC75;  // x^11 + x^10 + x^6 + x^5 + x^4 + x^2 + 1
constexpr uint32_t kUncorrectable = 0xFFFFFFFF;

constexpr uint32_t encodeByDivision(uint32_t data) {
    uint32_t remainder = data << 11;
    for (int bit = 22; bit >= 11; --bit)
        if (remainder >> bit & 1)
            remainder ^= kGenerator << (bit - 11);
    const uint32_t word = data << 11 | remainder;
    return word << 1 | (std::popcount(word) & 1);
}

struct Tables {
    std::array<uint32_t, 4096> codeword;
    std::array<uint32_t, 4096> error_of_syndrome;  ///< kUncorrectable where no pattern of up to 3 bits fits

    Tables() {
        for (uint32_t data = 0; data < codeword.size(); ++data)
            codeword[data] = encodeByDivision(data);
        error_of_syndrome.fill(kUncorrectable);
        note(0);
        for (int i = 0; i < 24; ++i) {
            note(1u << i);
            for (int j = 0; j < i; ++j) {
                note(1u << i | 1u << j);
                for (int k = 0; k < j; ++k)
                    note(1u << i | 1u << j | 1u << k);
            }
        }
    }
    uint32_t syndrome(uint32_t word) const { return (codeword[word >> 12] ^ word) & 0xFFF; }
    void note(uint32_t error) { error_of_syndrome[syndrome(error)] = error; }
};

const Tables& tables() {
    static const Tables instance;
    return instance;
}

}  // namespace

uint32_t golayEncode(uint32_t data) {
    return tables().codeword[data & 0xFFF];
}

std::optional<GolayDecoded> golayDecode(uint32_t word) {
    word &= 0xFFFFFF;
    const uint32_t error = tables().error_of_syndrome[tables().syndrome(word)];
    if (error == kUncorrectable)
        return std::nullopt;
    return GolayDecoded{(word ^ error) >> 12, std::popcount(error)};
}

}  // namespace noctule
