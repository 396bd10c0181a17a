// SPDX-License-Identifier: Apache-2.0
// How well a run knows where its subjects are to each other: the vectors between their pelvises and hands,
// and their relative heading, against the references in the take.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/job/job.h"
#include "core/processing/evaluate_take.h"
#include "core/recording/take.h"

namespace noctule {

/// Joints whose vectors are compared: of the first body, of the other one.
inline constexpr std::pair<const char*, const char*> kComparedEnds[] = {{"Hips", "Hips"},
                                                                        {"LeftHand", "LeftHand"},
                                                                        {"LeftHand", "RightHand"},
                                                                        {"RightHand", "LeftHand"},
                                                                        {"RightHand", "RightHand"}};

struct BetweenEvaluation {
    std::string a, b;                   ///< subjects
    std::string from, to;               ///< joints of a and b
    double rms_mm = 0;                  ///< of the vector's error; the common heading's error is taken off
    std::optional<double> rms_near_mm;  ///< while the true distance is below 0.3 m
    double rms_world_mm = 0;            ///< with the common heading's error
    double heading_deg = 0;             ///< rms of the relative heading's error
    int64_t frames = 0;
    /// Where subjects were estimated together: what the run says of the vector in the frame of a's root, rms
    /// over all three axes, and its mean squared error in units of that (1 is honest).
    std::optional<double> sigma_mm{}, nees{};
    /// False: nothing measured where the two stand to each other. There is one entry of the pair, without
    /// joints and numbers.
    bool observed = true;
};

/// Every pair of `subjects` that has a reference each; empty where one lacks it. Of the request counts which
/// take and which run.
Result<std::vector<BetweenEvaluation>> evaluateBetween(const EvaluateRequest& request,
                                                       const std::vector<TakeSubject>& subjects,
                                                       const JobContext& job);

}  // namespace noctule
