// SPDX-License-Identifier: Apache-2.0
// The box's clock, which never goes back.
#pragma once

#include <chrono>
#include <cstdint>

namespace noctule::virtual_suit {

inline int64_t nowNs() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

}  // namespace noctule::virtual_suit
