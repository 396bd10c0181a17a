// SPDX-License-Identifier: Apache-2.0
// Levenberg-Marquardt inside a box, for the handful of variables of a robot's chain. Variables at a bound
// are held out of a step that would push them outwards; the step is clipped to the box and kept only when
// the cost falls. After Levenberg 1944, Marquardt 1963 and the active set of Bertsekas 1982.
#pragma once

#include <Eigen/Cholesky>
#include <algorithm>

#include "core/robot/chain.h"

namespace noctule::robot {

using NormalMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostChainJoints, kMostChainJoints>;

/// Half the sum of squares at one place, its gradient and the Gauss-Newton Hessian.
struct LinearisedCost {
    double cost = 0;
    JointVector gradient;
    NormalMatrix hessian;

    void clear(int size) {
        cost = 0;
        gradient.setZero(size);
        hessian.setZero(size, size);
    }
    /// Adds weight * |residual|^2 / 2.
    template <class Residual, class Jacobian>
    void add(double weight, const Residual& residual, const Jacobian& J) {
        cost += weight * residual.squaredNorm() / 2;
        gradient.noalias() += weight * (J.transpose() * residual);
        hessian.noalias() += weight * (J.transpose() * J);
    }
};

struct BoxedSolve {
    int most_iterations = 6;
    double smallest_drop = 1e-6;  ///< relative fall of the cost below which it ends
    double damping = 1e-6;        ///< of the first step, relative to the Hessian's diagonal
};

struct BoxedReport {
    double cost = 0;
    int iterations = 0;  ///< linearisations
};

namespace detail {

/// Step of the free variables; those that a bound holds stay at 0.
inline JointVector boxedStep(const LinearisedCost& at, const JointVector& q, const JointVector& lower,
                             const JointVector& upper, double damping) {
    NormalMatrix A = at.hessian;
    JointVector g = at.gradient;
    for (Eigen::Index i = 0; i < q.size(); ++i) {
        if ((q[i] <= lower[i] && g[i] > 0) || (q[i] >= upper[i] && g[i] < 0)) {
            A.row(i).setZero();
            A.col(i).setZero();
            A(i, i) = 1;
            g[i] = 0;
        } else {
            A(i, i) += damping * A(i, i) + 1e-12;
        }
    }
    return -A.llt().solve(g);
}

}  // namespace detail

/// `linearise(q, LinearisedCost&)`; `q` begins inside the box and ends there. `done(cost)` ends it early.
template <class Linearise, class DoneAt>
BoxedReport solveInBox(Linearise& linearise, const JointVector& lower, const JointVector& upper,
                       const BoxedSolve& settings, JointVector& q, const DoneAt& done) {
    LinearisedCost now, next;
    linearise(q, now);
    BoxedReport report{now.cost, 1};
    double damping = settings.damping;
    while (report.iterations < settings.most_iterations && !done(now.cost)) {
        const JointVector step = detail::boxedStep(now, q, lower, upper, damping);
        const JointVector tried = (q + step).cwiseMax(lower).cwiseMin(upper);
        linearise(tried, next);
        ++report.iterations;
        if (next.cost < now.cost) {
            const double drop = (now.cost - next.cost) / now.cost;
            q = tried;
            std::swap(now, next);
            damping = std::max(damping * 0.2, 1e-9);
            if (drop < settings.smallest_drop)
                break;
        } else {
            if ((tried - q).norm() < 1e-12 || damping > 1e6)
                break;
            damping = std::max(damping * 8, 1e-4);
        }
    }
    report.cost = now.cost;
    return report;
}

}  // namespace noctule::robot
