// SPDX-License-Identifier: Apache-2.0
// Which segment a sensor sits on, by its name.
#pragma once

#include <optional>
#include <string>

#include "core/import/recording.h"

namespace noctule {

/// The canonical joint that a sensor's name means: "calcn_r_imu" -> RightFoot, "lower_back" -> Spine.
std::optional<std::string> segmentByName(const std::string& sensor);

/// For every sensor without a segment; a segment that two sensors claim goes to neither, with a warning.
void guessSegments(ImportedRecording& recording);

}  // namespace noctule
