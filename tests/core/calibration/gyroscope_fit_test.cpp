// SPDX-License-Identifier: Apache-2.0
// Slope and zeros against a gyroscope that is known, without turntable and detection around it.
#include "core/calibration/gyroscope/gyroscope_fit.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "core/calibration/board_side.h"
#include "core/simulation/random.h"

namespace noctule {
namespace {

constexpr double kTurn_rad_per_s = 3.49, kStretch_s = 20, kStep_s = 25;

struct KnownGyroscope {
    Matrix3d matrix;
    Vector3d zero_counts{2100, 1990, 2030};

    KnownGyroscope() {
        matrix << 1.02, 0.01, -0.008, -0.012, 0.99, 0.004, 0.009, -0.006, 1.013;
        matrix *= 17.5 / 2048;
    }
    /// Up and down for each axis, a rest before each; half of it in another take.
    std::vector<KnownRate> stretches(double sigma_counts) const {
        std::vector<KnownRate> all;
        for (const BoardSide side : kBoardSides)
            for (const double rate : {0.0, kTurn_rad_per_s}) {
                KnownRate stretch;
                stretch.begin_s = kStep_s * static_cast<double>(all.size());
                stretch.end_s = stretch.begin_s + kStretch_s;
                stretch.take = all.size() < 6 ? 0 : 1;
                stretch.rate_rad_per_s = rate * side.up();
                stretch.mean.counts = zero_counts + matrix.inverse() * stretch.rate_rad_per_s;
                stretch.mean.sigma = Vector3d::Constant(sigma_counts);
                all.push_back(stretch);
            }
        return all;
    }
};

TEST(GyroscopeFit, IsExactWithoutNoise) {
    const KnownGyroscope truth;
    const std::vector<KnownRate> stretches = truth.stretches(0.01);
    const GyroscopeFit fit = fitGyroscope(stretches, 1e-4);
    EXPECT_LT((fit.axes.matrix - truth.matrix).norm() / truth.matrix(0, 0), 1e-9);
    EXPECT_LT((fit.axes.zero_counts - truth.zero_counts).norm(), 1e-8);
    ASSERT_EQ(fit.zeros_counts.size(), stretches.size());
    for (const Vector3d& zero_counts : fit.zeros_counts)
        EXPECT_LT((zero_counts - truth.zero_counts).norm(), 1e-8);
    EXPECT_LT(fit.chi_square, 1e-6);
    EXPECT_NEAR(fit.freedoms, 3 * (12 - 4 - 1), 0.01) << "a jump between takes is no wandering";
}

/// Zeros that wander, jump between the takes and are heard through noise: errors over sigmas are one.
TEST(GyroscopeFit, SigmasAreHonest) {
    constexpr int kRuns = 400;
    constexpr double kNoise_counts = 0.02, kWander_counts2_per_s = 1e-5;
    const KnownGyroscope truth;
    double slopes = 0, zeros = 0, chi_square = 0;
    for (int run = 0; run < kRuns; ++run) {
        simulation::Random random(static_cast<uint64_t>(run + 1), "gyroscope fit");
        std::vector<KnownRate> stretches = truth.stretches(kNoise_counts);
        Vector3d wandered_counts = Vector3d::Zero(), mean_counts = Vector3d::Zero();
        for (size_t k = 0; k < stretches.size(); ++k) {
            if (k > 0)
                wandered_counts += random.gaussianVector(stretches[k].take == stretches[k - 1].take
                                                             ? std::sqrt(kWander_counts2_per_s * kStep_s)
                                                             : 1);
            stretches[k].mean.counts += wandered_counts + random.gaussianVector(kNoise_counts);
            mean_counts += (truth.zero_counts + wandered_counts) / static_cast<double>(stretches.size());
        }
        const GyroscopeFit fit = fitGyroscope(stretches, kWander_counts2_per_s);
        slopes += (fit.axes.matrix - truth.matrix).cwiseQuotient(fit.sigma_matrix).squaredNorm() / 9;
        zeros +=
            (fit.axes.zero_counts - mean_counts).cwiseQuotient(*fit.axes.sigma_zero_counts).squaredNorm() / 3;
        chi_square += fit.chi_square / fit.freedoms;
    }
    // Rows of the matrix err apart from one another, its columns nearly so: 3 sigma of three a run.
    const double tolerance = 3 * std::sqrt(2.0 / (3 * kRuns));
    EXPECT_NEAR(slopes / kRuns, 1, tolerance);
    EXPECT_NEAR(zeros / kRuns, 1, tolerance);
    EXPECT_NEAR(chi_square / kRuns, 1, 3 * std::sqrt(2.0 / (24 * kRuns)));
}

/// As a wizard takes them: each turn is a take of its own, half a minute after the one before.
TEST(GyroscopeFit, TakesOfOneSittingCountAsOne) {
    std::vector<KnownRate> one_take, many, undated;
    for (KnownRate stretch : KnownGyroscope().stretches(0.02)) {
        stretch.take = 0;
        one_take.push_back(stretch);
        stretch.take = static_cast<int>(many.size());
        undated.push_back(stretch);
        stretch.take_began_s = 1.8e9 + stretch.begin_s;
        stretch.end_s -= stretch.begin_s;
        stretch.begin_s = 0;
        many.push_back(stretch);
    }
    constexpr double kWander_counts2_per_s = 1e-5;
    const Matrix3d together = fitGyroscope(one_take, kWander_counts2_per_s).sigma_matrix;
    EXPECT_LT((fitGyroscope(many, kWander_counts2_per_s).sigma_matrix - together).norm(),
              1e-6 * together.norm());
    EXPECT_GT(fitGyroscope(undated, kWander_counts2_per_s).sigma_matrix.norm(), 5 * together.norm());
    // A day later nothing is known of it but that it may have jumped.
    for (KnownRate& stretch : many)
        *stretch.take_began_s += 86400.0 * stretch.take;
    EXPECT_NEAR(fitGyroscope(many, kWander_counts2_per_s).sigma_matrix.norm() /
                    fitGyroscope(undated, kWander_counts2_per_s).sigma_matrix.norm(),
                0.93, 0.07);
}

/// Error over sigma, squared, in the mean over many sittings of six takes, one for each side.
struct SittingErrors {
    double slopes = 0, zeros = 0, restart_probability = 0;
};

constexpr int kSittings = 400;

/// `has_restart`: each time the board is switched off after one of the takes, whichever it is.
SittingErrors errorsOfSittings(bool with_rests, bool has_restart) {
    constexpr double kNoise_counts = 0.02, kWander_counts2_per_s = 1e-5, kRestart_counts = 1;
    const KnownGyroscope truth;
    SittingErrors errors;
    for (int run = 0; run < kSittings; ++run) {
        simulation::Random random(static_cast<uint64_t>(run + 1), "gyroscope sitting");
        const int restarts_in = has_restart ? 1 + run % 5 : -1;
        std::vector<KnownRate> sitting;
        Vector3d wandered_counts = Vector3d::Zero(), sum_counts = Vector3d::Zero();
        for (KnownRate stretch : truth.stretches(kNoise_counts)) {
            const bool is_rest = stretch.rate_rad_per_s.isZero();
            stretch.take = static_cast<int>(std::lround(stretch.begin_s / kStep_s)) / 2;
            stretch.take_began_s = 1.8e9;
            wandered_counts += random.gaussianVector(std::sqrt(kWander_counts2_per_s * kStep_s));
            if (is_rest && stretch.take == restarts_in)
                wandered_counts += random.gaussianVector(kRestart_counts);
            if (is_rest && !with_rests)
                continue;
            stretch.mean.counts += wandered_counts + random.gaussianVector(kNoise_counts);
            sum_counts += truth.zero_counts + wandered_counts;
            sitting.push_back(stretch);
        }
        const Vector3d mean_counts = sum_counts / static_cast<double>(sitting.size());
        const GyroscopeFit fit = fitGyroscope(sitting, kWander_counts2_per_s);
        errors.slopes +=
            (fit.axes.matrix - truth.matrix).cwiseQuotient(fit.sigma_matrix).squaredNorm() / (9 * kSittings);
        errors.zeros +=
            (fit.axes.zero_counts - mean_counts).cwiseQuotient(*fit.axes.sigma_zero_counts).squaredNorm() /
            (3 * kSittings);
        errors.restart_probability += fit.restart_probability / kSittings;
    }
    return errors;
}

/// No clock of a take tells that a board was switched off between two: the zeros do.
TEST(GyroscopeFit, SigmasAreHonestWhetherOrNotABoardWasSwitchedOffBetweenTakes) {
    const double tolerance = 3 * std::sqrt(2.0 / (3 * kSittings));
    for (const bool with_rests : {true, false}) {
        SCOPED_TRACE(with_rests ? "a rest before each turn" : "turns alone");
        const SittingErrors on = errorsOfSittings(with_rests, false);
        EXPECT_NEAR(on.slopes, 1, tolerance);
        EXPECT_NEAR(on.zeros, 1, tolerance);
        EXPECT_LT(on.restart_probability, 0.01);
        const SittingErrors off = errorsOfSittings(with_rests, true);
        EXPECT_LT(off.slopes, 1 + tolerance) << "over a hundred where nobody notices";
        EXPECT_NEAR(off.zeros, 1, tolerance);
        EXPECT_GT(off.restart_probability, 0.97);
        // Which of the takes it was is not believed: of turns alone that costs more than it must.
        EXPECT_GT(off.slopes, with_rests ? 1 - tolerance : 0.05);
    }
}

/// `clock_tells`: the takes behind the restart are dated years later.
std::vector<KnownRate> restartedSitting(double jump_counts, bool clock_tells) {
    constexpr int kRestartsIn = 3;
    constexpr double kNoise_counts = 0.02;
    simulation::Random random(1, "gyroscope restart");
    std::vector<KnownRate> sitting = KnownGyroscope().stretches(kNoise_counts);
    for (KnownRate& stretch : sitting) {
        stretch.take = static_cast<int>(std::lround(stretch.begin_s / kStep_s)) / 2;
        const bool is_behind = stretch.take >= kRestartsIn;
        stretch.take_began_s = is_behind && clock_tells ? 1.9e9 : 1.8e9;
        stretch.mean.counts +=
            random.gaussianVector(kNoise_counts) + (is_behind ? jump_counts : 0) * Vector3d(1, -1, 1);
    }
    return sitting;
}

/// However far: else the wandering of all boards is sought in it.
TEST(GyroscopeFit, AJumpThatOnlyTheZerosTellDisturbsNoMoreThanOneThatAClockTells) {
    constexpr double kWander_counts2_per_s = 1e-5;
    for (const double jump_counts : {1, 2, 4, 8}) {
        const GyroscopeFit told = fitGyroscope(restartedSitting(jump_counts, true), kWander_counts2_per_s),
                           found = fitGyroscope(restartedSitting(jump_counts, false), kWander_counts2_per_s);
        EXPECT_LT(told.restart_probability, 0.5) << jump_counts;
        EXPECT_GT(found.restart_probability, 0.99) << jump_counts;
        EXPECT_LE(found.chi_square, 1.01 * told.chi_square) << jump_counts;
        EXPECT_LT(found.chi_square, 3 * found.freedoms) << jump_counts;
    }
}

/// Where one border alone may hide a restart, its probability counts once.
TEST(GyroscopeFit, OneBorderIsOneChanceOfARestart) {
    constexpr double kNoise_counts = 20;  // so much that zeros tell nothing
    std::vector<KnownRate> sitting = KnownGyroscope().stretches(kNoise_counts);
    for (KnownRate& stretch : sitting)
        stretch.take_began_s = 1.8e9;
    EXPECT_NEAR(fitGyroscope(sitting, 1e-5).restart_probability, 0.01 / 1.01, 1e-3);
}

}  // namespace
}  // namespace noctule
