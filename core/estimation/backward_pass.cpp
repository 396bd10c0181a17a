// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/backward_pass.h"

#include "core/math/covariance_kernels.h"

namespace noctule {
namespace {

/// M H for the sparse H (m x n) of blocks.
Eigen::MatrixXd timesBlocks(const Eigen::MatrixXd& M, const std::vector<ObservationBlock>& blocks,
                            Eigen::Index n) {
    Eigen::MatrixXd product = Eigen::MatrixXd::Zero(M.rows(), n);
    Eigen::Index row = 0;
    for (const ObservationBlock& block : blocks) {
        for (Eigen::Index k = 0; k < block.H.cols(); ++k)
            product.col(block.columns[static_cast<size_t>(k)]).noalias() +=
                M.middleCols(row, block.rows()) * block.H.col(k);
        row += block.rows();
    }
    return product;
}

}  // namespace

void BackwardPass::back(const MotionTransition& transition) {
    transition.carryBack(lambda_);
    transition.carryBack(Lambda_);
}

/// With H' = L^-1 H and K = x^T L^-1:
///   lambda := (I - K H)^T lambda - H^T S^-1 residual = lambda - H'^T (x lambda + residual')
///   Lambda := (I - K H)^T Lambda (I - K H) + H^T S^-1 H
///           = Lambda + H^T B + B^T H,   B = L^-T (1/2 (x Lambda x^T + I) H' - x Lambda)
void BackwardPass::back(const ObservedUpdate& update) {
    if (update.blocks.empty())
        return;
    const Eigen::Index n = lambda_.size();
    const auto inverse_L_transposed = update.inverse_L.transpose().triangularView<Eigen::Upper>();
    const Eigen::VectorXd pull = inverse_L_transposed * (update.x * lambda_ + update.residual);
    const Eigen::MatrixXd x_Lambda = update.x * Lambda_;
    Eigen::MatrixXd among = x_Lambda * update.x.transpose();
    among.diagonal().array() += 1;
    const Eigen::MatrixXd whitened = inverse_L_transposed * among;
    const Eigen::MatrixXd half =
        0.5 * (whitened * update.inverse_L.triangularView<Eigen::Lower>());  // symmetric
    Eigen::MatrixXd B = timesBlocks(half, update.blocks, n);
    B -= inverse_L_transposed * x_Lambda;
    const Eigen::MatrixXd B_transposed = B.transpose();
    const Eigen::MatrixXd change = timesBlocks(B_transposed, update.blocks, n);
    Lambda_ += change;
    Lambda_ += change.transpose();
    lambda_ -= timesBlocks(pull.transpose(), update.blocks, n).transpose();
}

BackwardPass::Smoothed BackwardPass::smooth(const Eigen::MatrixXd& P_rows) const {
    const Eigen::MatrixXd through = P_rows * Lambda_;
    return {-(P_rows * lambda_), P_rows.leftCols(P_rows.rows()) - through * P_rows.transpose()};
}

}  // namespace noctule
