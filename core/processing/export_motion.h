// SPDX-License-Identifier: Apache-2.0
// The motion that a request takes out of its take: cut, resampled and its root held as wanted.
#pragma once

#include <string>
#include <vector>

#include "core/processing/export_take.h"

namespace noctule {

struct ExportedMotion {
    std::string run;
    MotionClip clip;
    std::vector<std::vector<float>> confidence;  ///< per frame and joint; empty: not known
    MotionClip filmed;                           ///< at the film's rate; empty without pictures
};

/// kUnusable without a pose in the wanted part; errors of opening the take are passed on.
Result<ExportedMotion> exportedMotion(const ExportRequest& request);

}  // namespace noctule
