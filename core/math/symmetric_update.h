// SPDX-License-Identifier: Apache-2.0
// The one expensive step of a Kalman filter with a large state: P := P - X X^T for a symmetric P.
#pragma once

#include <Eigen/Core>

namespace noctule {

/// P (n x n, symmetric, both triangles stored) minus X X^T (X n x m). Both triangles stay equal to the bit.
/// Works on plain arrays and is compiled for several instruction sets, chosen at run time: no Eigen type
/// crosses a translation unit built with other flags.
void subtractOuterProduct(Eigen::MatrixXd& P, const Eigen::MatrixXd& X);

}  // namespace noctule
