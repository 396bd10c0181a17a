// SPDX-License-Identifier: Apache-2.0
#include "devices/device/take_hello.h"

#include <cmath>

namespace noctule {

link::Hello helloOf(const Take& take, const Suit& suit, const std::string& otherwise) {
    const TakeHeader& header = take.header();
    const std::string serial = take.boxSerial();
    link::Hello hello;
    hello.serial = serial.empty() ? otherwise : serial;
    hello.sample_rate_hz = static_cast<int>(header.sample_rate_hz);
    hello.pulse_interval_samples = static_cast<int>(header.pulse_interval_samples);
    hello.pulse_cycles = static_cast<int>(std::lround(header.pulse_cycles));
    hello.drive_hz = header.drive_hz;
    hello.suit = suit;
    return hello;
}

}  // namespace noctule
