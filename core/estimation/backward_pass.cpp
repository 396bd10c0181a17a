// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/backward_pass.h"

#include "core/math/covariance_kernels.h"

namespace noctule {
namespace {

/// C += M H for the sparse H of blocks.
void addTimesBlocks(Eigen::MatrixXd& C, const Eigen::MatrixXd& M,
                    const std::vector<ObservationBlock>& blocks) {
    Eigen::Index row = 0;
    for (const ObservationBlock& block : blocks) {
        addTimesSparse(C, M, row, block.columns, block.H);
        row += block.rows();
    }
}

/// x H^T.
Eigen::MatrixXd timesTransposed(const Eigen::MatrixXd& x, const std::vector<ObservationBlock>& blocks,
                                Eigen::Index rows) {
    Eigen::MatrixXd product(x.rows(), rows);
    Eigen::Index row = 0;
    for (const ObservationBlock& block : blocks) {
        multiplySparse(x, block.columns, block.H, product, row);
        row += block.rows();
    }
    return product;
}

Eigen::MatrixXd product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
    Eigen::MatrixXd C = Eigen::MatrixXd::Zero(A.rows(), B.cols());
    addProduct(C, 1, A, B);
    return C;
}

}  // namespace

/// With H' = L^-1 H and K = x^T L^-1:
///   lambda := (I - K H)^T lambda - H^T S^-1 residual = lambda - H'^T (x lambda + residual')
void AdjointPass::back(const ObservedUpdate& update) {
    if (update.blocks.empty())
        return;
    const Eigen::MatrixXd pull =
        -(update.inverse_L.transpose() * (update.x * lambda_ + update.residual)).transpose();
    Eigen::MatrixXd lambda_transposed = lambda_.transpose();
    addTimesBlocks(lambda_transposed, pull, update.blocks);
    lambda_ = lambda_transposed.transpose();
}

/// With H' = L^-1 H and K = x^T L^-1:
///   Lambda := (I - K H)^T Lambda (I - K H) + H^T S^-1 H
///           = Lambda + H^T B + B^T H,   B = L^-T (1/2 (x Lambda x^T + I) H' - x Lambda)
void BackwardPass::back(const ObservedUpdate& update) {
    if (update.blocks.empty())
        return;
    const Eigen::MatrixXd inverse_L_transposed = update.inverse_L.transpose();
    const Eigen::MatrixXd x_Lambda = timesLambda(update.x);
    Eigen::MatrixXd among = product(x_Lambda, update.x.transpose());
    among.diagonal().array() += 1;
    const Eigen::MatrixXd half =
        0.5 * product(product(inverse_L_transposed, among), update.inverse_L);  // symmetric
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(half.rows(), Lambda_.cols());
    addTimesBlocks(B, half, update.blocks);
    addProduct(B, -1, inverse_L_transposed, x_Lambda);
    pending_.push_back({update.blocks, std::move(B)});
    adjoint_.back(update);
}

Eigen::MatrixXd BackwardPass::timesLambda(const Eigen::MatrixXd& x) const {
    Eigen::MatrixXd result = product(x, Lambda_);
    for (const Pending& change : pending_) {
        addTimesBlocks(result, product(x, change.B.transpose()), change.blocks);
        addProduct(result, 1, timesTransposed(x, change.blocks, change.B.rows()), change.B);
    }
    return result;
}

void BackwardPass::carryOutPending() {
    if (pending_.empty())
        return;
    changes_.setZero(Lambda_.rows(), Lambda_.cols());
    for (const Pending& change : pending_)
        addTimesBlocks(changes_, change.B.transpose(), change.blocks);
    addWithTranspose(Lambda_, changes_);
    pending_.clear();
}

BackwardPass::Smoothed BackwardPass::smooth(const Eigen::MatrixXd& P_rows) {
    carryOutPending();
    const Eigen::MatrixXd through = product(P_rows, Lambda_);
    return {-(P_rows * adjoint_.lambda()),
            P_rows.leftCols(P_rows.rows()) - product(through, P_rows.transpose())};
}

}  // namespace noctule
