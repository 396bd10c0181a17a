// SPDX-License-Identifier: Apache-2.0
#include "core/orientation/orientation_smoother.h"

#include <gtest/gtest.h>

#include "core/math/rotation.h"

namespace noctule::orientation {
namespace {

/// A gyroscope that reads zero, while the second step ends a tenth of a radian further. One of its two rows
/// stands after a pause of 0.99 s.
TEST(OrientationSmoother, AMismatchOverAPauseIsSharedByTime) {
    constexpr double kMismatch_rad = 0.1, kStep_s = 0.01, kPause_s = 0.99;
    for (const size_t paused_row : {2u, 3u}) {
        ImuSamples samples;
        samples.rate_hz = 1 / kStep_s;
        samples.gyro_rad_per_s.assign(4, Vector3d::Zero());
        samples.step_s.assign(4, kStep_s);
        samples.step_s[paused_row] += kPause_s;
        const OrientationSettings settings;
        Smoother smoother(samples, settings, 2);
        FilteredStep step;
        step.P = startCovariance(settings);
        step.error = ErrorVector::Zero();
        smoother.push(step);
        step.nominal.q_world_sensor = axisAngle(Vector3d::UnitY(), kMismatch_rad);
        smoother.push(step);
        OrientationRun run;
        run.q_world_sensor.resize(4);
        run.heading_sigma_rad.resize(4);
        smoother.run(run);
        const double share = samples.step_s[2] / (samples.step_s[2] + samples.step_s[3]);
        EXPECT_NEAR(logQuaternion(run.q_world_sensor[1]).y(), 0, 1e-12);
        EXPECT_NEAR(logQuaternion(run.q_world_sensor[2]).y(), share * kMismatch_rad, 1e-12) << paused_row;
        EXPECT_NEAR(logQuaternion(run.q_world_sensor[3]).y(), kMismatch_rad, 1e-12);
    }
}

}  // namespace
}  // namespace noctule::orientation
