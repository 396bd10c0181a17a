// SPDX-License-Identifier: Apache-2.0
// Why a free body's heading stays unknown: nothing on the suit tells it, so no reading may make it surer.
// Turned about the vertical, a body keeps its readings if its velocity and acceleration turn along. A
// covariance of velocities along the world's axes holds that as a correlation, which fits the velocity as it
// was; after an update it has to fit the corrected one, else the next reading seems to tell a little of the
// heading, and after minutes the filter is sure of a wrong one (Barrau and Bonnabel, "The invariant extended
// Kalman filter as a stable observer", IEEE Transactions on Automatic Control 62, 2017, hold errors that turn
// with the body instead, to the same effect).
#pragma once

#include <Eigen/Core>

#include "core/body/kinematics.h"

namespace noctule {

/// The change of a free root's errors with its estimate from `before` to `after` updates. Columns as in
/// StateLayout; the root's six coordinates come first.
class HeadingShift {
public:
    /// `turns_place`: the body's place counts, too, since others are seen from it: it turns along about the
    /// world's origin.
    HeadingShift(const MotionState& before, const MotionState& after, bool turns_place = false);

    /// P := M P M^T, error := M error.
    void carry(Eigen::MatrixXd& P) const;
    /// C := C M^T for covariances C of anything with the errors.
    void timesTransposed(Eigen::MatrixXd& C) const;
    /// The adjoint, against time: lambda := M^T lambda, Lambda := M^T Lambda M.
    void carryBack(Eigen::VectorXd& lambda) const;
    void carryBack(Eigen::MatrixXd& Lambda) const;

private:
    Eigen::Index n_;
    Matrix3d turn_;                     ///< from the root's axes before to those after
    Vector3d up_root_;                  ///< before
    Vector3d velocity_, acceleration_;  ///< by which those turn too little, per radian of heading
    bool turns_place_;
    Vector3d place_;  ///< the same
};

}  // namespace noctule
