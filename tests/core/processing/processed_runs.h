// SPDX-License-Identifier: Apache-2.0
// A take processed as tests do it, and its run against the take's reference.
#pragma once

#include "core/motion/comparison.h"
#include "core/processing/pose_runs.h"
#include "core/processing/process_take.h"
#include "tests/core/recording/collect.h"
#include "tests/support/simulated_take.h"

namespace noctule::test {

inline ProcessRequest requestFor(const std::string& path) {
    ProcessRequest request;
    request.take_path = path;
    request.tracker.root_given = true;
    request.software = "test";
    request.created_utc = "2026-01-01T00:00:00Z";
    return request;
}

/// Against the take's reference, after its rest pose.
inline Comparison compareAfterRest(const Take& take, const TimedMotion& motion) {
    const auto rest = take.restInterval().value();
    ComparisonOptions options;
    if (rest)
        options.from_ns = rest->last * 1'000'000'000 / take.header().sample_rate_hz;
    return compareMotions(motion, take.reference().value(), options).value();
}

inline Comparison compareRun(const std::string& path, int64_t pose_run) {
    const Take take = Take::open(path).value();
    return compareAfterRest(take, take.poses(pose_run).value());
}

}  // namespace noctule::test
