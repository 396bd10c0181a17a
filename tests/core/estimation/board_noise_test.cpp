// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/board_noise.h"

#include <gtest/gtest.h>

#include "core/inertial/reading.h"
#include "tests/core/estimation/small_body.h"

namespace noctule {
namespace {

using Eigen::VectorXd;
using testing::Gaussian;

/// Feeds innovations of which 1 is expected (variance) and that have `excess` on top, correlated from one to
/// the next by `correlation`.
ExcessNoise learnt(double excess, double correlation, int count = 4000, double outlier_share = 0) {
    ExcessNoise noise({.memory = 500});
    Gaussian random(5);
    VectorXd before;
    double coloured = random(std::sqrt(excess));
    for (int i = 0; i < count; ++i) {
        coloured = correlation * coloured + random(std::sqrt(excess * (1 - correlation * correlation)));
        const bool outlier = outlier_share > 0 && i % static_cast<int>(1 / outlier_share) == 0;
        noise.learn(VectorXd::Constant(1, outlier ? 200 : random(1) + coloured), VectorXd::Ones(1), before);
    }
    return noise;
}

TEST(ExcessNoiseTest, HonestNoiseHasNone) {
    EXPECT_LT(learnt(0, 0).variance(), 0.15);
}

TEST(ExcessNoiseTest, ExcessIsFoundAndItsColourCounts) {
    EXPECT_NEAR(learnt(4, 0).variance(), 4, 0.8);
    EXPECT_NEAR(learnt(4, 0).whitenedVariance(), 4, 1.2);
    const ExcessNoise slow = learnt(4, 0.9, 40000);
    EXPECT_NEAR(slow.variance(), 4, 1.5);
    // Its own part of the innovations, 4 of 5, is correlated by 0.9: together by 0.72.
    EXPECT_NEAR(slow.whitenedVariance() / slow.variance(), 1.72 / 0.28, 3);
}

TEST(ExcessNoiseTest, OutliersAreNoNoise) {
    EXPECT_LT(learnt(0, 0, 4000, 0.05).variance(), 1);
}

class BoardNoiseTest : public ::testing::Test {
protected:
    ObservationBlock innovation(const Vector3d& residual) const {
        return {{0}, Eigen::MatrixXd::Zero(3, 1), residual, VectorXd::Constant(3, 0.01)};
    }
    InertialMeasurement reading(const Vector3d& force_m_per_s2) const {
        InertialMeasurement measurement;
        for (int i = 0; i < 3; ++i)
            measurement.accel.add({Vector3d::Unit(i), force_m_per_s2[i], 0.1});
        return measurement;
    }

    Covariance P{VectorXd::Ones(1)};
    BoardNoise noise{{}, 1};
};

TEST_F(BoardNoiseTest, OnlyFleshIsShaken) {
    ObservationBlock rigid = innovation({0.1, 0, 0}), soft = rigid, after = rigid;
    noise.adaptAccel(rigid, reading({0, 20, 0}).accel, 20, 0, P);
    EXPECT_NEAR(rigid.variance[0], 0.01, 0.005);
    noise.adaptAccel(soft, reading({0, 20, 0}).accel, 20, 1, P);
    EXPECT_GT(soft.variance[0], 20 * 20);
    // Its wobble lasts longer than what drove it.
    noise.adaptAccel(after, reading({0, 9.8, 0}).accel, 0, 1, P);
    EXPECT_GT(after.variance[0], 15 * 15);
}

TEST_F(BoardNoiseTest, APairThatHearsEchoesSpoilsNoOther) {
    BoardNoise of_two{{}, 2};
    const auto distance = [](double off_m) {
        return ObservationBlock{
            {0}, Eigen::MatrixXd::Zero(1, 1), VectorXd::Constant(1, off_m), VectorXd::Constant(1, 1e-6)};
    };
    for (int i = 0; i < 200; ++i) {
        of_two.learnDistance(distance(i % 2 ? 0.001 : -0.001), 0, P);
        of_two.learnDistance(distance(0.03), 1, P);
    }
    EXPECT_LT(of_two.distanceVariance(0, 0), 1e-6);
    EXPECT_GT(of_two.distanceVariance(1, 0), 1e-4);
}

TEST_F(BoardNoiseTest, AClippedReadingTeachesNothing) {
    // Half a metre per second squared too much, all the time: excess noise, which one clipped reading must
    // not hide.
    const auto adapted = [this](bool clipped) {
        ObservationBlock block = innovation({0.5, 0.5, 0.5});
        InertialMeasurement measurement = reading({0, 9.8, 0});
        measurement.accel.axes[0].beyond = clipped ? 1 : 0;
        if (clipped)
            block.variance[0] = 1e8;
        noise.adaptAccel(block, measurement.accel, 0, 0, P);
        return block.variance[1];
    };
    for (int i = 0; i < 1000; ++i)
        adapted(false);
    const double before = adapted(false);
    EXPECT_GT(before, 1);
    adapted(true);
    EXPECT_NEAR(adapted(false), before, 0.1 * before);
}

}  // namespace
}  // namespace noctule
