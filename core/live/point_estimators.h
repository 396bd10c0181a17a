// SPDX-License-Identifier: Apache-2.0
// The estimators of Welch 2018 in the registry: "comocap", "ms-comocap" and "environment". They give places
// of housings as free points, not joint angles, and need a whole take (core/processing/track_points.h).
#pragma once

#include <string>
#include <vector>

#include "core/cooperative/point_filter.h"
#include "core/estimation/parameter.h"

namespace noctule {

struct PointSetup {
    double q_m2_per_s3 = 0.3;
    double share = 2.0 / 3;  ///< "ms-comocap" alone
    int rule = 1;            ///< of the share: 0 Welch's ratio, 1 greedy by trace, 2 greedy by determinant
    bool letter = false;     ///< cooperative::welchSettings()
    double start_m = 0.03, start_m_per_s = 0.1;
    double floor_m = 0.002;
    double gate_sigma = 5;
    double rows_per_s = 60;
};

/// An estimator of this name gives points.
bool givesPoints(const std::string& estimator);

/// Of the estimators that give points; those of the share belong to "ms-comocap" alone.
std::vector<ParameterDescription> pointParameters(const std::string& estimator);

/// Values that checkParameters() has passed.
PointSetup pointSetup(const ParameterValues& values);

cooperative::PointFilterSettings filterSettings(const std::string& estimator, const PointSetup& setup);

}  // namespace noctule
