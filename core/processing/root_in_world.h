// SPDX-License-Identifier: Apache-2.0
// Where anchors hold the world a root is compared as it stands: nothing is made equal at the first frame,
// whose own error would otherwise count in all others. (A first heading 1 degree off is 17 mm after a metre's
// walk.)
#pragma once

#include <optional>
#include <string>

#include "core/job/job.h"
#include "core/recording/take.h"

namespace noctule {

struct RootInWorld {
    double position_m = 0, yaw_deg = 0;  ///< rms after the rest pose
};

/// Nothing of a run that used no anchors, which stands where it chose to, or without a reference of the
/// subject. The run is named as in choosePoseRun().
Result<std::optional<RootInWorld>> rootInWorld(const std::string& take_path, const std::string& run,
                                               const TakeSubject& subject, const JobContext& job);

}  // namespace noctule
