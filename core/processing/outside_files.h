// SPDX-License-Identifier: Apache-2.0
// Files of others that go into a take: motions to attach and calibrations to process with. And what a take
// says of the reference that it holds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/processing/attach_reference.h"
#include "core/suit/calibration.h"

namespace noctule {

/// Whether a name says that the file is a table of positions and not a motion.
bool isPositionsFile(const std::string& path);
/// Likewise, or markers: neither tells how limbs are twisted.
bool holdsPlacesOnly(const std::string& path);

/// A motion, a CSV table of positions or markers named as joints (C3D, TRC), ready to be attached to a take;
/// what was odd about the file goes into `warnings` as whole sentences.
Result<AttachRequest> readAttachment(const std::string& path, std::vector<std::string>& warnings,
                                     const JobContext& job);

/// A motion that shows no whole person (`why`), with its names and axes as they are: a part of a body
/// compares too. Returns `why` when hints were given, which could not be heeded.
Result<OutsideMotion> partialMotion(const BvhDocument& document, const figure::MotionHints& hints,
                                    const Error& why, std::vector<std::string>& warnings);

Result<Calibration> readCalibrationFile(const std::string& path);

struct ReferenceFacts {
    std::string kind;               ///< "simulated", "optical"
    std::string name;               ///< of the file it came from, without folder; empty: not known
    std::optional<double> shift_s;  ///< of the file's start on the take's clock
    int joints = 0;                 ///< of the take that move
    int matched = 0;                ///< of these, how many the reference moves too
};
/// kUnusable when the take holds no reference.
Result<ReferenceFacts> referenceFacts(const std::string& take_path);

}  // namespace noctule
