// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/covariance.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <utility>

namespace noctule {
namespace {

Eigen::Index rowsOf(const std::vector<ObservationBlock>& blocks) {
    Eigen::Index rows = 0;
    for (const ObservationBlock& block : blocks)
        rows += block.rows();
    return rows;
}

Eigen::VectorXd residualOf(const std::vector<ObservationBlock>& blocks, Eigen::Index rows) {
    Eigen::VectorXd residual(rows);
    Eigen::Index row = 0;
    for (const ObservationBlock& block : blocks) {
        residual.segment(row, block.rows()) = block.residual;
        row += block.rows();
    }
    return residual;
}

}  // namespace

Eigen::MatrixXd& Covariance::dense() {
    if (hasPending())
        subtractOuterProduct(P_, pending());
    pending_rows_ = 0;
    foresight_.count = 0;
    return P_;
}

void Covariance::timesPending(const ObservationBlock& block, MatrixOut seen, Eigen::Index first) const {
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic> product(pending_rows_, block.rows());
    multiplySparse(pending(), block.columns, block.H, product, 0);
    seen.middleRows(first, block.rows()) = product.transpose();
}

const Eigen::MatrixXd* Covariance::foreseen(const ObservationBlock& block) const {
    const auto end = foresight_.blocks.begin() + static_cast<std::ptrdiff_t>(foresight_.count);
    const auto found = std::find_if(foresight_.blocks.begin(), end, [&](const Foreseen& seen) {
        return seen.columns == block.columns && seen.H.rows() == block.H.rows() && seen.H == block.H;
    });
    return found == end ? nullptr : &found->P_H;
}

const Eigen::MatrixXd& Covariance::foresee(const ObservationBlock& block) const {
    if (const Eigen::MatrixXd* P_H = foreseen(block))
        return *P_H;
    if (foresight_.count == foresight_.blocks.size())
        foresight_.blocks.emplace_back();
    Foreseen& seen = foresight_.blocks[foresight_.count++];
    seen.columns = block.columns;
    seen.H = block.H;
    seen.P_H.resize(P_.rows(), block.rows());
    multiplySparse(P_, block.columns, block.H, seen.P_H, 0);
    return seen.P_H;
}

Eigen::VectorXd Covariance::innovationVariance(const ObservationBlock& block) const {
    const Eigen::MatrixXd& P_H = foresee(block);
    Eigen::VectorXd variance = block.variance;
    for (size_t k = 0; k < block.columns.size(); ++k)
        variance +=
            P_H.row(block.columns[k]).transpose().cwiseProduct(block.H.col(static_cast<Eigen::Index>(k)));
    if (hasPending()) {
        auto seen = seen_.shaped(block.rows(), pending_rows_);
        timesPending(block, seen, 0);
        variance -= seen.rowwise().squaredNorm();
    }
    return variance;
}

Eigen::MatrixXd Covariance::innovationCovariance(const Blocks& blocks, MatrixOut gain) const {
    const Eigen::Index m = gain.rows();
    auto columns = gain_columns_.shaped(P_.rows(), m);  // P H^T
    auto seen = seen_.shaped(m, pending_rows_);
    Eigen::Index row = 0;
    for (const ObservationBlock& block : blocks) {
        if (const Eigen::MatrixXd* P_H = foreseen(block))
            columns.middleCols(row, block.rows()) = *P_H;
        else
            multiplySparse(P_, block.columns, block.H, columns, row);
        if (hasPending())
            timesPending(block, seen, row);
        row += block.rows();
    }
    gain = columns.transpose();
    if (hasPending())
        addProduct(gain, -1, seen, pending());

    Eigen::MatrixXd S(m, m);  // built as its transpose: it is symmetric
    row = 0;
    for (const ObservationBlock& block : blocks) {
        multiplySparse(gain, block.columns, block.H, S, row);
        S.diagonal().segment(row, block.rows()) += block.variance;
        row += block.rows();
    }
    return S;
}

void Covariance::reservePending(Eigen::Index m) {
    constexpr Eigen::Index kMore = 64;
    if (pending_.cols() != P_.cols()) {
        pending_.resize(m + kMore, P_.cols());
    } else if (pending_.rows() < pending_rows_ + m) {
        pending_.conservativeResize(pending_rows_ + m + kMore, Eigen::NoChange);
    }
}

Eigen::VectorXd Covariance::update(const std::vector<ObservationBlock>& blocks, ObservedUpdate* observed) {
    const Eigen::Index m = rowsOf(blocks), n = P_.rows();
    if (m == 0)
        return Eigen::VectorXd::Zero(n);
    auto gain = gain_.shaped(m, n);
    const Eigen::LLT<Eigen::MatrixXd> factor(innovationCovariance(blocks, gain));
    if (factor.info() != Eigen::Success)
        return Eigen::VectorXd::Zero(n);
    Eigen::MatrixXd inverse_L = factor.matrixL();
    invertLowerTriangle(inverse_L);
    const Eigen::VectorXd whitened = inverse_L * residualOf(blocks, m);

    reservePending(m);
    auto x = pending_.middleRows(pending_rows_, m);  // X^T = L^-1 H P
    x.setZero();
    addProduct(x, 1, inverse_L, gain, Shape::kLowerTriangular);
    pending_rows_ += m;
    const Eigen::VectorXd correction = x.transpose() * whitened;
    if (observed)
        *observed = {blocks, std::move(inverse_L), x, whitened};
    return correction;
}

}  // namespace noctule
