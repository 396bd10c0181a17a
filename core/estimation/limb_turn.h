// SPDX-License-Identifier: Apache-2.0
// Why a limb's attitude stays unknown where only gyroscopes see it, though joints are described against each
// other. A limb turned alone in the world, what it carries staying as it lies, leaves every gyroscope's
// reading as it is: joints turn, and their rates and accelerations change so that those of all links against
// the world stay, each in its own frame,
//
//   d rate = -W x d theta,   d accel = -A x d theta + rate x (W x d theta) + W x (W x d theta),
//
// with W and A the parent's angular velocity and acceleration in the link's frame. A covariance holds that as
// a correlation, which fits the estimate that it was made of; after an update it has to fit the corrected
// one, else the next reading seems to tell of the attitude, and after a minute the filter is sure of a wrong
// one: a foot seen by its gyroscope alone was 125 degrees off and believed to a degree. heading_shift.h does
// the same for the whole body about the vertical, and names the source.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/body/kinematics.h"
#include "core/math/transition_kernels.h"

namespace noctule {

/// What turns of single limbs make of a state's errors. Only ball joints can follow such a turn.
class LimbTurns {
public:
    LimbTurns(const KinematicTree& tree, const MotionState& motion);

    struct Turn {
        Matrix3d R_world_link = Matrix3d::Identity();
        /// Of the parent in the world and of the joint; rad/s, rad/s^2, in the link's frame.
        Vector3d parent_rate, parent_accel, rate, accel;
        Matrix3d rate_by_theta, accel_by_theta;
    };
    const Turn& of(size_t link) const { return turns_[link]; }

    /// Error of coordinates, rates and accelerations (3 freedoms x 3) by a right perturbation of a link on a
    /// ball joint. Links that it carries stay as they lie in the world where `stays` (per link) says so and a
    /// ball joint lets them; the others go along.
    Eigen::MatrixX3d errorOf(const KinematicTree& tree, int link, const std::vector<bool>& stays) const;

private:
    std::vector<Turn> turns_;
};

/// A correction of a state's errors, bent so that a limb which it turns far keeps in its own frame the rate
/// that it has against the world, and not only to first order. It changes no turn; exact where the parent's
/// rate is not corrected at the same time.
Eigen::VectorXd bendTurns(const KinematicTree& tree, const MotionState& motion, Eigen::VectorXd correction);

/// The change of the joints' errors with an estimate from `before` to `after` updates; takes no time.
LinkTransitions limbShift(const KinematicTree& tree, const LimbTurns& before, const LimbTurns& after);

}  // namespace noctule
