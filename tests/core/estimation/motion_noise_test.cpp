// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/motion_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/core/estimation/small_body.h"

namespace noctule {
namespace {

/// A scalar acceleration whose white jerk has `true_rad_per_s2` behind it, observed with noise by a Kalman
/// filter whose process noise is learnt. Returns what was learnt, a standard deviation.
double learntBy(const KinematicTree& tree, double true_rad_per_s2, double flesh_share) {
    constexpr double kInterval_s = 1.0 / 140, kDecay = 0.97, kNoise = 2;
    const int n = tree.freedoms();
    const int first = tree.link(1).first;
    MotionNoise noise(tree, Eigen::VectorXd::Constant(n, 3600), std::vector<bool>(tree.links().size(), true),
                      {});
    std::mt19937_64 random(5);
    std::normal_distribution<double> gaussian;
    double truth = 0, estimate = 0, P = 1, mean = 0;
    constexpr int kFrames = 4000;
    for (int k = 0; k < kFrames; ++k) {
        const double share = 1 - kDecay * kDecay;
        truth = kDecay * truth + std::sqrt(share) * true_rad_per_s2 * gaussian(random);
        estimate *= kDecay;
        P = kDecay * kDecay * P + share * noise.variance()[first];
        const double gain = P / (P + kNoise * kNoise);
        const double correction = gain * (truth + kNoise * gaussian(random) - estimate);
        estimate += correction;
        Eigen::VectorXd corrections = Eigen::VectorXd::Zero(n), shrinkage = corrections;
        corrections[first] = correction;
        shrinkage[first] = gain * P;
        P -= gain * P;
        noise.learn(corrections, shrinkage, kInterval_s, flesh_share);
        if (k >= kFrames / 2)
            mean += std::log(noise.variance()[first]) / (kFrames / 2);
    }
    return std::exp(0.5 * mean);
}

TEST(MotionNoise, FindsHowLivelyAJointMoves) {
    const KinematicTree tree(testing::smallSkeleton(), BallCoordinates::kManifold);
    for (const double truth : {3.0, 20.0, 120.0})
        EXPECT_NEAR(learntBy(tree, truth, 0) / truth, 1, 0.25) << truth;
}

TEST(MotionNoise, BelievesNoQuietOnFlesh) {
    const KinematicTree tree(testing::smallSkeleton(), BallCoordinates::kManifold);
    EXPECT_NEAR(learntBy(tree, 3, 1), MotionNoiseParameters{}.flesh_rad_per_s2, 40);
}

TEST(MotionNoise, WhatClippingAllowedPasses) {
    const KinematicTree tree(testing::smallSkeleton(), BallCoordinates::kManifold);
    const Eigen::VectorXd first = Eigen::VectorXd::Constant(tree.freedoms(), 25);
    MotionNoise noise(tree, first, std::vector<bool>(tree.links().size(), true), {});
    noise.allowMost(tree.link(1));
    EXPECT_EQ(noise.variance()[tree.link(1).first], std::pow(MotionNoiseParameters{}.most_rad_per_s2, 2));
    noise.restart();
    EXPECT_EQ(noise.variance(), first);
}

}  // namespace
}  // namespace noctule
