// SPDX-License-Identifier: Apache-2.0
// Is the filter's covariance honest? Motion and noise are drawn from the filter's own assumptions; then the
// normalised estimation error squared (NEES) of the pose, averaged over runs, must be near 1.
#include <gtest/gtest.h>

#include "tests/core/estimation/small_world.h"
#include "tests/support/nees.h"

namespace noctule {
namespace {

using Eigen::VectorXd;
using testing::World;

struct Outcome {
    double nees = 0;       ///< mean over the last two thirds, per freedom
    double mean_deg = 0;   ///< joint error at the end
    double sigma_deg = 0;  ///< as the filter believes
    int resets = 0;
    double heading_sigma_deg = 0;  ///< at the end, as the filter believes
};

/// `truth` draws the world, `parameters` is what the filter believes.
Outcome run(const ManifoldParameters& truth, const ManifoldParameters& parameters, unsigned seed,
            double seconds, double gyro_sigma = World::kGyroSigma) {
    World world(truth, seed);
    world.gyro_sigma = gyro_sigma;
    ManifoldFilter filter(testing::smallSkeleton(), world.suit, parameters);
    filter.start(testing::smallSkeleton().zeroPose(), {}, nullptr);
    Outcome outcome;
    int counted = 0;
    MotionState truth_now = world.motion,
                truth_before;  // readings tell of a frame when the next one has begun
    testing::play(world, filter, seconds, [&](int64_t frame, double t) {
        truth_before = std::exchange(truth_now, world.motion);
        if (frame % 7 != 0 || t < seconds / 3)
            return;
        filter.advanceTo(t + testing::kUntilSure_s);
        const VectorXd error = coordinateError(world.tree, filter.state().motion, truth_before);
        const Eigen::Index n = error.size(), judged = parameters.root_given ? n : n - 3;  // not the place
        const Eigen::MatrixXd P = filter.covariance().topLeftCorner(n, n);
        outcome.nees += test::nees(error.tail(judged), P.bottomRightCorner(judged, judged));
        outcome.mean_deg = degrees(error.tail(n - 6).cwiseAbs().mean());
        outcome.sigma_deg = degrees(P.diagonal().tail(n - 6).cwiseSqrt().mean());
        ++counted;
    });
    outcome.nees /= counted;
    const Vector3d up_root = filter.state().motion.q_parent_link[0].conjugate() * Vector3d::UnitY();
    outcome.heading_sigma_deg =
        degrees(std::sqrt(up_root.dot(filter.covariance().block<3, 3>(3, 3) * up_root)));
    outcome.resets = filter.resets();
    return outcome;
}

void expectConsistent(bool a, bool g, bool d, bool root_given, double lower, double upper) {
    const ManifoldParameters parameters = testing::fittingParameters({a, g, d}, root_given);
    double nees = 0;
    constexpr int kRuns = 12;
    for (unsigned seed = 1; seed <= kRuns; ++seed) {
        const Outcome outcome = run(parameters, parameters, seed, 4);
        nees += outcome.nees / kRuns;
        EXPECT_EQ(outcome.resets, 0);
        EXPECT_LT(outcome.mean_deg, 30) << "diverged, seed " << seed;
    }
    // The pose has 12 freedoms; its errors are correlated over about a second, so a run counts as a few
    // samples: the mean of 12 runs spreads by about 0.1.
    EXPECT_GT(nees, lower) << a << g << d;
    EXPECT_LT(nees, upper) << a << g << d;
}

TEST(Consistency, GyroscopesRootGiven) {
    expectConsistent(false, true, false, true, 0.7, 1.3);
}
TEST(Consistency, GyroscopesAndDistancesRootGiven) {
    expectConsistent(false, true, true, true, 0.7, 1.3);
}
TEST(Consistency, AccelerometersAndGyroscopesRootGiven) {
    expectConsistent(true, true, false, true, 0.7, 1.3);
}
TEST(Consistency, AllSensorsRootGiven) {
    expectConsistent(true, true, true, true, 0.7, 1.3);
}
TEST(Consistency, AllSensorsRootFree) {
    expectConsistent(true, true, true, false, 0.7, 1.3);
}

TEST(Consistency, NothingTellsTheHeading) {
    for (const bool distances : {false, true}) {
        const ManifoldParameters parameters = testing::fittingParameters({true, true, distances}, false);
        for (unsigned seed = 1; seed <= 3; ++seed)
            EXPECT_GE(run(parameters, parameters, seed, 8).heading_sigma_deg,
                      degrees(parameters.initial_pose_rad));
    }
}

/// Noise makes estimates of rates jump with every reading here, and whatever jumps seems to tell of
/// attitudes: without limbShift() the NEES is 2.
TEST(Consistency, GyroscopesTellNoAttitudeHoweverLong) {
    const ManifoldParameters truth = testing::fittingParameters({false, true, false}, true);
    ManifoldParameters parameters = truth;
    parameters.joint_accel_rad_per_s2 = 100;
    double nees = 0;
    constexpr int kRuns = 4;
    for (unsigned seed = 1; seed <= kRuns; ++seed) {
        const Outcome outcome = run(truth, parameters, seed, 20, 0.3);
        nees += outcome.nees / kRuns;
        EXPECT_EQ(outcome.resets, 0);
    }
    EXPECT_GT(nees, 0.7);
    EXPECT_LT(nees, 1.3);
}

TEST(Consistency, OverconfidenceIsNoticed) {
    // The check itself must be able to fail: biases ten times as large as the filter believes.
    ManifoldParameters truth;
    truth.sensors = {false, true, false};
    truth.root_given = true;
    truth.joint_accel_rad_per_s2 = 15;
    truth.joints_give = false;
    ManifoldParameters believed = truth;
    believed.gyro_bias_rad_per_s = truth.gyro_bias_rad_per_s / 10;
    believed.initial_pose_rad = truth.initial_pose_rad / 3;
    double nees = 0;
    for (unsigned seed = 1; seed <= 4; ++seed)
        nees += run(truth, believed, seed, 4).nees / 4;
    EXPECT_GT(nees, 2);
}

}  // namespace
}  // namespace noctule
