// SPDX-License-Identifier: Apache-2.0
// The registry of estimators. A new one is a file with its parameter table and one line in estimators.cpp;
// the command line, its help and the settings of runs follow.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/acoustics/pulse_detector.h"
#include "core/estimation/estimator.h"
#include "core/estimation/parameter.h"
#include "core/estimation/suit_model.h"
#include "core/live/motion_tracker.h"

namespace noctule {

struct ManifoldParameters;
/// Of the filter of the estimator "manifold", as these settings make it.
ManifoldParameters filterParameters(const TrackerSettings& settings);

/// What an estimator is made from.
struct EstimatorWorld {
    const Suit& suit;
    const Calibration& calibration;
    const Actor& actor;
    const SuitModel& mounted;  ///< on the tree of BallCoordinates::kManifold
    const TrackerSettings& settings;
};

struct EstimatorEntry {
    std::string name, summary;
    std::vector<ParameterDescription> parameters;
    bool smooths = false, finds_contacts = false;
    Detector detector = Detector::kMatched;  ///< unless another one is asked for
    bool whole_take = false;  ///< needs the whole take before the first pose; refuses to be made live
    Result<std::unique_ptr<Estimator>> (*make)(const EstimatorWorld& world) = nullptr;
    bool keeps_zeros = false;  ///< of gyroscopes, those of the rest pose for all of the take
};

const std::vector<EstimatorEntry>& estimators();
/// Null: there is none of that name.
const EstimatorEntry* findEstimator(const std::string& name);
/// kUsage proposes the nearest name.
Result<const EstimatorEntry*> estimatorNamed(const std::string& name);

}  // namespace noctule
