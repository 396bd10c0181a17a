// SPDX-License-Identifier: Apache-2.0
#include "core/math/linear_solvers.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

namespace noctule {

using Eigen::MatrixXd;

MatrixXd solveSymmetric(const MatrixView& A, const MatrixView& B) {
    return Eigen::LDLT<MatrixXd>(A).solve(B);
}

MatrixXd solvePositive(const MatrixView& A, const MatrixView& B) {
    return Eigen::LLT<MatrixXd>(A).solve(B);
}

MatrixXd solveSquare(const MatrixView& A, const MatrixView& B) {
    return Eigen::PartialPivLU<MatrixXd>(A).solve(B);
}

MatrixXd inverseOf(const MatrixView& A) {
    return solveSquare(A, MatrixXd::Identity(A.rows(), A.cols()));
}

MatrixXd solveLeastSquares(const MatrixView& A, const MatrixView& B) {
    return Eigen::CompleteOrthogonalDecomposition<MatrixXd>(A).solve(B);
}

MatrixXd basisOf(const MatrixView& A) {
    const Eigen::CompleteOrthogonalDecomposition<MatrixXd> factors(A);
    return factors.householderQ() * MatrixXd::Identity(A.rows(), factors.rank());
}

Eigensystem eigensystemOf(const MatrixView& A) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(A);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXd eigenvaluesOf(const MatrixView& A) {
    return Eigen::SelfAdjointEigenSolver<MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace noctule
