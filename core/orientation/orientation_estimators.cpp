// SPDX-License-Identifier: Apache-2.0
#include "core/orientation/orientation_estimators.h"

#include "core/orientation/complementary_filters.h"

namespace noctule {

namespace {

Result<OrientationRun> runOurs(const ImuSamples& samples, const OrientationChoice& choice,
                               const JobContext& job) {
    OrientationSettings settings;
    settings.smooth = choice.smooth;
    return estimateOrientation(samples, settings, job);
}

Result<OrientationRun> runMiller(const ImuSamples& samples, const OrientationChoice& choice,
                                 const JobContext&) {
    MillerSettings settings;
    settings.level_reading = choice.level_reading;
    settings.alpha_per_s = choice.gain_per_s.value_or(choice.level_reading ? 0.1 : settings.alpha_per_s);
    OrientationRun run;
    run.q_world_sensor = millerOrientation(samples, settings);
    return run;
}

Result<OrientationRun> runBachmann(const ImuSamples& samples, const OrientationChoice& choice,
                                   const JobContext&) {
    BachmannSettings settings;
    settings.gain_per_s = choice.gain_per_s.value_or(settings.gain_per_s);
    OrientationRun run;
    run.q_world_sensor = bachmannOrientation(samples, settings);
    return run;
}

}  // namespace

const std::vector<OrientationEstimator>& orientationEstimators() {
    static const std::vector<OrientationEstimator> all = {
        {"noctule", "error-state Kalman filter with biases, scale and the magnetometer's lag", true, runOurs},
        {"miller", "complementary filter of Miller 2004, equations 1 to 14", false, runMiller},
        {"bachmann", "complementary filter with a Gauss-Newton correction (Miller 2004, equation 15)", false,
         runBachmann}};
    return all;
}

const OrientationEstimator* findOrientationEstimator(const std::string& name) {
    for (const OrientationEstimator& estimator : orientationEstimators())
        if (name == estimator.name)
            return &estimator;
    return nullptr;
}

}  // namespace noctule
