// SPDX-License-Identifier: Apache-2.0
#include "core/motion/time_offset.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/rotation.h"
#include "core/motion/common_joints.h"

namespace noctule {
namespace {

constexpr int64_t kStep_ns = 10'000'000;
constexpr int kLeastOverlap = 200;  // steps

/// Summed angular speed of some joints, rad per step, on a grid that starts at the motion's first frame.
std::vector<double> angularSpeed(const TimedMotion& motion, const std::vector<int>& joints) {
    std::vector<double> speed;
    if (motion.frames.empty())
        return speed;
    PoseSampler sampler(motion, std::numeric_limits<int64_t>::max());
    const int64_t last_ns = motion.frames.back().time_ns;
    std::optional<Pose> before;
    for (int64_t t_ns = motion.frames.front().time_ns; t_ns <= last_ns; t_ns += kStep_ns) {
        std::optional<Pose> now = sampler.at(t_ns);
        double sum = 0;
        if (before && now)
            for (const int j : joints)
                sum += angleBetween(before->q_parent_joint[static_cast<size_t>(j)],
                                    now->q_parent_joint[static_cast<size_t>(j)]);
        speed.push_back(sum);
        before = std::move(now);
    }
    return speed;
}

/// Pearson correlation of a[i] with b[i - lag] over their overlap; -1 when it is too short or constant.
double correlationAt(const std::vector<double>& a, const std::vector<double>& b, int lag) {
    const int begin = std::max(0, lag);
    const int end = std::min(static_cast<int>(a.size()), static_cast<int>(b.size()) + lag);
    if (end - begin < kLeastOverlap)
        return -1;
    double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
    for (int i = begin; i < end; ++i) {
        const double x = a[static_cast<size_t>(i)], y = b[static_cast<size_t>(i - lag)];
        sa += x, sb += y, saa += x * x, sbb += y * y, sab += x * y;
    }
    const double n = end - begin;
    const double va = saa - sa * sa / n, vb = sbb - sb * sb / n;
    return va > 1e-12 && vb > 1e-12 ? (sab - sa * sb / n) / std::sqrt(va * vb) : -1;
}

/// Where the parabola through three neighbours peaks, in steps from the middle one.
double parabolaPeak(double left, double middle, double right) {
    const double curvature = left - 2 * middle + right;
    return curvature < 0 ? std::clamp(0.5 * (left - right) / curvature, -0.5, 0.5) : 0;
}

}  // namespace

std::optional<TimeOffset> findTimeOffset(const TimedMotion& estimate, const TimedMotion& reference,
                                         double max_shift_s) {
    std::vector<int> estimate_joints, reference_joints;
    for (const CommonJoint& joint : commonJoints(estimate.skeleton, reference.skeleton))
        if (joint.moves && joint.ancestor >= 0) {
            estimate_joints.push_back(joint.first);
            reference_joints.push_back(joint.second);
        }
    const std::vector<double> a = angularSpeed(estimate, estimate_joints);
    const std::vector<double> b = angularSpeed(reference, reference_joints);
    if (a.empty() || b.empty())
        return std::nullopt;
    const int64_t start_difference_ns = estimate.frames.front().time_ns - reference.frames.front().time_ns;
    const int zero_lag = static_cast<int>(std::llround(-static_cast<double>(start_difference_ns) / kStep_ns));
    const int reach = static_cast<int>(std::ceil(max_shift_s * 1e9 / kStep_ns));
    int best = zero_lag;
    double peak = -1;
    for (int lag = zero_lag - reach; lag <= zero_lag + reach; ++lag)
        if (const double c = correlationAt(a, b, lag); c > peak)
            peak = c, best = lag;
    if (peak <= -1)
        return std::nullopt;
    const double fine =
        best + parabolaPeak(correlationAt(a, b, best - 1), peak, correlationAt(a, b, best + 1));
    return TimeOffset{start_difference_ns + std::llround(fine * kStep_ns), peak};
}

}  // namespace noctule
