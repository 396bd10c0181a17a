// SPDX-License-Identifier: Apache-2.0
#include "devices/machine/clock.h"

#include <chrono>
#include <ctime>

namespace noctule {

int64_t steadyNow_ns() {
    return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string utcNow() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
    return text;
}

}  // namespace noctule
