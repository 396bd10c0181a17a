// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/covariance.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

namespace noctule {
namespace {

ObservationBlock randomBlock(Eigen::Index rows, int n) {
    ObservationBlock block;
    block.columns = {1, n - 2, n / 2, 3};
    block.H = Eigen::MatrixXd::Random(rows, 4);
    block.residual = Eigen::VectorXd::Random(rows);
    block.variance = Eigen::VectorXd::Random(rows).cwiseAbs().array() + 0.1;
    return block;
}

TEST(Covariance, EqualsThePlainFormulasStepByStep) {
    std::srand(8);
    constexpr int n = 40;
    Eigen::VectorXd variances = Eigen::VectorXd::Random(n).cwiseAbs().array() + 0.5;
    Covariance covariance(variances);
    Eigen::MatrixXd P = variances.asDiagonal();
    for (int step = 0; step < 6; ++step) {
        const std::vector<ObservationBlock> blocks{randomBlock(3, n), randomBlock(1, n), randomBlock(6, n)};
        Eigen::MatrixXd H = Eigen::MatrixXd::Zero(10, n);
        Eigen::VectorXd residual(10), noise(10);
        Eigen::Index row = 0;
        for (const ObservationBlock& block : blocks) {
            for (size_t k = 0; k < block.columns.size(); ++k)
                H.block(row, block.columns[k], block.rows(), 1) += block.H.col(static_cast<Eigen::Index>(k));
            residual.segment(row, block.rows()) = block.residual;
            noise.segment(row, block.rows()) = block.variance;
            row += block.rows();
        }
        const Eigen::MatrixXd S = H * P * H.transpose() + Eigen::MatrixXd(noise.asDiagonal());
        EXPECT_NEAR(covariance.innovationVariance(blocks[1])[0], S(3, 3), 1e-12);
        const Eigen::MatrixXd K = P * H.transpose() * S.inverse();
        EXPECT_LT((covariance.update(blocks) - K * residual).norm(), 1e-11) << step;
        P = (Eigen::MatrixXd::Identity(n, n) - K * H) * P;
        if (step % 2 == 1) {  // pending updates pile up in between
            EXPECT_LT((covariance.dense() - P).cwiseAbs().maxCoeff(), 1e-11) << step;
        }
    }
}

TEST(Covariance, WhatIsExpectedFollowsItsChanges) {
    Covariance covariance(Eigen::VectorXd::Ones(5));
    const ObservationBlock block = pull(2, 0.5, 1);
    EXPECT_EQ(covariance.innovationVariance(block)[0], 2);
    covariance.dense()(2, 2) = 3;
    EXPECT_EQ(covariance.innovationVariance(block)[0], 4);
    const Covariance copy = covariance;
    EXPECT_NEAR(covariance.update({block})[2], 0.5 * 3 / 4, 1e-15);
    EXPECT_NEAR(covariance.innovationVariance(block)[0], 1.75, 1e-15);
    EXPECT_EQ(copy.innovationVariance(block)[0], 4);
}

TEST(Covariance, NothingObservedChangesNothing) {
    Covariance covariance(Eigen::VectorXd::Ones(5));
    EXPECT_EQ(covariance.update({}).norm(), 0);
    EXPECT_EQ((covariance.dense() - Eigen::MatrixXd::Identity(5, 5)).norm(), 0);
}

}  // namespace
}  // namespace noctule
