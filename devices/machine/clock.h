// SPDX-License-Identifier: Apache-2.0
// The clocks of the machine: one that never goes back, for what lasts and for what comes in time, and the one
// on the wall, for what is written into files.
#pragma once

#include <cstdint>
#include <string>

namespace noctule {

/// Nanoseconds of std::chrono::steady_clock.
int64_t steadyNow_ns();

/// Now, ISO 8601 with Z, to the second.
std::string utcNow();

}  // namespace noctule
