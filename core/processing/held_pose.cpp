// SPDX-License-Identifier: Apache-2.0
#include "core/processing/held_pose.h"

#include <cstdio>

namespace noctule {
namespace {

/// Of an instant that is told of a pose that is held for so long: a tenth of a second, where that tells it.
std::string instantText(int64_t time_ns, int64_t held_ns) {
    constexpr int64_t kShort_ns = 200'000'000;
    char text[32];
    std::snprintf(text, sizeof text, held_ns < kShort_ns ? "%.3f" : "%.1f",
                  static_cast<double>(time_ns) * 1e-9);
    return text;
}

}  // namespace

std::vector<std::string> heldInWords(const std::string& who, const PoseSpan& seen, int64_t begin_ns,
                                     int64_t end_ns, int64_t frame_ns) {
    std::vector<std::string> said;
    const std::string until = instantText(seen.first_ns, seen.first_ns - begin_ns);
    const std::string from = instantText(seen.last_ns, end_ns - seen.last_ns);
    if (seen.first_ns - begin_ns >= frame_ns)
        said.push_back(who + " holds its first pose until " + until + " s.");
    if (end_ns - seen.last_ns >= frame_ns)
        said.push_back(who + " holds its last pose from " + from + " s on.");
    return said;
}

}  // namespace noctule
