// SPDX-License-Identifier: Apache-2.0
// The maximum a posteriori problem of one take: of all motions the one with the least
//
//   cost = 1/2 |x_0 - m_0|^2 / P_0 + 1/2 sum |x_k - f(x_k-1)|^2 / Q_k + 1/2 sum |y - h(x_k)|^2 / R
//
// with the filter's own models: m_0, P_0 as it started, f, Q its process, y, h, R the readings as it weighted
// them (DecidedStep). Gauss-Newton's step from a motion is the error that a smoother finds which is
// linearised about it (Bell, "The iterated Kalman smoother as a Gauss-Newton method", SIAM Journal on
// Optimization 4, 1994): here is that smoother's filter. Its mean is an error of the motion, in the order of
// StateLayout.
//
// Left out of derivatives: where flesh takes a board, and how a step's noise turns another's, which counts
// only where the filter had lost a limb and let it turn by tens of degrees at once. There joints may also
// turn independently that for the filter turned together.
#pragma once

#include <Eigen/Cholesky>

#include "core/estimation/decided_steps.h"

namespace noctule {

/// A step's two ends.
struct Leg {
    const BodyState &from, &to;
    double at_s = 0;  ///< of `to`
};

class MapProblem {
public:
    /// `filter` has been started: its memory is the prior. Keeps a reference.
    explicit MapProblem(ManifoldFilter& filter);

    double priorCost(const BodyState& first) const;
    double stepCost(const DecidedStep& step, const Leg& leg) const;

    struct Estimate {
        Eigen::VectorXd error;
        Covariance P;
    };
    Estimate prior(const BodyState& first) const;
    /// Carries an estimate over a step and its observations; what is done goes to `tape`, if given.
    void filterStep(const DecidedStep& step, const Leg& leg, Estimate& estimate, FilterTape* tape) const;
    /// How far `leg` is from following the process alone: what f(from) would add to `to`.
    Eigen::VectorXd defect(const Leg& leg) const;
    /// Q lambda, with everything by which the filter let the state change.
    Eigen::VectorXd noiseTimes(const DecidedStep& step, const Eigen::VectorXd& lambda) const;

private:
    Matrix3d motionNoiseOf(const DecidedStep& step, Eigen::Index coordinate) const;
    /// Added to the variances of all states, beside the motion's noise.
    Eigen::VectorXd otherNoise(const DecidedStep& step) const;

    ManifoldFilter& filter_;
    BodyState first_;
    Eigen::MatrixXd P_first_;
    Eigen::LLT<Eigen::MatrixXd> P_first_factor_;
};

}  // namespace noctule
