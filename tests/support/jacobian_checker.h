// SPDX-License-Identifier: Apache-2.0
// The one central-difference checker for every analytic Jacobian of the project.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <functional>
#include <string>

namespace noctule::testing {

/// Compares `analytic` (rows x n) with central differences of f(delta) at delta = 0, f: R^n -> R^rows, and
/// expects the largest deviation below `relative_tolerance` times the Jacobian's own largest element (at
/// least 1). Fourth-order differences: with step 1e-3 the truncation error is about 1e-12 of the fifth
/// derivative.
inline void expectJacobian(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& f,
                           const Eigen::MatrixXd& analytic, const std::string& what,
                           double relative_tolerance = 1e-7, double step = 1e-3) {
    const Eigen::Index n = analytic.cols();
    Eigen::MatrixXd numeric(analytic.rows(), n);
    for (Eigen::Index k = 0; k < n; ++k) {
        const Eigen::VectorXd e = Eigen::VectorXd::Unit(n, k) * step;
        numeric.col(k) = (8 * (f(e) - f(-e)) - (f(2 * e) - f(-2 * e))) / (12 * step);
    }
    const double scale = std::max(1.0, numeric.cwiseAbs().maxCoeff());
    Eigen::Index row = 0, column = 0;
    const double worst = (numeric - analytic).cwiseAbs().maxCoeff(&row, &column);
    EXPECT_LT(worst, relative_tolerance * scale)
        << what << ": element (" << row << ", " << column << ") is " << analytic(row, column)
        << ", differences give " << numeric(row, column);
}

}  // namespace noctule::testing
