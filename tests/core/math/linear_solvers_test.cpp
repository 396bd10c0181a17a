// SPDX-License-Identifier: Apache-2.0
#include "core/math/linear_solvers.h"

#include <gtest/gtest.h>

#include <random>

namespace noctule {
namespace {

using Eigen::MatrixXd;

MatrixXd randomMatrix(int rows, int columns, unsigned seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal;
    return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(generator); });
}

TEST(LinearSolvers, SolutionsFulfilTheirEquations) {
    for (const int n : {1, 2, 3, 6, 40, 90}) {
        const auto seed = static_cast<unsigned>(n);
        const MatrixXd A = randomMatrix(n, n, seed), B = randomMatrix(n, 3, seed + 1);
        const MatrixXd S = A * A.transpose() + MatrixXd::Identity(n, n);
        EXPECT_LT((S * solveSymmetric(S, B) - B).norm(), 1e-9) << n;
        EXPECT_LT((S * solvePositive(S, B) - B).norm(), 1e-9) << n;
        EXPECT_LT((A * solveSquare(A, B) - B).norm(), 1e-9) << n;
        EXPECT_LT((A * inverseOf(A) - MatrixXd::Identity(n, n)).norm(), 1e-9) << n;
    }
}

TEST(LinearSolvers, ASemidefiniteSystemThatHasASolutionIsSolved) {
    const MatrixXd half = randomMatrix(6, 4, 11), S = half * half.transpose();
    const MatrixXd B = S * randomMatrix(6, 2, 12);
    EXPECT_LT((S * solveSymmetric(S, B) - B).norm(), 1e-9);
    const Vector3d diagonal(1, 0, 4), right(1, 0, 8);
    EXPECT_LT((solveSymmetric(Matrix3d(diagonal.asDiagonal()), right) - Vector3d(1, 0, 2)).norm(), 1e-12);
}

TEST(LinearSolvers, BlocksAndRowsAreTakenAsTheyStand) {
    const MatrixXd A = randomMatrix(9, 9, 13), B = randomMatrix(9, 9, 14);
    const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> rows = A.block<4, 4>(2, 3);
    const MatrixXd expected = solveSquare(MatrixXd(A.block(2, 3, 4, 4)), MatrixXd(B.block(1, 1, 4, 3)));
    EXPECT_EQ(solveSquare(A.block(2, 3, 4, 4), B.block(1, 1, 4, 3)), expected);
    EXPECT_EQ(solveSquare(rows, B.block(1, 1, 4, 3)), expected);
}

TEST(LinearSolvers, OnlyTheLowerTriangleIsRead) {
    const MatrixXd A = randomMatrix(7, 7, 4), B = randomMatrix(7, 2, 5);
    const MatrixXd S = A * A.transpose();
    const MatrixXd lower = S.triangularView<Eigen::Lower>();
    EXPECT_EQ(solveSymmetric(lower, B), solveSymmetric(S, B));
    EXPECT_EQ(solvePositive(lower, B), solvePositive(S, B));
    EXPECT_EQ(eigenvaluesOf(lower), eigenvaluesOf(S));
    EXPECT_EQ(eigensystemOf(lower).vectors, eigensystemOf(S).vectors);
}

TEST(LinearSolvers, LeastSquaresLeaveWhatNoColumnExplains) {
    const MatrixXd A = randomMatrix(20, 5, 6), B = randomMatrix(20, 2, 7);
    const MatrixXd left = B - A * solveLeastSquares(A, B);
    EXPECT_LT((A.transpose() * left).norm(), 1e-12);
    EXPECT_GT(left.norm(), 1);
}

TEST(LinearSolvers, OfSeveralLeastSquaresTheShortestIsTaken) {
    MatrixXd A = randomMatrix(20, 4, 8);
    A.col(3) = A.col(1);
    const MatrixXd B = randomMatrix(20, 1, 9);
    const MatrixXd x = solveLeastSquares(A, B);
    EXPECT_LT((A.transpose() * (B - A * x)).norm(), 1e-12);
    EXPECT_NEAR(x(1), x(3), 1e-12) << "equal columns share";
    const MatrixXd basis = basisOf(A);
    ASSERT_EQ(basis.cols(), 3);
    EXPECT_LT((basis.transpose() * basis - MatrixXd::Identity(3, 3)).norm(), 1e-12);
    EXPECT_LT((A - basis * (basis.transpose() * A)).norm(), 1e-12);
}

TEST(LinearSolvers, EigenvectorsAreOrthonormalAndAscend) {
    const MatrixXd A = randomMatrix(9, 9, 10), S = A + A.transpose();
    const Eigensystem system = eigensystemOf(S);
    EXPECT_LT((S * system.vectors - system.vectors * system.values.asDiagonal()).norm(), 1e-12);
    EXPECT_LT((system.vectors.transpose() * system.vectors - MatrixXd::Identity(9, 9)).norm(), 1e-12);
    EXPECT_LT((eigenvaluesOf(S) - system.values).norm(), 1e-12);
    for (Eigen::Index k = 1; k < 9; ++k)
        EXPECT_LE(system.values[k - 1], system.values[k]);
}

}  // namespace
}  // namespace noctule
