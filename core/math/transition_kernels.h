// SPDX-License-Identifier: Apache-2.0
// How links' errors are carried over a time step, or changed in what they mean, in the columns of a large
// matrix: compiled for several instruction sets and chosen at run time, as covariance_kernels.h.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace noctule {

/// One link's part, of one coordinate or the three of a rotation:
///   theta' = turn theta + jacobian (dt rate + dt^2/2 accel),
///   rate'  = rate + dt accel + rate_by_theta theta,
///   accel' = decay accel + accel_by_theta theta.
struct LinkTransition {
    Eigen::Index first = 0;  ///< its first coordinate
    int count = 1;           ///< 1 or 3
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity(), jacobian = Eigen::Matrix3d::Identity();
    Eigen::Matrix3d rate_by_theta = Eigen::Matrix3d::Zero(), accel_by_theta = Eigen::Matrix3d::Zero();
    Eigen::Vector3d decay = Eigen::Vector3d::Ones();
};

/// F of some links: coordinates at `first`, rates n further, accelerations 2 n; all else stays as it is.
struct LinkTransitions {
    Eigen::Index n = 0;
    double dt_s = 0;
    std::vector<LinkTransition> links{};

    /// M := M F^T and M := M F, for any number of rows.
    void timesTransposed(Eigen::Ref<Eigen::MatrixXd> M) const;
    void times(Eigen::Ref<Eigen::MatrixXd> M) const;

    /// P := F P F^T for a symmetric P, x := F x.
    void carry(Eigen::MatrixXd& P) const;
    void carry(Eigen::VectorXd& x) const;
    /// The adjoint: P := F^T P F, x := F^T x.
    void carryBack(Eigen::MatrixXd& P) const;
    void carryBack(Eigen::VectorXd& x) const;

    /// F := F S; `shift` is of rotations among these, takes no time and lets nothing decay.
    void beginWith(const LinkTransitions& shift);
};

}  // namespace noctule
