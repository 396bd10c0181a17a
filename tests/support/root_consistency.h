// SPDX-License-Identifier: Apache-2.0
// Is a free root where the filter believes it to be, as surely as it believes? On a take of readings with the
// true motion as its reference.
#pragma once

#include <algorithm>

#include "core/estimation/manifold_filter.h"
#include "core/live/motion_tracker.h"
#include "core/recording/take.h"
#include "tests/support/nees.h"

namespace noctule::test {

/// Normalised estimation errors squared, means over time and per freedom: 1 where the covariance is honest.
struct RootConsistency {
    double nees_horizontal = 0, nees_vertical = 0, nees_velocity = 0, nees_yaw = 0;
    double path_m = 0, end_m = 0;              ///< along the floor; the error at the end
    double rms_m = 0, height_rms_m = 0;        ///< errors all the way, along the floor and up
    double yaw_at_most_rad = 0, tilt_rad = 0;  ///< since the first look; of the vertical, mean
    double yaw_sigma_begin_rad = 0,
           yaw_sigma_rad = 0;  ///< at the first look and the last, as the filter believes
    int count = 0;
};

/// Looked at when the filter has been moved to an instant of the reference.
class RootJudge {
public:
    explicit RootJudge(const TimedMotion& truth) : truth_(truth) {}

    /// Places are compared from the first call on: where the world begins is nobody's error. Velocities are
    /// the reference's over two frames.
    void look(const ManifoldFilter& filter, double time_s) {
        const auto time_ns = static_cast<int64_t>(time_s * 1e9);
        const auto& frames = truth_.frames;
        const auto after = std::ranges::lower_bound(frames, time_ns, {}, &TimedPose::time_ns);
        if (after == frames.begin() || after == frames.end())
            return;
        const auto before = std::prev(after);
        const double step_s = static_cast<double>(after->time_ns - before->time_ns) * 1e-9;
        const double share = static_cast<double>(time_ns - before->time_ns) * 1e-9 / step_s;
        const Vector3d from = before->pose->p_world_root, to = after->pose->p_world_root;
        const Vector3d p_true_m = from + share * (to - from), v_true_m_per_s = (to - from) / step_s;
        const Vector3d off_m = p_true_m - filter.state().motion.p_world_root;
        if (judged.count == 0) {
            begin_off_m_ = off_m;
            last_m_ = p_true_m;
            cov_begin_m2_ = filter.covariance()({0, 2}, {0, 2});
        }
        judgeRotation(before->pose->q_parent_joint[0].slerp(share, after->pose->q_parent_joint[0]), filter);
        judge(filter, off_m - begin_off_m_, v_true_m_per_s - filter.state().motion.rate.head<3>());
        judged.path_m += Vector3d(p_true_m.x() - last_m_.x(), 0, p_true_m.z() - last_m_.z()).norm();
        last_m_ = p_true_m;
    }

    RootConsistency mean() const {
        RootConsistency mean = judged;
        for (double* sum : {&mean.nees_horizontal, &mean.nees_vertical, &mean.nees_velocity, &mean.nees_yaw,
                            &mean.tilt_rad})
            *sum /= std::max(1, judged.count);
        for (double* sum : {&mean.rms_m, &mean.height_rms_m})
            *sum = std::sqrt(*sum / std::max(1, judged.count));
        return mean;
    }

private:
    void judgeRotation(const Quaterniond& truth, const ManifoldFilter& filter) {
        const Quaterniond& estimate = filter.state().motion.q_parent_link[0];
        // What turns the one to the other, seen in the world: about the vertical, and what remains.
        const Quaterniond off = truth * estimate.conjugate();
        const double yaw_rad = 2 * std::atan2(off.y(), off.w());
        const Vector3d up_root = estimate.conjugate() * Vector3d::UnitY();
        const double variance = up_root.dot(filter.covariance().block<3, 3>(3, 3) * up_root);
        if (judged.count == 0) {
            begin_yaw_rad_ = yaw_rad;
            begin_yaw_variance_ = variance;
            judged.yaw_sigma_begin_rad = std::sqrt(variance);
        }
        const double turned = std::remainder(yaw_rad - begin_yaw_rad_, 2 * std::numbers::pi);
        judged.yaw_at_most_rad = std::max(judged.yaw_at_most_rad, std::abs(turned));
        judged.nees_yaw += turned * turned / (variance - begin_yaw_variance_ + 1e-6);
        judged.yaw_sigma_rad = std::sqrt(variance);
        judged.tilt_rad += std::acos(std::clamp((off * Vector3d::UnitY()).y(), -1.0, 1.0));
    }
    void judge(const ManifoldFilter& filter, const Vector3d& off_m, const Vector3d& off_m_per_s) {
        const Eigen::MatrixXd& P = filter.covariance();
        const int rate = filter.layout().rate(0);
        const Eigen::Vector2d floor_m(off_m.x(), off_m.z());
        // Nothing has told the place at the beginning since: it is part of the place now, all of it.
        const Eigen::Matrix2d cov_floor =
            P({0, 2}, {0, 2}) - cov_begin_m2_ + 1e-6 * Eigen::Matrix2d::Identity();
        judged.nees_horizontal += nees(floor_m, cov_floor);
        judged.nees_vertical += off_m.y() * off_m.y() / P(1, 1);
        const Matrix3d cov_velocity = P.block<3, 3>(rate, rate);
        judged.nees_velocity += nees(off_m_per_s, cov_velocity);
        judged.end_m = floor_m.norm();
        judged.rms_m += floor_m.squaredNorm();
        judged.height_rms_m += off_m.y() * off_m.y();
        ++judged.count;
    }

    const TimedMotion& truth_;
    RootConsistency judged{};
    Vector3d begin_off_m_ = Vector3d::Zero(), last_m_ = Vector3d::Zero();
    double begin_yaw_rad_ = 0, begin_yaw_variance_ = 0;
    Eigen::Matrix2d cov_begin_m2_ = Eigen::Matrix2d::Zero();
};

/// Twenty looks a second, after the rest pose. The take's own calibration and actor unless others are given.
inline RootConsistency judgeRoot(const Take& take, const TrackerSettings& settings,
                                 const std::optional<Calibration>& calibration = {},
                                 const std::optional<Actor>& actor = {}) {
    const double rate_hz = static_cast<double>(take.sampleRate_hz().value());
    const auto marked = take.restInterval().value();
    const std::pair<int64_t, int64_t> rest(marked->first, marked->last);
    const auto tracker =
        MotionTracker::create(take.suit().value(),
                              calibration ? *calibration : take.calibrationInForce().value().value,
                              actor ? *actor : take.actorInForce().value().value, rate_hz, rest, settings)
            .value();
    const auto& filter = dynamic_cast<const ManifoldFilter&>(tracker->estimator());
    const TimedMotion truth = take.reference().value();
    RootJudge judge(truth);
    auto readings = take.readings(kPrimaryRun).value();
    auto ranges = take.ranges(kPrimaryRun).value();
    auto range = ranges.next().value();
    int64_t watermark = 0;
    while (const auto reading = readings.next().value()) {
        if (reading->sample >= static_cast<double>(watermark) + rate_hz / 20) {
            watermark = static_cast<int64_t>(reading->sample);
            for (; range && range->pulse_sample < watermark; range = ranges.next().value())
                tracker->add(*range);
            tracker->advanceTo(watermark);
            tracker->takePoses();
            tracker->takeRanges();
            if (watermark > rest.second)
                judge.look(filter, filter.seconds());
        }
        tracker->add(*reading);
    }
    return judge.mean();
}

}  // namespace noctule::test
