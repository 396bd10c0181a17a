// SPDX-License-Identifier: Apache-2.0
// The time step of a filter whose error state begins with coordinates, rates and accelerations of a tree.
#pragma once

#include <vector>

#include "core/body/kinematics.h"

namespace noctule {

/// Carries the state and its covariance P (coordinates, rates, accelerations first; the rest is constant)
/// over dt_s: accelerations decay by `decay` per step towards zero and keep the stationary variance
/// `acceleration_variance` (both per velocity index); coordinates and rates follow with accelerations held.
void predictMotion(const KinematicTree& tree, MotionState& motion, Eigen::MatrixXd& P, double dt_s,
                   const Eigen::VectorXd& decay, const Eigen::VectorXd& acceleration_variance);

/// Standard deviation (rad, right perturbation, 3 per joint) of every joint's rotation from the leading
/// coordinates' covariance; zero for a fixed joint. `flesh_rad2` is added where a joint moves: how far boards
/// turn against their bones.
std::vector<double> jointSigmas(const KinematicTree& tree, const Skeleton& skeleton,
                                const MotionState& motion, const Eigen::MatrixXd& P, double flesh_rad2 = 0);

}  // namespace noctule
