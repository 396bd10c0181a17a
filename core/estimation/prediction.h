// SPDX-License-Identifier: Apache-2.0
// The time step of a filter whose error state begins with coordinates, rates and accelerations of a tree.
#pragma once

#include <vector>

#include "core/body/kinematics.h"
#include "core/math/transition_kernels.h"

namespace noctule {

/// The linear part of one time step: how errors of coordinates, rates and accelerations are carried along. It
/// mixes nothing between links; what else is in the error state stays as it is.
class MotionTransition {
public:
    /// `motion` as it is before the step.
    MotionTransition(const KinematicTree& tree, const MotionState& motion, double dt_s,
                     const Eigen::VectorXd& decay);

    /// P := F P F^T, error := F error.
    void carry(Eigen::MatrixXd& P) const;
    void carry(Eigen::VectorXd& error) const { carryColumn(error.data()); }
    /// The adjoint, against time: lambda := F^T lambda, Lambda := F^T Lambda F.
    void carryBack(Eigen::VectorXd& lambda) const;
    void carryBack(Eigen::MatrixXd& Lambda) const;

private:
    /// x := F x and x := F^T x for one column.
    void carryColumn(double* x) const;
    void carryColumnBack(double* x) const;
    /// Both sides of a symmetric matrix, one link's columns at a time: the matrix is as large as a
    /// processor's cache, and each pass over it costs as much as the arithmetic.
    template <class Column, class Mix>
    void bothSides(Eigen::MatrixXd& matrix, const Column& column, const Mix& mix) const;

    Eigen::Index n_ = 0;  ///< coordinates
    double dt_ = 0;
    Eigen::VectorXd decay_;
    std::vector<LinkTransition> links_;  ///< rotations by three, all else coordinate by coordinate
};

/// What a step adds to the covariance of one coordinate, its rate and its acceleration: white jerk of a
/// density that keeps the stationary `variance` of an acceleration that decays by `decay`.
Matrix3d motionNoise(double dt_s, double decay, double variance);

/// The state alone over dt_s.
void predictMotion(const KinematicTree& tree, MotionState& motion, double dt_s, const Eigen::VectorXd& decay);

/// Carries the state and its covariance P (coordinates, rates, accelerations first; the rest is constant)
/// over dt_s: accelerations decay by `decay` per step towards zero and keep the stationary variance
/// `acceleration_variance` (both per velocity index); coordinates and rates follow with accelerations held.
MotionTransition predictMotion(const KinematicTree& tree, MotionState& motion, Eigen::MatrixXd& P,
                               double dt_s, const Eigen::VectorXd& decay,
                               const Eigen::VectorXd& acceleration_variance);

/// Standard deviation (rad, right perturbation, 3 per joint) of every joint's rotation from the leading
/// coordinates' covariance; zero for a fixed joint. `flesh_rad2` is added where a joint moves: how far boards
/// turn against their bones.
std::vector<double> jointSigmas(const KinematicTree& tree, const Skeleton& skeleton,
                                const MotionState& motion, const Eigen::MatrixXd& P, double flesh_rad2 = 0);

}  // namespace noctule
