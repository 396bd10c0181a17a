// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/math/linear_solvers.h"

namespace noctule::test {

/// Normalised estimation error squared, per coordinate: 1 on average where the covariance is honest, more
/// where it is too small.
inline double nees(const Eigen::VectorXd& error, const Eigen::MatrixXd& covariance) {
    return error.dot(Eigen::VectorXd(solveSymmetric(covariance, error))) / static_cast<double>(error.size());
}

}  // namespace noctule::test
