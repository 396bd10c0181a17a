// SPDX-License-Identifier: Apache-2.0
#include "core/math/covariance_kernels.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

namespace noctule {
namespace {

TEST(CovarianceKernels, OuterProductEqualsTheDenseProductForEverySize) {
    std::srand(3);
    for (long n : {1, 3, 4, 7, 8, 12, 13, 23, 24, 25, 45, 135, 150, 243})
        for (long m : {1, 3, 18, 54}) {
            const Eigen::MatrixXd half = Eigen::MatrixXd::Random(n, n), X = Eigen::MatrixXd::Random(n, m);
            const Eigen::MatrixXd P = half * half.transpose();
            Eigen::MatrixXd updated = P;
            subtractOuterProduct(updated, X.transpose());
            EXPECT_LT((updated - (P - X * X.transpose())).cwiseAbs().maxCoeff(), 1e-11 * double(n))
                << n << " " << m;
            EXPECT_EQ((updated - updated.transpose()).cwiseAbs().maxCoeff(), 0) << n << " " << m;
        }
}

TEST(CovarianceKernels, SparseProductEqualsTheDenseOne) {
    std::srand(4);
    for (long n : {3, 8, 45, 252})
        for (long rows : {1, 2, 3, 6, 7}) {
            const Eigen::MatrixXd P = Eigen::MatrixXd::Random(n, n + 2);
            const std::vector<int> columns{0, static_cast<int>(n) + 1, static_cast<int>(n) / 2};
            const Eigen::MatrixXd H = Eigen::MatrixXd::Random(rows, 3);
            Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(rows, n + 2);
            for (size_t k = 0; k < columns.size(); ++k)
                dense.col(columns[k]) += H.col(static_cast<long>(k));
            Eigen::MatrixXd product = Eigen::MatrixXd::Constant(n, rows + 2, 7);
            multiplySparse(P, columns, H, product, 1);
            EXPECT_LT((product.middleCols(1, rows) - P * dense.transpose()).cwiseAbs().maxCoeff(), 1e-13);
            EXPECT_EQ(product(0, 0), 7);
            EXPECT_EQ(product(n - 1, rows + 1), 7);
        }
}

TEST(CovarianceKernels, ProductOfSmallMatricesIsAdded) {
    std::srand(5);
    for (long m : {1, 3, 4, 9, 18})
        for (long p : {1, 2, 7, 22}) {
            const Eigen::MatrixXd A = Eigen::MatrixXd::Random(m, p), B = Eigen::MatrixXd::Random(p, 31);
            Eigen::MatrixXd C = Eigen::MatrixXd::Random(m, 31);
            const Eigen::MatrixXd expected = C - 2 * A * B;
            addProduct(C, -2, A, B);
            EXPECT_LT((C - expected).cwiseAbs().maxCoeff(), 1e-13) << m << " " << p;
        }
}

TEST(CovarianceKernels, ProductWithALowerTriangleEqualsTheFullOne) {
    std::srand(6);
    for (long m : {1, 3, 4, 9, 12, 19, 27}) {
        const Eigen::MatrixXd L =
            Eigen::MatrixXd(Eigen::MatrixXd::Random(m, m).triangularView<Eigen::Lower>());
        const Eigen::MatrixXd B = Eigen::MatrixXd::Random(m, 33), C = Eigen::MatrixXd::Random(m, 33);
        Eigen::MatrixXd sum = C;
        addProduct(sum, 1.5, L, B, Shape::kLowerTriangular);
        EXPECT_LT((sum - (C + 1.5 * L * B)).cwiseAbs().maxCoeff(), 1e-13) << m;
    }
}

TEST(CovarianceKernels, ALowerTriangleIsInverted) {
    std::srand(9);
    for (long n : {1, 2, 8, 9, 17, 54, 61}) {
        const Eigen::MatrixXd half = Eigen::MatrixXd::Random(n, n);
        const Eigen::MatrixXd S = half * half.transpose() + Eigen::MatrixXd::Identity(n, n);
        const Eigen::MatrixXd L = S.llt().matrixL();
        Eigen::MatrixXd inverse = L;
        invertLowerTriangle(inverse);
        EXPECT_LT((inverse * L - Eigen::MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff(), 1e-12) << n;
        EXPECT_TRUE(inverse.isLowerTriangular(0)) << n;
    }
}

TEST(CovarianceKernels, ProductWithASparseMatrixIsAdded) {
    std::srand(7);
    for (long length : {1, 3, 8, 45, 235})
        for (long rows : {1, 2, 3, 7}) {
            const Eigen::MatrixXd M = Eigen::MatrixXd::Random(length, rows + 2);
            const std::vector<int> columns{4, 0, 9};
            const Eigen::MatrixXd H = Eigen::MatrixXd::Random(rows, 3);
            const Eigen::MatrixXd C = Eigen::MatrixXd::Random(length, 10);
            Eigen::MatrixXd expected = C, sum = C;
            for (size_t k = 0; k < columns.size(); ++k)
                expected.col(columns[k]) += M.middleCols(1, rows) * H.col(static_cast<long>(k));
            addTimesSparse(sum, M, 1, columns, H);
            EXPECT_LT((sum - expected).cwiseAbs().maxCoeff(), 1e-13) << length << " " << rows;
        }
}

TEST(CovarianceKernels, AMatrixAndItsTransposeAreAdded) {
    std::srand(8);
    for (long n : {1, 5, 31, 32, 33, 70, 234}) {
        const Eigen::MatrixXd half = Eigen::MatrixXd::Random(n, n), X = Eigen::MatrixXd::Random(n, n);
        const Eigen::MatrixXd P = half + half.transpose();
        Eigen::MatrixXd sum = P;
        addWithTranspose(sum, X);
        EXPECT_LT((sum - (P + X + X.transpose())).cwiseAbs().maxCoeff(), 1e-14) << n;
        EXPECT_EQ((sum - sum.transpose()).cwiseAbs().maxCoeff(), 0) << n;
    }
}

}  // namespace
}  // namespace noctule
