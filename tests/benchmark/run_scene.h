// SPDX-License-Identifier: Apache-2.0
// The estimator on a scene's measurements, without files.
#pragma once

#include "core/estimation/manifold_filter.h"
#include "tests/benchmark/bound_scene.h"

namespace noctule {

/// Poses of the filter or, `smoothed`, of the whole interval.
std::vector<TimedPose> estimatedPoses(const Scene& scene, const std::vector<Instant>& instants,
                                      const ManifoldParameters& parameters, bool smoothed);

/// Over all joints that move and all poses after `from_s` and the rest, to the true motion.
double meanError_deg(const Scene& scene, std::vector<TimedPose> poses, double from_s = 0);

}  // namespace noctule
