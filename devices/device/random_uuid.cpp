// SPDX-License-Identifier: Apache-2.0
#include "devices/device/random_uuid.h"

#include <cstdint>
#include <cstdio>
#include <random>

namespace noctule {

std::string randomUuid() {
    std::random_device device;
    const auto bits = [&device](uint32_t mask) { return device() & mask; };
    char text[40];
    std::snprintf(text, sizeof text, "%08x-%04x-4%03x-%04x-%04x%08x", bits(~0U), bits(0xffff), bits(0xfff),
                  0x8000 | bits(0x3fff), bits(0xffff), bits(~0U));
    return text;
}

}  // namespace noctule
