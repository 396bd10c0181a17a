// SPDX-License-Identifier: Apache-2.0
// How a limb lies in the world, from forces alone and however it moves: the acceleration of the joint that
// carries it follows from the body above, the limb's own board measures the same force in the limb's frame,
// and over some tenths of a second only one rotation takes the ones to the others (Wahba 1965, "A least
// squares estimate of satellite attitude"; by singular values: Markley 1988). A filter that lost the limb
// while its gyroscope was at the end of its range does not find back by itself, for it trusts its covariance;
// nothing here depends on that.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "core/math/conventions.h"

namespace noctule {

struct LimbAlignmentParameters {
    double memory_s = 0.4;      ///< of forces
    double least_s = 0.15;      ///< of forces before they say anything
    double suspected_s = 5;     ///< after a gap in the gyroscope's readings; no limb is lost without one
    double longest_s = 0.03;    ///< between readings; more is a gap
    double error_m_per_s2 = 2;  ///< of a force,
    double error_per_motion = 0.3, wobble_s = 0.15;  ///< more on flesh, by the largest lately
    double alike_s = 0.1;                            ///< errors are alike for so long
    double lost_rad = 0.45, lost_sigma = 3;          ///< the estimate is off by as much, and as surely
};

class LimbAlignment {
public:
    explicit LimbAlignment(const LimbAlignmentParameters& parameters = {})
        : parameters_(parameters), unbroken_s_(parameters.suspected_s) {}

    /// What the limb's board read, in the limb's frame, `p_m` away from the joint.
    struct Reading {
        double time_s = 0;
        Vector3d rate_rad_per_s, force_m_per_s2, p_m;
    };
    /// `force_joint_world`: specific force at the joint, m/s^2.
    void add(const Reading& reading, const Vector3d& force_joint_world);
    /// The limb's turn has not been seen up to `time_s`.
    void breakOff(double time_s);

    /// Where the limb is, if `R_world_limb` cannot be right.
    struct Found {
        Quaterniond q_believed_limb;
        Vector3d variance_rad2;  ///< of right perturbations, along the axes of
        Quaterniond q_limb_axes = Quaterniond::Identity();
    };
    std::optional<Found> contradict(const Matrix3d& R_world_limb) const;

private:
    LimbAlignmentParameters parameters_;
    double unbroken_s_ = 0, last_s_ = 0;
    std::optional<Vector3d> last_rate_rad_per_s_;
    /// Attitude profile: sum of world times limb transposed, weighted as all sums by time and by 1 / error^2.
    Matrix3d profile_ = Matrix3d::Zero();
    double squares_ = 0, weight_s_ = 0, shaken_m_per_s2_ = 0;
};

}  // namespace noctule
