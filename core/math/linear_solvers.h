// SPDX-License-Identifier: Apache-2.0
// Dense linear algebra of any size, compiled here for all rooms: Eigen takes seconds to compile each
// decomposition anew. Code that needs the factor itself, or that runs once per sample, uses Eigen directly.
// None of these reports failure. Of input that is not finite the solution is not. Of a singular matrix those
// of solvePositive and solveSquare are not finite or wrong. Of an indefinite one solvePositive's is wrong.
#pragma once

#include "core/math/conventions.h"

namespace noctule {

using MatrixView = Eigen::Ref<const Eigen::MatrixXd>;

/// Solution X of A X = B. A is symmetric and positive semidefinite; its lower triangle is read. L D L^T with
/// pivots.
Eigen::MatrixXd solveSymmetric(const MatrixView& A, const MatrixView& B);
/// The same for positive definite A, faster from about 30 unknowns on. L L^T.
Eigen::MatrixXd solvePositive(const MatrixView& A, const MatrixView& B);
/// Solution X of A X = B, A square. LU with row pivots.
Eigen::MatrixXd solveSquare(const MatrixView& A, const MatrixView& B);
Eigen::MatrixXd inverseOf(const MatrixView& A);
/// X that makes |A X - B| least; of several, for A of lower rank, the shortest. Complete orthogonal
/// decomposition.
Eigen::MatrixXd solveLeastSquares(const MatrixView& A, const MatrixView& B);
/// Orthonormal columns that span those of A.
Eigen::MatrixXd basisOf(const MatrixView& A);

/// Of a symmetric matrix; its lower triangle is read.
struct Eigensystem {
    Eigen::VectorXd values;   ///< ascending
    Eigen::MatrixXd vectors;  ///< orthonormal columns, in the values' order
};
Eigensystem eigensystemOf(const MatrixView& A);
/// Without the vectors.
Eigen::VectorXd eigenvaluesOf(const MatrixView& A);

}  // namespace noctule
