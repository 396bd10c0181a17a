// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/twist_continuity.h"

#include <algorithm>
#include <cmath>

namespace noctule::simulation {
namespace {

constexpr double kFastest_rad_per_s = 60, kLeastJump_rad = 0.8;
constexpr double kFading_rad_per_s = 0.5;

}  // namespace

Quaterniond TwistContinuity::next(const Quaterniond& q_world_segment) {
    if (previous_) {
        const Quaterniond step = previous_->conjugate() * q_world_segment;
        const double twist =
            std::remainder(2 * std::atan2(step.vec().dot(bone_), step.w()), 2 * std::numbers::pi);
        if (std::abs(twist) > std::max(kLeastJump_rad, kFastest_rad_per_s * frame_time_s_)) {
            correction_rad_ -= twist;
            ++jumps_;
        }
        const double over = std::remainder(correction_rad_, std::numbers::pi);
        const double fading = kFading_rad_per_s * frame_time_s_;
        correction_rad_ -= std::clamp(over, -fading, fading);
    }
    previous_ = q_world_segment;
    return q_world_segment * Quaterniond(Eigen::AngleAxisd(correction_rad_, bone_));
}

}  // namespace noctule::simulation
