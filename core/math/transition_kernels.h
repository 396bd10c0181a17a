// SPDX-License-Identifier: Apache-2.0
// One link's part of a time step, or of a change of what its errors mean, for the columns of a large matrix:
// compiled for several instruction sets and chosen at run time, as covariance_kernels.h.
#pragma once

#include <Eigen/Core>

namespace noctule {

/// theta' = turn theta + jacobian (dt rate + dt^2/2 accel), rate' = rate + dt accel, accel' = decay accel;
/// for one coordinate (turn and jacobian 1) or the three of a rotation.
struct LinkTransition {
    Eigen::Index first = 0;  ///< its first coordinate
    int count = 1;           ///< 1 or 3
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity(), jacobian = Eigen::Matrix3d::Identity();
    Eigen::Vector3d decay = Eigen::Vector3d::Zero();
};

/// The link's columns (coordinates at `first`, rates n columns further, accelerations 2 n) of M := M F^T.
void mixColumns(Eigen::MatrixXd& M, Eigen::Index n, double dt_s, const LinkTransition& link);
/// The same of M := M F.
void mixColumnsBack(Eigen::MatrixXd& M, Eigen::Index n, double dt_s, const LinkTransition& link);

/// theta' = to_theta theta, rate' = rate + to_rate theta, accel' = accel + to_accel theta; of a rotation.
struct RotationShift {
    Eigen::Index first = 0;  ///< its first coordinate
    Eigen::Matrix3d to_theta, to_rate, to_accel;
};

/// The link's columns of M := M S^T.
void shiftColumns(Eigen::MatrixXd& M, Eigen::Index n, const RotationShift& link);
/// The same of M := M S.
void shiftColumnsBack(Eigen::MatrixXd& M, Eigen::Index n, const RotationShift& link);

}  // namespace noctule
