// SPDX-License-Identifier: Apache-2.0
// What another system recorded of the same performance goes into the take: as the reference that evaluate
// compares with, or as the root that "root given" reads.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/formats/positions_csv.h"
#include "core/job/job.h"
#include "core/processing/reference_motion.h"

namespace noctule {

enum class AttachAs { kReference, kExternalRoot };

struct AttachRequest {
    std::string take_path;
    // One of the two. Positions do not tell how limbs are twisted: they serve as an external root only, and
    // need Hips with LeftUpLeg and RightUpLeg, or with more of the joints that sit on the hips.
    std::optional<OutsideMotion> motion;
    std::optional<PositionTable> positions;
    std::string source_name;  ///< the file, for messages
    AttachAs as = AttachAs::kReference;
    std::optional<double> shift_s;  ///< time of the file's start on the take's clock; none: found by motion
    bool overwrite = false;         ///< replace what is attached already
};

struct AttachSummary {
    int64_t rows = 0, rows_outside = 0;  ///< attached, and left out since they lie outside the take
    double shift_s = 0;
    std::optional<double> correlation;    ///< where the shift was found
    std::optional<double> shift_sigma_s;  ///< standard deviation of a shift that was found
    std::string aligned_with;             ///< the run it was found with
    std::vector<std::pair<std::string, std::string>> matched;  ///< joint of the take, joint of the motion
    std::vector<std::string> warnings;                         ///< whole sentences
};

/// Rows outside the take's time are left out, counted and said. One transaction. kUnusable when the shift
/// cannot be told, when nothing fits, or when the times cannot be seconds.
Result<AttachSummary> attachReference(const AttachRequest& request, const JobContext& job);

}  // namespace noctule
