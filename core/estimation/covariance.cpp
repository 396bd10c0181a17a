// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/covariance.h"

#include <Eigen/Cholesky>
#include <numeric>
#include <utility>

#include "core/math/covariance_kernels.h"

namespace noctule {

Eigen::MatrixXd& Covariance::dense() {
    if (pending_.rows() > 0) {
        subtractOuterProduct(P_, pending_);
        pending_.resize(0, P_.cols());
    }
    return P_;
}

Eigen::MatrixXd Covariance::timesPending(const ObservationBlock& block) const {
    Eigen::MatrixXd product(pending_.rows(), block.rows());
    multiplySparse(pending_, block.columns, block.H, product, 0);
    return product.transpose();
}

Eigen::VectorXd Covariance::innovationVariance(const ObservationBlock& block) const {
    const Eigen::Index count = block.H.cols();
    Eigen::MatrixXd P_seen(count, count);
    for (Eigen::Index j = 0; j < count; ++j) {
        const double* column = P_.col(block.columns[static_cast<size_t>(j)]).data();
        for (Eigen::Index i = 0; i < count; ++i)
            P_seen(i, j) = column[block.columns[static_cast<size_t>(i)]];
    }
    std::vector<int> all(static_cast<size_t>(count));
    std::iota(all.begin(), all.end(), 0);
    Eigen::MatrixXd P_H(count, block.rows());
    multiplySparse(P_seen, all, block.H, P_H, 0);
    Eigen::VectorXd variance = block.variance + P_H.transpose().cwiseProduct(block.H).rowwise().sum();
    if (pending_.rows() > 0)
        variance -= timesPending(block).rowwise().squaredNorm();
    return variance;
}

Eigen::VectorXd Covariance::update(const std::vector<ObservationBlock>& blocks, ObservedUpdate* observed) {
    const Eigen::Index n = P_.rows();
    Eigen::Index m = 0;
    for (const ObservationBlock& block : blocks)
        m += block.rows();
    if (m == 0)
        return Eigen::VectorXd::Zero(n);

    Eigen::MatrixXd gain(n, m);  // P H^T
    Eigen::MatrixXd seen(m, pending_.rows());
    Eigen::VectorXd residual(m);
    Eigen::Index row = 0;
    for (const ObservationBlock& block : blocks) {
        multiplySparse(P_, block.columns, block.H, gain, row);
        if (pending_.rows() > 0)
            seen.middleRows(row, block.rows()) = timesPending(block);
        residual.segment(row, block.rows()) = block.residual;
        row += block.rows();
    }
    Eigen::MatrixXd gain_by_row = gain.transpose();
    if (pending_.rows() > 0)
        addProduct(gain_by_row, -1, seen, pending_);

    Eigen::MatrixXd S(m, m);  // H P H^T + R, built as its transpose: it is symmetric
    row = 0;
    for (const ObservationBlock& block : blocks) {
        multiplySparse(gain_by_row, block.columns, block.H, S, row);
        S.diagonal().segment(row, block.rows()) += block.variance;
        row += block.rows();
    }
    const Eigen::LLT<Eigen::MatrixXd> factor(S);
    if (factor.info() != Eigen::Success)
        return Eigen::VectorXd::Zero(n);
    Eigen::MatrixXd inverse_L = factor.matrixL().solve(Eigen::MatrixXd::Identity(m, m));
    const Eigen::VectorXd whitened = inverse_L * residual;
    Eigen::MatrixXd x = Eigen::MatrixXd::Zero(m, n);  // X^T = L^-1 H P
    addProduct(x, 1, inverse_L, gain_by_row, Shape::kLowerTriangular);

    Eigen::MatrixXd all(pending_.rows() + m, n);
    if (pending_.rows() > 0)
        all.topRows(pending_.rows()) = pending_;
    all.bottomRows(m) = x;
    pending_ = std::move(all);
    const Eigen::VectorXd correction = x.transpose() * whitened;
    if (observed)
        *observed = {blocks, inverse_L, std::move(x), whitened};
    return correction;
}

}  // namespace noctule
