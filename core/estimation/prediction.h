// SPDX-License-Identifier: Apache-2.0
// The time step of a filter whose error state begins with coordinates, rates and accelerations of a tree.
#pragma once

#include <vector>

#include "core/body/kinematics.h"
#include "core/math/transition_kernels.h"

namespace noctule {

/// The linear part of one time step: how errors of coordinates, rates and accelerations are carried along. It
/// mixes nothing between links; what else is in the error state stays as it is. `motion` as it is before the
/// step; `shift` is what the estimate's corrections since the errors were last carried have made of them.
LinkTransitions motionTransition(const KinematicTree& tree, const MotionState& motion, double dt_s,
                                 const Eigen::VectorXd& decay, const LinkTransitions& shift = {});

/// What a step adds to the covariance of one coordinate, its rate and its acceleration: white jerk of a
/// density that keeps the stationary `variance` of an acceleration that decays by `decay`.
Matrix3d motionNoise(double dt_s, double decay, double variance);

/// The state alone over dt_s.
void predictMotion(const KinematicTree& tree, MotionState& motion, double dt_s, const Eigen::VectorXd& decay);

/// Carries the state and its covariance P (coordinates, rates, accelerations first; the rest is constant)
/// over dt_s: accelerations decay by `decay` per step towards zero and keep the stationary variance
/// `acceleration_variance` (both per velocity index); coordinates and rates follow with accelerations held.
/// `shift` as in motionTransition().
LinkTransitions predictMotion(const KinematicTree& tree, MotionState& motion, Eigen::MatrixXd& P, double dt_s,
                              const Eigen::VectorXd& decay, const Eigen::VectorXd& acceleration_variance,
                              const LinkTransitions& shift = {});

/// Standard deviation (rad, right perturbation, 3 per joint) of every joint's rotation from the leading
/// coordinates' covariance; zero for a fixed joint. Where a joint moves, the larger of two variances is
/// added: `flesh_rad2`, learnt from the motion, and that of the mountings on both sides. `mounting_rad2` is
/// of mountingCovariances(); empty: none.
std::vector<double> jointSigmas(const KinematicTree& tree, const Skeleton& skeleton,
                                const MotionState& motion, const Eigen::MatrixXd& P, double flesh_rad2 = 0,
                                const std::vector<Matrix3d>& mounting_rad2 = {});

}  // namespace noctule
