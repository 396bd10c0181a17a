// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/censoring.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/estimation/covariance.h"

namespace noctule {
namespace {

struct Moments {
    double mean = 0, variance = 0;
};

/// Of a standard normal state whose reading, with noise of variance R, is known to be `end` or more (`beyond`
/// 1) or less (-1), by an exponentially distributed excess: summed over the state's values, each as likely as
/// it and such a reading are.
Moments momentsBySum(double end, int beyond, double R, double mean_excess) {
    double weights = 0, sum = 0, squares = 0;
    for (double x = -12; x <= 12; x += 1e-4) {
        // Integral over the readings beyond: normal about x with variance R, times exp(-excess /
        // mean_excess).
        const double short_of = beyond * (end - x);
        const double reading_beyond = std::exp((short_of + 0.5 * R / mean_excess) / mean_excess) * 0.5 *
                                      std::erfc((short_of + R / mean_excess) / std::sqrt(2 * R));
        const double weight = std::exp(-0.5 * x * x) * reading_beyond;
        weights += weight;
        sum += weight * x;
        squares += weight * x * x;
    }
    const double mean = sum / weights;
    return {mean, squares / weights - mean * mean};
}

TriadReading readingOf(int beyond) {
    TriadReading reading;
    AxisReading axis;
    axis.beyond = beyond;
    reading.add(axis);
    return reading;
}

/// The same by an update with the censored reading.
Moments momentsByUpdate(double end, int beyond, double R, double mean_excess = kAnyExcess) {
    Covariance P(Eigen::VectorXd::Ones(1));
    ObservationBlock block{
        {0}, Eigen::MatrixXd::Ones(1, 1), Eigen::VectorXd::Constant(1, end), Eigen::VectorXd::Constant(1, R)};
    censor(block, readingOf(beyond), P.innovationVariance(block), mean_excess);
    EXPECT_NEAR(block.residual[0], end + block.origin.target[0], 1e-12);
    const double mean = P.update({block})[0];
    return {mean, P.dense()(0, 0)};
}

class Censoring : public ::testing::TestWithParam<double> {};

TEST_P(Censoring, GivesTheMomentsOfTheGaussianCutOff) {
    for (const int beyond : {1, -1})
        for (const double R : {0.01, 0.5})
            for (const double mean_excess : {0.5, 3.0, kAnyExcess}) {
                const double end = beyond * GetParam();
                const Moments expected = momentsBySum(end, beyond, R, mean_excess),
                              found = momentsByUpdate(end, beyond, R, mean_excess);
                EXPECT_NEAR(found.mean, expected.mean, 1e-5)
                    << "end " << end << ", noise " << R << ", excess " << mean_excess;
                EXPECT_NEAR(found.variance, expected.variance, 1e-5)
                    << "end " << end << ", noise " << R << ", excess " << mean_excess;
            }
}

// From expected far beyond the end, where nothing is learnt, to far within the range.
INSTANTIATE_TEST_SUITE_P(Ends, Censoring, ::testing::Values(-5.0, -1.0, 0.0, 0.5, 2.0, 5.0));

TEST(CensoringLimits, FarWithinTheRangeTheEndIsBelievedAndFarBeyondNothing) {
    EXPECT_NEAR(momentsByUpdate(300, 1, 1e-6).mean, 300, 0.01);
    const Moments beyond = momentsByUpdate(-300, 1, 1e-6);
    EXPECT_NEAR(beyond.mean, 0, 1e-5);
    EXPECT_NEAR(beyond.variance, 1, 1e-6);
}

TEST(CensoringLimits, FarWithinTheRangeVariancesStayThoseOfAnExponentialTail) {
    for (const double end : {19.0, 21.0, 60.0}) {
        const double variance = momentsByUpdate(end, 1, 1e-6).variance;
        EXPECT_NEAR(variance * end * end, 1, 0.02) << "end " << end;
    }
}

TEST(CensoringLimits, ARateThatNobodySeesExceedsTheRangeByTheMean) {
    Covariance P(Eigen::VectorXd::Constant(1, 1e6));
    ObservationBlock block{{0},
                           Eigen::MatrixXd::Ones(1, 1),
                           Eigen::VectorXd::Constant(1, 20),
                           Eigen::VectorXd::Constant(1, 1e-4)};
    censor(block, readingOf(1), P.innovationVariance(block), 3);
    EXPECT_NEAR(P.update({block})[0], 23, 0.1);
    EXPECT_NEAR(P.dense()(0, 0), 9, 0.3);
}

TEST(CensoringLimits, OtherAxesAreAsTheyWere) {
    TriadReading reading = readingOf(1);
    reading.add(AxisReading{});
    ObservationBlock block{
        {0, 1}, Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(0.3, 0.4), Eigen::Vector2d(0.1, 0.2)};
    censor(block, reading, Eigen::Vector2d(1.1, 1.2), kAnyExcess);
    EXPECT_EQ(block.residual[1], 0.4);
    EXPECT_EQ(block.variance[1], 0.2);
    EXPECT_EQ(block.origin.target[1], 0);
}

TEST(CensoringLimits, LeftOutIsOnlyWhatIsExpectedBeyond) {
    const TriadReading reading = readingOf(-1);
    ObservationBlock within{{0},
                            Eigen::MatrixXd::Ones(1, 1),
                            Eigen::VectorXd::Constant(1, -0.3),
                            Eigen::VectorXd::Constant(1, 0.1)};
    ObservationBlock beyond = within;
    beyond.residual = -within.residual;
    leaveOutBeyond(within, reading);
    EXPECT_EQ(within.residual[0], -0.3);
    EXPECT_EQ(within.variance[0], 0.1);
    leaveOutBeyond(beyond, reading);
    EXPECT_EQ(beyond.residual[0], 0);
    EXPECT_GT(beyond.variance[0], 1e6);
}

}  // namespace
}  // namespace noctule
