// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/kalman_update.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "core/math/covariance_kernels.h"

namespace noctule {

Eigen::VectorXd innovationVariance(const Eigen::MatrixXd& P, const ObservationBlock& block) {
    Eigen::VectorXd variance = block.variance;
    const Eigen::Index n = block.H.cols();
    for (Eigen::Index j = 0; j < n; ++j) {
        const auto column = P.col(block.columns[static_cast<size_t>(j)]);
        for (Eigen::Index i = 0; i <= j; ++i) {
            const double p = column[block.columns[static_cast<size_t>(i)]] * (i == j ? 1 : 2);
            variance += p * block.H.col(i).cwiseProduct(block.H.col(j));
        }
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

    Eigen::MatrixXd gain(n, m);  // P H^T, later P H^T L^-T
    Eigen::VectorXd residual(m);
    Eigen::Index row = 0;
    for (const ObservationBlock& block : blocks) {
        multiplySparse(P, block.columns, block.H, gain, row);
        residual.segment(row, block.rows()) = block.residual;
        row += block.rows();
    }
    const Eigen::MatrixXd gain_by_row = gain.transpose();
    Eigen::MatrixXd S(m, m);  // (H P H^T)^T + R: symmetric
    row = 0;
    for (const ObservationBlock& block : blocks) {
        auto columns = S.middleCols(row, block.rows());
        columns.setZero();
        for (Eigen::Index k = 0; k < block.H.cols(); ++k) {
            const auto source = gain_by_row.col(block.columns[static_cast<size_t>(k)]);
            for (Eigen::Index r = 0; r < block.rows(); ++r)
                columns.col(r) += block.H(r, k) * source;
        }
        columns.middleRows(row, block.rows()).diagonal() += block.variance;
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

}  // namespace noctule
