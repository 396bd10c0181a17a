// SPDX-License-Identifier: Apache-2.0
// The estimators of single sensors' orientation by name. A new one is one entry here.
#pragma once

#include <optional>
#include <string>

#include "core/orientation/orientation_filter.h"

namespace noctule {

struct OrientationChoice {
    bool smooth = false;               ///< use the whole recording; estimators that cannot refuse it
    bool level_reading = false;        ///< miller: level the sensed field
    std::optional<double> gain_per_s;  ///< miller, bachmann: correction gain, 1/s
};

struct OrientationEstimator {
    const char* name;
    const char* summary;
    bool can_smooth;
    Result<OrientationRun> (*run)(const ImuSamples&, const OrientationChoice&, const JobContext&);
};

/// noctule first: the default.
const std::vector<OrientationEstimator>& orientationEstimators();
const OrientationEstimator* findOrientationEstimator(const std::string& name);  ///< null: no such

}  // namespace noctule
