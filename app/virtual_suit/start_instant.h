// SPDX-License-Identifier: Apache-2.0
// The instant that --start-at names: what several boxes play begins there for all of them.
#pragma once

#include <cstdint>
#include <string>

#include "core/job/result.h"

namespace noctule::virtual_suit {

inline constexpr double kLongestWait_s = 86400;  ///< between the instant and now

/// `text`: UTC in ISO 8601, or "now". On the clock of nowNs(). Fails with kUsage.
Result<int64_t> startInstant(const std::string& text);

}  // namespace noctule::virtual_suit
