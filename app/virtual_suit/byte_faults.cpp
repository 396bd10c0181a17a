// SPDX-License-Identifier: Apache-2.0
#include "app/virtual_suit/byte_faults.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace noctule::virtual_suit {

void ByteFaults::setDropRate(double per_byte) {
    set(dropping_, per_byte);
}

void ByteFaults::setFlipRate(double per_bit) {
    set(flipping_, per_bit);
}

void ByteFaults::set(Fault& fault, double rate) {
    fault.rate = std::clamp(rate, 0.0, 1.0);
    drawNext(fault);
}

/// Geometric, by inversion.
void ByteFaults::drawNext(Fault& fault) {
    if (fault.rate >= 1) {
        fault.untouched = 0;
        return;
    }
    const double u = std::uniform_real_distribution<double>(0, 1)(random_);
    const double count = fault.rate > 0 ? std::floor(std::log1p(-u) / std::log1p(-fault.rate)) : 1e18;
    fault.untouched = static_cast<uint64_t>(std::clamp(count, 0.0, 1e18));
}

void ByteFaults::flip(link::Bytes& bytes) {
    uint64_t bit = flipping_.untouched;
    const uint64_t bits = 8 * bytes.size();
    while (bit < bits) {
        bytes[bit / 8] ^= static_cast<uint8_t>(1U << (bit % 8));
        drawNext(flipping_);
        bit += 1 + flipping_.untouched;
    }
    flipping_.untouched = bit - bits;
}

void ByteFaults::drop(link::Bytes& bytes) {
    size_t kept = 0;
    for (const uint8_t byte : bytes) {
        if (dropping_.untouched == 0) {
            drawNext(dropping_);
            continue;
        }
        --dropping_.untouched;
        bytes[kept++] = byte;
    }
    bytes.resize(kept);
}

link::Bytes ByteFaults::pass(link::Bytes bytes) {
    if (flipping_.rate > 0)
        flip(bytes);
    if (dropping_.rate > 0)
        drop(bytes);
    return bytes;
}

}  // namespace noctule::virtual_suit
