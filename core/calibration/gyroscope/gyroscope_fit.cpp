// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/gyroscope/gyroscope_fit.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/linear_solvers.h"

namespace noctule {
namespace {

constexpr double kSigmaJump_counts = 1;  ///< of a zero when its board starts anew, and of another day
constexpr double kJump_counts2 = kSigmaJump_counts * kSigmaJump_counts;
constexpr double kLeastSigma_counts = 0.002;
constexpr double kRestartProbability = 0.01;  ///< between two takes of one sitting, before the data speak
constexpr double kNoRestart = 1e-5;           ///< probabilities below it are taken for none

/// One axis of the gyroscope: its row of matrix^-1, then the zero of every stretch.
struct GyroRow {
    Eigen::VectorXd x;
    Eigen::MatrixXd covariance;
    double chi_square = 0, freedoms = 0;  ///< without jumps: how far they go says nothing of the wandering
    double log_evidence = 0;              ///< how likely the counts are with these steps; up to a constant
};
using GyroRows = std::array<GyroRow, 3>;

double middleOf_s(const KnownRate& stretch) {
    return (stretch.begin_s + stretch.end_s) / 2;
}

/// Takes of one sitting lie minutes apart, in which a zero wanders as within a take and does not jump.
double wanderVariance(const KnownRate& before, const KnownRate& after, double wander_counts2_per_s) {
    if (before.take == after.take)
        return wander_counts2_per_s * std::max(middleOf_s(after) - middleOf_s(before), 0.1);
    if (!before.take_began_s || !after.take_began_s)
        return kJump_counts2;
    // Takes begin to the second; two stretches never overlap.
    const double least_s = (before.end_s - before.begin_s + after.end_s - after.begin_s) / 2;
    const double apart_s =
        std::abs(*after.take_began_s + middleOf_s(after) - *before.take_began_s - middleOf_s(before));
    return std::min(kJump_counts2, wander_counts2_per_s * std::max(apart_s, least_s));
}

/// Variance of a zero's step to each stretch from the one before; of the first unused.
std::vector<double> stepsOf(const std::vector<KnownRate>& stretches, double wander_counts2_per_s) {
    std::vector<double> steps_counts2(stretches.size(), kJump_counts2);
    for (size_t k = 1; k < stretches.size(); ++k)
        steps_counts2[k] = wanderVariance(stretches[k - 1], stretches[k], wander_counts2_per_s);
    return steps_counts2;
}

GyroRow fitRow(const std::vector<KnownRate>& stretches, int axis, const std::vector<double>& steps_counts2) {
    const auto count = static_cast<Eigen::Index>(stretches.size());
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2 * count - 1, 3 + count);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * count - 1);
    GyroRow row;
    for (Eigen::Index k = 0; k < count; ++k) {
        const KnownRate& stretch = stretches[static_cast<size_t>(k)];
        const double sigma = std::max(stretch.mean.sigma[axis], kLeastSigma_counts);
        rows.block<1, 3>(k, 0) = stretch.rate_rad_per_s.transpose() / sigma;
        rows(k, 3 + k) = 1 / sigma;
        right[k] = stretch.mean.counts[axis] / sigma;
        if (k == 0)
            continue;
        const double step = std::sqrt(steps_counts2[static_cast<size_t>(k)]);
        rows(count + k - 1, 3 + k) = 1 / step;
        rows(count + k - 1, 2 + k) = -1 / step;
        row.log_evidence -= std::log(step);
    }
    row.covariance = inverseOf(rows.transpose() * rows);
    row.x = solveLeastSquares(rows, right);
    const Eigen::VectorXd left = rows * row.x - right;
    row.chi_square = left.squaredNorm();
    row.log_evidence += (eigenvaluesOf(row.covariance).array().log().sum() - row.chi_square) / 2;
    row.freedoms = static_cast<double>(count - 4);
    for (Eigen::Index k = 1; k < count; ++k) {
        if (steps_counts2[static_cast<size_t>(k)] < kJump_counts2)
            continue;
        const Eigen::Index jump = count + k - 1;
        row.chi_square -= left[jump] * left[jump];
        row.freedoms -= 1 - rows.row(jump).dot(row.covariance * rows.row(jump).transpose());
    }
    return row;
}

GyroRows fitRows(const std::vector<KnownRate>& stretches, const std::vector<double>& steps_counts2) {
    GyroRows rows;
    for (int axis = 0; axis < 3; ++axis)
        rows[static_cast<size_t>(axis)] = fitRow(stretches, axis, steps_counts2);
    return rows;
}

/// Over all axes.
double sumOf(double GyroRow::*value, const GyroRows& rows) {
    return rows[0].*value + rows[1].*value + rows[2].*value;
}

/// As if both were drawn with these probabilities: what they disagree about is uncertain, too.
void mix(GyroRow& one, const GyroRow& other, double share_of_other) {
    const Eigen::VectorXd apart = other.x - one.x;
    one.covariance = (1 - share_of_other) * one.covariance + share_of_other * other.covariance +
                     share_of_other * (1 - share_of_other) * apart * apart.transpose();
    one.x += share_of_other * apart;
}

/// All axes, and whether the board started anew within a sitting.
struct SittingFit {
    GyroRows rows;
    double chi_square = 0, freedoms = 0;
    double restart_probability = 0;
};

/// A board that was switched off between two takes has another zero, and no clock in a take tells of it. The
/// counts do: a jump after each single take, and after each of them, is held against none (Bayes). Which take
/// it came after cannot always be told, so with a jump all takes count as of different days.
SittingFit fitSitting(const std::vector<KnownRate>& stretches, double wander_counts2_per_s) {
    const std::vector<double> together = stepsOf(stretches, wander_counts2_per_s);
    std::vector<double> apart = together;
    SittingFit fit{fitRows(stretches, together)};
    std::vector<double> log_weights, chi_squares, freedoms;
    const auto weigh = [&](const GyroRows& rows, double probability) {
        log_weights.push_back(std::log(probability) + sumOf(&GyroRow::log_evidence, rows));
        chi_squares.push_back(sumOf(&GyroRow::chi_square, rows));
        freedoms.push_back(sumOf(&GyroRow::freedoms, rows));
    };
    weigh(fit.rows, 1);
    for (size_t k = 1; k < stretches.size(); ++k) {
        if (stretches[k].take == stretches[k - 1].take || together[k] >= kJump_counts2)
            continue;
        std::vector<double> once = together;
        once[k] = apart[k] = kJump_counts2;
        weigh(fitRows(stretches, once), kRestartProbability);
    }
    fit.chi_square = chi_squares[0];
    fit.freedoms = freedoms[0];
    const size_t borders = log_weights.size() - 1;
    if (borders == 0)
        return fit;
    const GyroRows rows_apart = fitRows(stretches, apart);
    if (borders > 1)  // else it is the one that was weighed already
        weigh(rows_apart, kRestartProbability);
    // Evidence spans thousands of e-folds: only differences from the greatest can be raised to powers.
    const double greatest = std::ranges::max(log_weights);
    double sum = 0, chi_square = 0, freedom = 0;
    for (size_t i = 0; i < log_weights.size(); ++i) {
        const double weight = std::exp(log_weights[i] - greatest);
        sum += weight;
        chi_square += weight * chi_squares[i];
        freedom += weight * freedoms[i];
    }
    const double probability = 1 - std::exp(log_weights[0] - greatest) / sum;
    if (!(probability >= kNoRestart))  // nor when it is no number
        return fit;
    fit.restart_probability = probability;
    fit.chi_square = chi_square / sum;
    fit.freedoms = freedom / sum;
    for (size_t axis = 0; axis < 3; ++axis)
        mix(fit.rows[axis], rows_apart[axis], fit.restart_probability);
    return fit;
}

/// Each stretch counts as long as it lasts.
Eigen::VectorXd shareOfTime(const std::vector<KnownRate>& stretches) {
    Eigen::VectorXd share = Eigen::VectorXd::Zero(3 + static_cast<Eigen::Index>(stretches.size()));
    for (size_t k = 0; k < stretches.size(); ++k)
        share[3 + static_cast<Eigen::Index>(k)] = stretches[k].end_s - stretches[k].begin_s;
    return share / share.sum();
}

}  // namespace

GyroscopeFit fitGyroscope(const std::vector<KnownRate>& stretches, double wander_counts2_per_s) {
    GyroscopeFit fit;
    fit.zeros_counts.resize(stretches.size());
    const Eigen::VectorXd share = shareOfTime(stretches);
    const SittingFit sitting = fitSitting(stretches, wander_counts2_per_s);
    Matrix3d counts_per_rate;
    std::array<Matrix3d, 3> covariances;
    Vector3d sigma_zero;
    for (int axis = 0; axis < 3; ++axis) {
        const GyroRow& row = sitting.rows[static_cast<size_t>(axis)];
        counts_per_rate.row(axis) = row.x.head<3>();
        covariances[static_cast<size_t>(axis)] = row.covariance.topLeftCorner<3, 3>();
        for (size_t k = 0; k < stretches.size(); ++k)
            fit.zeros_counts[k][axis] = row.x[3 + static_cast<Eigen::Index>(k)];
        fit.axes.zero_counts[axis] = share.dot(row.x);
        sigma_zero[axis] = std::sqrt(share.dot(row.covariance * share));
    }
    fit.chi_square = sitting.chi_square;
    fit.restart_probability = sitting.restart_probability;
    fit.freedoms = sitting.freedoms;
    fit.axes.sigma_zero_counts = sigma_zero;
    const Matrix3d M = counts_per_rate.inverse();
    fit.axes.matrix = M;
    for (int i = 0; i < 3; ++i)  // dM = -M d(M^-1) M
        for (int j = 0; j < 3; ++j) {
            double variance = 0;
            for (int row = 0; row < 3; ++row)
                variance +=
                    M(i, row) * M(i, row) * M.col(j).dot(covariances[static_cast<size_t>(row)] * M.col(j));
            fit.sigma_matrix(i, j) = std::sqrt(variance);
        }
    return fit;
}

}  // namespace noctule
