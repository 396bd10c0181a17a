// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/joint_covariance.h"

#include <Eigen/Cholesky>

#include "core/math/covariance_kernels.h"

namespace noctule {
namespace {

/// C := C A^T for what a filter did to its errors, error := A error.
void timesStep(Eigen::MatrixXd& C, const LinkTransitions& step) {
    step.timesTransposed(C);
}
void timesStep(Eigen::MatrixXd& C, const HeadingShift& shift) {
    shift.timesTransposed(C);
}
/// A = I - K H, K = x^T L^-1.
void timesStep(Eigen::MatrixXd& C, const ObservedUpdate& update) {
    const Eigen::Index m = update.x.rows();
    if (m == 0 || update.blocks.empty())
        return;
    Eigen::MatrixXd C_H(C.rows(), m);
    Eigen::Index row = 0;
    for (const ObservationBlock& block : update.blocks) {
        multiplySparse(C, block.columns, block.H, C_H, row);
        row += block.rows();
    }
    const Eigen::MatrixXd whitened = C_H * update.inverse_L.transpose().triangularView<Eigen::Upper>();
    addProduct(C, -1, whitened, update.x);
}
void timesStep(Eigen::MatrixXd&, const TapedFrame&) {}
void timesStep(Eigen::MatrixXd&, const Widening&) {}

}  // namespace

JointCovariance::JointCovariance(std::vector<ManifoldFilter*> bodies, const Eigen::VectorXd& common_variance)
    : bodies_(std::move(bodies)), common_(common_variance.asDiagonal()) {
    cross_.resize(members());
    for (size_t i = 0; i < members(); ++i)
        for (size_t k = 0; k < members(); ++k)
            cross_[i].push_back(i == k ? Eigen::MatrixXd()
                                       : Eigen::MatrixXd::Zero(own(i).rows(), own(k).rows()));
}

const Eigen::MatrixXd& JointCovariance::own(size_t member) const {
    return member < bodies_.size() ? bodies_[member]->covariance() : common_;
}

void JointCovariance::mirror(size_t member) {
    for (size_t k = 0; k < members(); ++k)
        if (k != member)
            cross_[member][k] = cross_[k][member].transpose();
}

void JointCovariance::carry(size_t body, const FilterTape& tape) {
    for (size_t k = 0; k < members(); ++k)
        if (k != body && cross_[k][body].rows() > 0)
            for (const auto& event : tape)
                std::visit([&](const auto& what) { timesStep(cross_[k][body], what); }, event);
    mirror(body);
}

void JointCovariance::carryCommon(const Eigen::MatrixXd& F, const Eigen::VectorXd& noise) {
    if (common_.rows() == 0)
        return;
    common_ = (F * common_ * F.transpose()).eval();
    common_.diagonal() += noise;
    const size_t common = bodies_.size();
    for (size_t k = 0; k < common; ++k)
        cross_[k][common] = (cross_[k][common] * F.transpose()).eval();
    mirror(common);
}

Eigen::MatrixXd JointCovariance::seenBy(size_t member, const std::vector<JointRow>& rows) const {
    Eigen::MatrixXd seen = Eigen::MatrixXd::Zero(own(member).rows(), std::ssize(rows));
    Eigen::MatrixXd one(seen.rows(), 1);
    for (size_t r = 0; r < rows.size() && seen.rows() > 0; ++r)
        for (size_t k = 0; k < members(); ++k) {
            const ObservationBlock& block = rows[r].of[k];
            if (block.columns.empty())
                continue;
            multiplySparse(k == member ? own(member) : cross_[member][k], block.columns, block.H, one, 0);
            seen.col(static_cast<Eigen::Index>(r)) += one;
        }
    return seen;
}

Eigen::MatrixXd JointCovariance::expected(const std::vector<JointRow>& rows,
                                          const std::vector<Eigen::MatrixXd>& seen) const {
    const Eigen::Index m = std::ssize(rows);
    Eigen::MatrixXd HPH = Eigen::MatrixXd::Zero(m, m);
    for (Eigen::Index r = 0; r < m; ++r) {
        const JointRow& row = rows[static_cast<size_t>(r)];
        for (size_t k = 0; k < members(); ++k)
            for (size_t c = 0; c < row.of[k].columns.size(); ++c)
                HPH.col(r) += row.of[k].H(0, static_cast<Eigen::Index>(c)) *
                              seen[k].row(row.of[k].columns[c]).transpose();
    }
    return HPH;
}

Eigen::MatrixXd JointCovariance::of(const std::vector<JointRow>& rows) const {
    std::vector<Eigen::MatrixXd> seen;
    for (size_t k = 0; k < members(); ++k)
        seen.push_back(seenBy(k, rows));
    return expected(rows, seen);
}

Eigen::VectorXd JointCovariance::update(std::vector<JointRow> rows, const Judge& judge) {
    Eigen::VectorXd correction = Eigen::VectorXd::Zero(common_.rows());
    if (rows.empty())
        return correction;
    std::vector<Eigen::MatrixXd> seen;
    for (size_t k = 0; k < members(); ++k)
        seen.push_back(seenBy(k, rows));
    Eigen::MatrixXd S = expected(rows, seen);
    if (judge) {
        const std::vector<Eigen::Index> kept = judge(S, rows);
        std::vector<JointRow> used;
        for (const Eigen::Index row : kept)
            used.push_back(std::move(rows[static_cast<size_t>(row)]));
        rows = std::move(used);
        S = S(kept, kept).eval();
        for (Eigen::MatrixXd& columns : seen)
            columns = columns(Eigen::all, kept).eval();
    }
    const Eigen::Index m = std::ssize(rows);
    if (m == 0)
        return correction;
    for (Eigen::Index r = 0; r < m; ++r)
        S(r, r) += rows[static_cast<size_t>(r)].variance;
    const Eigen::LLT<Eigen::MatrixXd> factor(S);
    if (factor.info() != Eigen::Success)
        return correction;
    Eigen::VectorXd whitened(m);
    for (Eigen::Index r = 0; r < m; ++r)
        whitened[r] = rows[static_cast<size_t>(r)].residual;
    factor.matrixL().solveInPlace(whitened);
    std::vector<Eigen::MatrixXd> x;  // L^-1 H P
    for (size_t k = 0; k < members(); ++k)
        x.push_back(factor.matrixL().solve(seen[k].transpose()));
    for (size_t k = 0; k < members(); ++k)
        for (size_t i = k + 1; i < members(); ++i) {
            if (cross_[k][i].size() > 0)
                addProduct(cross_[k][i], -1, x[k].transpose(), x[i]);
            cross_[i][k] = cross_[k][i].transpose();
        }
    for (size_t k = 0; k < bodies_.size(); ++k)
        bodies_[k]->conditionJointly(x[k], x[k].transpose() * whitened);
    if (common_.rows() > 0) {
        common_ -= (x.back().transpose() * x.back()).eval();
        correction = x.back().transpose() * whitened;
    }
    return correction;
}

}  // namespace noctule
