// SPDX-License-Identifier: Apache-2.0
#include "core/motion/root_drift.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/rotation.h"

namespace noctule {
namespace {

/// Angle about the world's vertical of a rotation given in the world frame, -pi..pi.
double yawOf(const Quaterniond& q) {
    return std::remainder(2 * std::atan2(q.y(), q.w()), 2 * std::numbers::pi);
}

}  // namespace

void RootDrift::add(double time_s, const RootState& estimate, const RootState& reference) {
    if (!first_estimate_) {
        first_estimate_ = estimate;
        first_reference_ = reference;
        begin_s_ = time_s;
        q_reference_estimate_ =
            axisAngle(Vector3d::UnitY(), yawOf(reference.q_world_root * estimate.q_world_root.conjugate()));
    }
    const Quaterniond error =
        q_reference_estimate_ * estimate.q_world_root * reference.q_world_root.conjugate();
    const Vector3d moved_m =
        q_reference_estimate_ * (estimate.p_world_root_m - first_estimate_->p_world_root_m);
    const Vector3d reference_moved_m = reference.p_world_root_m - first_reference_->p_world_root_m;
    const Vector3d up = error * Vector3d::UnitY();
    const Vector3d apart{degrees(yawOf(error)), degrees(std::atan2(std::hypot(up.x(), up.z()), up.y())),
                         (moved_m - reference_moved_m).norm()};
    result_.yaw_curve_deg.add(time_s, apart[0]);
    result_.tilt_curve_deg.add(time_s, apart[1]);
    result_.position_curve_m.add(time_s, apart[2]);
    yaw_.add(time_s - begin_s_, yawOf(error));
    squares_ += apart.cwiseAbs2();
    ++frames_;
}

RootComparison RootDrift::finish() {
    const Vector3d root_mean_square = (squares_ / std::max(1.0, frames_)).cwiseSqrt();
    result_.yaw_deg = root_mean_square[0];
    result_.tilt_deg = root_mean_square[1];
    result_.position_m = root_mean_square[2];
    result_.yaw_drift_deg_per_min = yaw_.statistics().drift_deg_per_min;
    return std::move(result_);
}

}  // namespace noctule
