// SPDX-License-Identifier: Apache-2.0
// Files of several people begin and end at the same instants. Whoever has no pose there yet, or none any
// more, stands still.
#pragma once

#include <string>
#include <vector>

#include "core/motion/timed_poses.h"

namespace noctule {

/// Whole sentences: "B holds its first pose until 4.0 s." Instants are those of the take's clock; the frames
/// of the file go from `begin_ns` to `end_ns`, `frame_ns` apart. Less than a frame is not told. Empty: it is
/// seen all the time.
std::vector<std::string> heldInWords(const std::string& who, const PoseSpan& seen, int64_t begin_ns,
                                     int64_t end_ns, int64_t frame_ns);

}  // namespace noctule
