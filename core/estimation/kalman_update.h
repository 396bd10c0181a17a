// SPDX-License-Identifier: Apache-2.0
// The Kalman observation step (Vlasic 2007, equations 7 to 9) for many measurements with sparse Jacobians at
// one linearisation.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/estimation/observation.h"

namespace noctule {

/// Variance of the innovation of each row of a block, H P H^T + R on the diagonal.
Eigen::VectorXd innovationVariance(const Eigen::MatrixXd& P, const ObservationBlock& block);

/// Updates the symmetric covariance P (n x n) in place and returns the error state's correction K * residual.
/// Returns a zero correction and leaves P alone when nothing is observed or the innovation covariance is not
/// positive definite (then `*failed` is set when given).
Eigen::VectorXd kalmanUpdate(Eigen::MatrixXd& P, const std::vector<ObservationBlock>& blocks,
                             bool* failed = nullptr);

}  // namespace noctule
