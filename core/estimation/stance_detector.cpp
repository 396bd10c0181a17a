// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/stance_detector.h"

namespace noctule {
namespace {

constexpr size_t kLeastReadings = 3;

double meanVariance(const TriadReading& triad) {
    double sum = 0;
    for (const AxisReading& axis : triad.axes)
        sum += axis.sigma * axis.sigma;
    return sum / 3;
}

}  // namespace

void StanceDetector::standsFrom(double since_s, double now_s) {
    window_.clear();
    still_since_s_ = since_s;
    heard_s_ = now_s;
}

void StanceDetector::begin() {
    window_.clear();
    still_since_s_.reset();
}

void StanceDetector::add(const InertialMeasurement& measurement, const Vector3d& gyro_bias) {
    if (measurement.time_s - heard_s_ > parameters_.longest_silence_s)
        begin();
    const auto rate = sensedVector(measurement.gyro);
    const auto force = parameters_.uses_accelerometers ? sensedVector(measurement.accel) : Vector3d::Zero();
    if (!rate || !force) {
        if (measurement.gyro.isClipped() || measurement.accel.isClipped())
            begin();
        return;
    }
    window_.push_back(sampleOf(measurement, *rate - gyro_bias, *force));
    heard_s_ = measurement.time_s;
    std::erase_if(window_,
                  [&](const Sample& old) { return old.time_s < measurement.time_s - parameters_.window_s; });
    if (window_.size() < kLeastReadings)
        return;
    if (statistic() > (still_since_s_ ? parameters_.leave : parameters_.touch))
        still_since_s_.reset();
    else if (!still_since_s_)
        still_since_s_ = window_.front().time_s;
}

/// Motion of a rigid body: a_contact = a_board + alpha x r + omega x (omega x r).
StanceDetector::Sample StanceDetector::sampleOf(const InertialMeasurement& measurement, const Vector3d& rate,
                                                const Vector3d& force) const {
    Sample sample{measurement.time_s, rate, force, meanVariance(measurement.gyro),
                  meanVariance(measurement.accel)};
    sample.force_m_per_s2 += rate.cross(rate.cross(p_board_contact_m_));
    if (!window_.empty()) {
        const Sample& last = window_.back();
        const double dt_s = sample.time_s - last.time_s;
        sample.force_m_per_s2 += ((rate - last.omega_rad_per_s) / dt_s).cross(p_board_contact_m_);
        sample.force_variance +=
            (sample.omega_variance + last.omega_variance) * p_board_contact_m_.squaredNorm() / (dt_s * dt_s);
    }
    return sample;
}

double StanceDetector::statistic() const {
    Vector3d mean_force = Vector3d::Zero();
    for (const Sample& sample : window_)
        mean_force += sample.force_m_per_s2;
    const Vector3d gravity = parameters_.g_m_per_s2 * mean_force.normalized();
    const double shaking = parameters_.shaking_m_per_s2;
    const double rolling = parameters_.rolling_rad_per_s;
    double sum = 0;
    for (const Sample& sample : window_) {
        sum += sample.omega_rad_per_s.squaredNorm() / (3 * (rolling * rolling + sample.omega_variance));
        if (parameters_.uses_accelerometers)
            sum += (sample.force_m_per_s2 - gravity).squaredNorm() /
                   (3 * (shaking * shaking + sample.force_variance));
    }
    return sum / static_cast<double>(window_.size());
}

std::optional<double> StanceDetector::standsSince_s(double now_s) const {
    const bool stands = still_since_s_ && now_s - heard_s_ <= parameters_.longest_silence_s &&
                        heard_s_ - *still_since_s_ >= parameters_.least_contact_s;
    return stands ? still_since_s_ : std::nullopt;
}

}  // namespace noctule
