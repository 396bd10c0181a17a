// SPDX-License-Identifier: Apache-2.0
// What a calibration in the rest pose tells its operator: who moved, what is missing, what sits in the wrong
// place, how far the accelerometers can be trusted.
#pragma once

#include <vector>

#include "core/calibration/rest_pose/rest_swap_search.h"

namespace noctule {

/// There is nothing to calibrate from: nobody stands still, or no board is heard.
void addWhyNotStill(const Observations& take, const StillStretch& still, std::vector<Finding>& into);

/// Movements beside the stillness that was used, sway, missing and clipped boards.
void addStandingFindings(const Observations& take, const StillStretch& still, std::vector<Finding>& into);

/// Swapped, askew and shifted boards and sources, of a report that is filled already.
void addPlaceFindings(const Observations& take, const RestPoseSettings& settings,
                      const RestExplanation& explained, RestPoseReport& report);

/// Accelerometers without calibration, or far from g.
void addSensorFindings(const Observations& take, const RestPoseSettings& settings,
                       const RestEvidenceMaker& maker, RestPoseReport& report);

}  // namespace noctule
