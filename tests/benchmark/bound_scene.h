// SPDX-License-Identifier: Apache-2.0
// A simulated take as the bound needs it: the true motion on the estimator's tree, what was measured and
// when, and how lively the motion is.
#pragma once

#include <string>

#include "core/estimation/observation.h"
#include "core/inertial/reading.h"
#include "core/simulation/simulate.h"

namespace noctule {

constexpr int kStepsPerFrame = 3;
constexpr double kStep_s = 1.0 / (kInertialFramesPerSecond * kStepsPerFrame);

/// What is observed within a step and the true state at its end.
struct Instant {
    BodyState truth;
    std::vector<InertialMeasurement> inertial;
    std::vector<DistanceMeasurement> distances;
    std::vector<RootMeasurement> roots;
};

/// A take and the truth about it.
struct Scene {
    simulation::Stage stage;
    KinematicTree tree;
    SuitModel model;
    std::vector<Instant> instants;
    Eigen::VectorXd variance, decay;  ///< of the accelerations' process, per coordinate
    double sigma_distance_m = 0;

    double rest_s() const { return stage.body->performance().rest_seconds(); }
};

/// Of a source's constant error, and of the relative error of the speed of sound.
double offsetSigma_m(const simulation::Scenario& scenario);
double soundScaleSigma(const simulation::Scenario& scenario);

enum class Boards { kNominal, kFlawless };

/// Simulates `seconds` of the motion (BVH) in the nominal scenario at readings level into a take there.
/// kFlawless: inertial readings without noise, bias, errors of matrices or coding.
Scene sceneOf(const std::string& motion, double seconds, uint64_t seed, const std::string& take_path,
              Boards boards = Boards::kNominal);

/// Instants as the bound assumes them, of a scene with flawless boards: with white noise of each
/// measurement's sigma, and constant and walking errors drawn as the scenario `scene` has them.
std::vector<Instant> drawnInstants(const Scene& scene, const Scene& flawless, uint64_t seed);

}  // namespace noctule
