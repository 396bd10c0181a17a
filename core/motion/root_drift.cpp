// SPDX-License-Identifier: Apache-2.0
#include "core/motion/root_drift.h"

#include <cmath>
#include <numeric>

#include "core/math/rotation.h"

namespace noctule {
namespace {

/// Angle about the world's vertical of a rotation given in the world frame, -pi..pi.
double yawOf(const Quaterniond& q) {
    return std::remainder(2 * std::atan2(q.y(), q.w()), 2 * std::numbers::pi);
}

double rootMeanSquare(const std::vector<double>& values) {
    if (values.empty())
        return 0;
    const double squares = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
    return std::sqrt(squares / static_cast<double>(values.size()));
}

}  // namespace

void RootDrift::add(const RootState& estimate, const RootState& reference) {
    if (!first_estimate_) {
        first_estimate_ = estimate;
        first_reference_ = reference;
        q_reference_estimate_ =
            axisAngle(Vector3d::UnitY(), yawOf(reference.q_world_root * estimate.q_world_root.conjugate()));
    }
    const Quaterniond error =
        q_reference_estimate_ * estimate.q_world_root * reference.q_world_root.conjugate();
    const Vector3d moved_m =
        q_reference_estimate_ * (estimate.p_world_root_m - first_estimate_->p_world_root_m);
    const Vector3d reference_moved_m = reference.p_world_root_m - first_reference_->p_world_root_m;
    const Vector3d up = error * Vector3d::UnitY();
    result_.yaw_curve_deg.push_back(degrees(yawOf(error)));
    result_.tilt_curve_deg.push_back(degrees(std::atan2(std::hypot(up.x(), up.z()), up.y())));
    result_.position_curve_m.push_back((moved_m - reference_moved_m).norm());
}

RootComparison RootDrift::finish() {
    result_.yaw_deg = rootMeanSquare(result_.yaw_curve_deg);
    result_.tilt_deg = rootMeanSquare(result_.tilt_curve_deg);
    result_.position_m = rootMeanSquare(result_.position_curve_m);
    return std::move(result_);
}

}  // namespace noctule
