// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/gyroscope/gyroscope_fit.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/math/linear_solvers.h"

namespace noctule {
namespace {

constexpr double kSigmaJump_counts = 1;  ///< of a zero from one take to another of another day
constexpr double kLeastSigma_counts = 0.002;

/// One axis of the gyroscope: its row of matrix^-1, then the zero of every stretch.
struct GyroRow {
    Eigen::VectorXd x;
    Eigen::MatrixXd covariance;
    double chi_square = 0;
};

double middleOf_s(const KnownRate& stretch) {
    return (stretch.begin_s + stretch.end_s) / 2;
}

/// Takes of one sitting lie minutes apart, in which a zero wanders as within a take and does not jump.
double wanderVariance(const KnownRate& before, const KnownRate& after, double wander_counts2_per_s) {
    if (before.take == after.take)
        return wander_counts2_per_s * std::max(middleOf_s(after) - middleOf_s(before), 0.1);
    constexpr double kJump_counts2 = kSigmaJump_counts * kSigmaJump_counts;
    if (!before.take_began_s || !after.take_began_s)
        return kJump_counts2;
    // Takes begin to the second; two stretches never overlap.
    const double least_s = (before.end_s - before.begin_s + after.end_s - after.begin_s) / 2;
    const double apart_s =
        std::abs(*after.take_began_s + middleOf_s(after) - *before.take_began_s - middleOf_s(before));
    return std::min(kJump_counts2, wander_counts2_per_s * std::max(apart_s, least_s));
}

GyroRow fitRow(const std::vector<KnownRate>& stretches, int axis, double wander_counts2_per_s) {
    const auto count = static_cast<Eigen::Index>(stretches.size());
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2 * count - 1, 3 + count);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * count - 1);
    for (Eigen::Index k = 0; k < count; ++k) {
        const KnownRate& stretch = stretches[static_cast<size_t>(k)];
        const double sigma = std::max(stretch.mean.sigma[axis], kLeastSigma_counts);
        rows.block<1, 3>(k, 0) = stretch.rate_rad_per_s.transpose() / sigma;
        rows(k, 3 + k) = 1 / sigma;
        right[k] = stretch.mean.counts[axis] / sigma;
        if (k == 0)
            continue;
        const double step =
            std::sqrt(wanderVariance(stretches[static_cast<size_t>(k - 1)], stretch, wander_counts2_per_s));
        rows(count + k - 1, 3 + k) = 1 / step;
        rows(count + k - 1, 2 + k) = -1 / step;
    }
    GyroRow row;
    row.covariance = inverseOf(rows.transpose() * rows);
    row.x = solveLeastSquares(rows, right);
    row.chi_square = (rows * row.x - right).squaredNorm();
    return row;
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
    Matrix3d counts_per_rate;
    std::array<Matrix3d, 3> covariances;
    Vector3d sigma_zero;
    for (int axis = 0; axis < 3; ++axis) {
        const GyroRow row = fitRow(stretches, axis, wander_counts2_per_s);
        counts_per_rate.row(axis) = row.x.head<3>();
        covariances[static_cast<size_t>(axis)] = row.covariance.topLeftCorner<3, 3>();
        for (size_t k = 0; k < stretches.size(); ++k)
            fit.zeros_counts[k][axis] = row.x[3 + static_cast<Eigen::Index>(k)];
        fit.axes.zero_counts[axis] = share.dot(row.x);
        sigma_zero[axis] = std::sqrt(share.dot(row.covariance * share));
        fit.chi_square += row.chi_square;
    }
    fit.freedoms = 3 * (static_cast<int>(stretches.size()) - 4);
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
