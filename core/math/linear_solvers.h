// SPDX-License-Identifier: Apache-2.0
// Dense linear algebra for fits: systems of any size by Eigen's decompositions, each compiled once. A
// decomposition of every size in every room takes seconds to compile; the filters' inner loops keep their own
// of fixed size.
#pragma once

#include "core/math/conventions.h"

namespace noctule {

using MatrixView = Eigen::Ref<const Eigen::MatrixXd>;

/// X of A X = B. A is symmetric and positive semidefinite; its lower triangle is read. L D L^T with pivots.
Eigen::MatrixXd solveSymmetric(const MatrixView& A, const MatrixView& B);
/// The same for positive definite A, faster from about 30 unknowns on. L L^T.
Eigen::MatrixXd solvePositive(const MatrixView& A, const MatrixView& B);
/// X of A X = B, A square. LU with row pivots.
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
