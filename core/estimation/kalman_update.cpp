// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/kalman_update.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "core/math/symmetric_update.h"

namespace noctule {

Eigen::VectorXd innovationVariance(const Eigen::MatrixXd& P, const ObservationBlock& block) {
    Eigen::VectorXd variance = block.variance;
    const Eigen::Index n = block.H.cols();
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) {
            const double p = P(block.columns[static_cast<size_t>(i)], block.columns[static_cast<size_t>(j)]);
            variance += p * block.H.col(i).cwiseProduct(block.H.col(j));
        }
    return variance;
}

Eigen::VectorXd kalmanUpdate(Eigen::MatrixXd& P, const std::vector<ObservationBlock>& blocks, bool* failed) {
    const Eigen::Index n = P.rows();
    Eigen::Index m = 0;
    for (const ObservationBlock& block : blocks)
        m += block.rows();
    if (m == 0)
        return Eigen::VectorXd::Zero(n);

    Eigen::MatrixXd gain = Eigen::MatrixXd::Zero(n, m);  // P H^T, later P H^T L^-T
    Eigen::VectorXd residual(m);
    Eigen::Index row = 0;
    for (const ObservationBlock& block : blocks) {
        for (Eigen::Index k = 0; k < block.H.cols(); ++k) {
            const auto column = P.col(block.columns[static_cast<size_t>(k)]);
            for (Eigen::Index r = 0; r < block.rows(); ++r)
                if (block.H(r, k) != 0)
                    gain.col(row + r) += block.H(r, k) * column;
        }
        residual.segment(row, block.rows()) = block.residual;
        row += block.rows();
    }
    Eigen::MatrixXd S(m, m);  // H P H^T + R
    row = 0;
    for (const ObservationBlock& block : blocks) {
        auto rows = S.middleRows(row, block.rows());
        rows.setZero();
        for (Eigen::Index k = 0; k < block.H.cols(); ++k)
            rows.noalias() += block.H.col(k) * gain.row(block.columns[static_cast<size_t>(k)]);
        rows.middleCols(row, block.rows()).diagonal() += block.variance;
        row += block.rows();
    }
    const Eigen::LLT<Eigen::MatrixXd> factor(S);
    if (factor.info() != Eigen::Success) {
        if (failed)
            *failed = true;
        return Eigen::VectorXd::Zero(n);
    }
    factor.matrixU().solveInPlace<Eigen::OnTheRight>(gain);
    const Eigen::VectorXd whitened = factor.matrixL().solve(residual);
    subtractOuterProduct(P, gain);
    return gain * whitened;
}

void limitInfluence(const Eigen::MatrixXd& P, ObservationBlock& block, double threshold_sigma) {
    const Eigen::VectorXd variance = innovationVariance(P, block);
    for (Eigen::Index r = 0; r < block.rows(); ++r) {
        const double ratio = std::abs(block.residual[r]) / (threshold_sigma * std::sqrt(variance[r]));
        if (ratio > 1)
            block.variance[r] += (ratio - 1) * variance[r];
    }
}

}  // namespace noctule
