// SPDX-License-Identifier: Apache-2.0
// The take that the virtual suit records: the suit that Noctule comes with, worn on the motion that ships
// with the studio, in the scenario `nominal` and down to the sampled sound. What `--batch simulate` makes of
// that motion.
#pragma once

#include <string>

#include "core/figure/understood_motion.h"
#include "core/job/job.h"
#include "core/job/result.h"

namespace noctule::studio {

/// The motion inside the program.
constexpr const char* kSampleMotion = ":/noctule/motions/sample.bvh";

/// Writes a new file; `created_utc` and `software` go into its header.
Status makeSampleTake(const std::string& path, const std::string& created_utc, const std::string& software,
                      const JobContext& job);

/// The same motion by two performers, "A" and "B", who face each other, each with a suit of its own carrier.
/// Both hear each other.
Status makePairTake(const std::string& path, const std::string& created_utc, const std::string& software,
                    const JobContext& job);

/// A suit on the person of a motion, straight to inertial and range rows. `scenario`: as `--scenario` has it.
struct MotionTake {
    const figure::UnderstoodMotion& motion;
    std::string scenario, path, created_utc, software;
};
Status makeMotionTake(const MotionTake& wanted, const JobContext& job);

}  // namespace noctule::studio
