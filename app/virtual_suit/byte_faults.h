// SPDX-License-Identifier: Apache-2.0
// A bad cable between the box and the studio: bytes that get lost, bits that turn over. Pure: the same seed
// and the same bytes, in pieces of any size, come out the same.
#pragma once

#include <random>

#include "devices/driver_box/wire.h"

namespace noctule::virtual_suit {

class ByteFaults {
public:
    explicit ByteFaults(uint64_t seed) : random_(seed) {}

    /// 0 to 1, of each byte; the faults are independent of each other.
    void setDropRate(double per_byte);
    /// 0 to 1, of each bit.
    void setFlipRate(double per_bit);

    link::Bytes pass(link::Bytes bytes);

private:
    /// How many bytes or bits come through before the next one that does not.
    struct Fault {
        double rate = 0;
        uint64_t untouched = 0;
    };
    void set(Fault& fault, double rate);
    void drawNext(Fault& fault);
    void flip(link::Bytes& bytes);
    void drop(link::Bytes& bytes);

    std::mt19937_64 random_;
    Fault dropping_, flipping_;
};

}  // namespace noctule::virtual_suit
