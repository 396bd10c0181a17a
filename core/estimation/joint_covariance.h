// SPDX-License-Identifier: Apache-2.0
// What ties the estimates of several bodies together: the covariances between their error states, and a
// common state that belongs to none of them (clocks, anchors of the room).
//
// Each body keeps its own filter and covariance. Its own readings correct only itself: the gain of the
// others is zero, they are consider states (Schmidt 1966). Covariances between bodies follow exactly, so the
// whole stays honest; what is lost is that a body's inertia hardly tells of another body. Readings that
// concern several (ranges between them and to the room) correct all of them with the full gain.
#pragma once

#include <functional>
#include <vector>

#include "core/estimation/manifold_filter.h"

namespace noctule {

/// One reading that concerns several states. `of` has one block of one row per body and then one of the
/// common state; without columns where it says nothing.
struct JointRow {
    std::vector<ObservationBlock> of;
    double residual = 0, variance = 0;
};

class JointCovariance {
public:
    JointCovariance() = default;
    /// Bodies that know nothing of each other yet, and the common state's variances.
    JointCovariance(std::vector<ManifoldFilter*> bodies, const Eigen::VectorXd& common_variance);

    /// Follows what one body's filter did by itself; frames and widenings on the tape change nothing here.
    void carry(size_t body, const FilterTape& tape);
    /// The common state's step: x := F x with noise of these variances.
    void carryCommon(const Eigen::MatrixXd& F, const Eigen::VectorXd& noise);

    /// Is given H P H^T of all rows; may raise their variances; returns the indices of those to be used.
    using Judge = std::function<std::vector<Eigen::Index>(const Eigen::MatrixXd&, std::vector<JointRow>&)>;
    /// Corrects every body and returns the common state's correction. Zero, and nothing changed, when the
    /// innovation's covariance is not positive definite.
    Eigen::VectorXd update(std::vector<JointRow> rows, const Judge& judge = {});

    /// H P H^T: covariance of what the rows speak of.
    Eigen::MatrixXd of(const std::vector<JointRow>& rows) const;

    const Eigen::MatrixXd& common() const { return common_; }
    /// Of the errors of a body (rows) with those of another one (columns); one past the last body: the common
    /// state.
    const Eigen::MatrixXd& between(size_t one, size_t other) const { return cross_[one][other]; }
    Eigen::MatrixXd& between(size_t one, size_t other) { return cross_[one][other]; }

private:
    const Eigen::MatrixXd& own(size_t member) const;
    /// P H^T of all rows, for one member: its size x rows.
    Eigen::MatrixXd seenBy(size_t member, const std::vector<JointRow>& rows) const;
    /// H P H^T.
    Eigen::MatrixXd expected(const std::vector<JointRow>& rows,
                             const std::vector<Eigen::MatrixXd>& seen) const;
    void mirror(size_t member);
    size_t members() const { return bodies_.size() + 1; }

    std::vector<ManifoldFilter*> bodies_;
    Eigen::MatrixXd common_;
    std::vector<std::vector<Eigen::MatrixXd>> cross_;  ///< both triangles; the diagonal is empty
};

}  // namespace noctule
