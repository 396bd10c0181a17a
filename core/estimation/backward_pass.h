// SPDX-License-Identifier: Apache-2.0
// The smoother of Bryson and Frazier in its modified form (Bierman, "Fixed interval smoothing with discrete
// measurements", 1973): what later measurements say of the error at an instant, gathered going back in time
// as an adjoint lambda (n) with its information Lambda (n x n). It gives the same as Rauch, Tung and
// Striebel's without inverting a covariance, so states without noise, gates and widened covariances need no
// care.
//
//   smoothed error = -P lambda,   smoothed covariance = P - P Lambda P
//
// with the filter's P of that instant. Errors are those of the filter's estimate then; over its corrections
// the filter carries P as its shifts say, otherwise unchanged, and so are lambda and Lambda.
#pragma once

#include <vector>

#include "core/estimation/covariance.h"
#include "core/estimation/heading_shift.h"
#include "core/math/transition_kernels.h"

namespace noctule {

/// The adjoint alone, at a small share of the cost.
class AdjointPass {
public:
    AdjointPass() = default;
    /// After the last measurement: nothing is known from later.
    explicit AdjointPass(Eigen::Index n) : lambda_(Eigen::VectorXd::Zero(n)) {}

    /// To before a step or a shift, to before the observation.
    template <class Carrying>
    void back(const Carrying& carrying) {
        carrying.carryBack(lambda_);
    }
    void back(const ObservedUpdate& update);
    const Eigen::VectorXd& lambda() const { return lambda_; }

private:
    Eigen::VectorXd lambda_;
};

class BackwardPass {
public:
    BackwardPass() = default;
    explicit BackwardPass(Eigen::Index n) : adjoint_(n), Lambda_(Eigen::MatrixXd::Zero(n, n)) {}

    /// To before a step or a shift, to before the observation.
    template <class Carrying>
    void back(const Carrying& carrying) {
        carryOutPending();
        adjoint_.back(carrying);
        carrying.carryBack(Lambda_);
    }
    void back(const ObservedUpdate& update);

    struct Smoothed {
        Eigen::VectorXd error;       ///< to add to the filter's estimate
        Eigen::MatrixXd covariance;  ///< of what then remains
    };
    /// Of the leading states, whose rows of the filter's covariance are `P_rows` (any number x n).
    Smoothed smooth(const Eigen::MatrixXd& P_rows);

private:
    /// x (anything x n) times Lambda, what is pending included.
    Eigen::MatrixXd timesLambda(const Eigen::MatrixXd& x) const;
    void carryOutPending();

    AdjointPass adjoint_;
    Eigen::MatrixXd Lambda_;
    /// Changes of one instant, put off because each costs a pass over Lambda: + H^T B + B^T H.
    struct Pending {
        std::vector<ObservationBlock> blocks;  ///< H
        Eigen::MatrixXd B;
    };
    std::vector<Pending> pending_;
    Eigen::MatrixXd changes_;  ///< room for their sum
};

}  // namespace noctule
