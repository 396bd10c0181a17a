// SPDX-License-Identifier: Apache-2.0
// The covariance of an error state and the Kalman observation step on it (Vlasic 2007, equations 7 to 9), for
// many measurements with sparse Jacobians at one linearisation.
//
// An update subtracts X X^T from the matrix, which costs a pass over all of it. The subtraction is put off
// and the next observation step of the same instant takes it into account; dense() carries out what is
// pending in one pass. The result is that of the plain formula.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/estimation/observation.h"
#include "core/math/covariance_kernels.h"
#include "core/math/matrix_buffer.h"

namespace noctule {

/// One observation step as it was carried out, whitened by S = H P H^T + R = L L^T: all that a smoother
/// needs.
struct ObservedUpdate {
    std::vector<ObservationBlock> blocks;  ///< H, of m rows in all
    Eigen::MatrixXd inverse_L;             ///< m x m, lower triangular
    Eigen::MatrixXd x;                     ///< L^-1 H P, m x n
    Eigen::VectorXd residual;              ///< L^-1 (measured - expected)
};

class Covariance {
public:
    Covariance() = default;
    /// Diagonal from variances.
    explicit Covariance(const Eigen::VectorXd& variances) : P_(variances.asDiagonal()) {}

    /// The matrix itself (n x n, symmetric, both triangles), up to date; may be changed.
    Eigen::MatrixXd& dense();
    const Eigen::MatrixXd& dense() const { return const_cast<Covariance*>(this)->dense(); }

    /// Variance of the innovation of each row of a block: H P H^T + R on the diagonal.
    Eigen::VectorXd innovationVariance(const ObservationBlock& block) const;

    /// Observes; returns the error state's correction K * residual. Zero, and nothing changed, when nothing
    /// is observed or the innovation's covariance is not positive definite.
    Eigen::VectorXd update(const std::vector<ObservationBlock>& blocks) { return update(blocks, nullptr); }
    /// The same; `observed`, if given, then holds the step, with no blocks when nothing was changed.
    Eigen::VectorXd update(const std::vector<ObservationBlock>& blocks, ObservedUpdate* observed);

private:
    using Blocks = std::vector<ObservationBlock>;

    bool hasPending() const { return pending_rows_ > 0; }
    /// X^T of what is pending, m x n.
    auto pending() const { return pending_.topRows(pending_rows_); }
    /// P_ H^T of a block that was asked about since P_ may have changed, as most are before they are
    /// observed; foreseen() is null for others.
    const Eigen::MatrixXd* foreseen(const ObservationBlock& block) const;
    const Eigen::MatrixXd& foresee(const ObservationBlock& block) const;
    /// H times the pending X, rows x pending, into rows `first`.. of `seen`.
    void timesPending(const ObservationBlock& block, MatrixOut seen, Eigen::Index first) const;
    /// H P H^T + R of all blocks and, as `gain`, H P (m x n), with what is pending.
    Eigen::MatrixXd innovationCovariance(const Blocks& blocks, MatrixOut gain) const;
    /// Makes room for m more rows of X^T below those pending.
    void reservePending(Eigen::Index m);

    Eigen::MatrixXd P_;
    Eigen::MatrixXd pending_;  ///< X^T in its first rows: true covariance = P_ - X X^T
    Eigen::Index pending_rows_ = 0;
    struct Foreseen {
        std::vector<int> columns;
        Eigen::MatrixXd H, P_H;
    };
    /// A copy has foreseen nothing.
    struct Foresight {
        Foresight() = default;
        Foresight(const Foresight&) {}
        Foresight& operator=(const Foresight&) {
            count = 0;
            return *this;
        }
        std::vector<Foreseen> blocks;  ///< the first `count`; the others are room for more
        size_t count = 0;
    };
    mutable Foresight foresight_;
    mutable MatrixBuffer gain_columns_, gain_, seen_;  ///< room for the next update's work
};

}  // namespace noctule
