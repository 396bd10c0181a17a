// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/motion/board_signal.h"

#include <algorithm>

#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kLongestGap_s = 0.02;  // two readings in a row may be missing

/// Rotation over a short time with a rate that changes evenly: to third order.
Quaterniond turnBy(const Vector3d& from_rad_per_s, const Vector3d& to_rad_per_s, double lasts_s) {
    return expQuaternion(lasts_s / 2 * (from_rad_per_s + to_rad_per_s) +
                         lasts_s * lasts_s / 12 * from_rad_per_s.cross(to_rad_per_s));
}

}  // namespace

BoardSignal::BoardSignal(const std::vector<CountReading>& readings, const BoardCalibration& calibration) {
    samples_.reserve(readings.size());
    for (const CountReading& reading : readings)
        samples_.push_back({reading.time_s, calibration.gyro.apply(reading.gyro_counts),
                            calibration.accel.apply(reading.accel_counts), reading.clipped});
}

size_t BoardSignal::firstAfter(double time_s) const {
    return static_cast<size_t>(std::ranges::upper_bound(samples_, time_s, {}, &Sample::time_s) -
                               samples_.begin());
}

bool BoardSignal::covers(double begin_s, double end_s) const {
    const size_t after_begin = firstAfter(begin_s), after_end = firstAfter(end_s);
    if (after_begin == 0 || after_end >= samples_.size())
        return false;
    for (size_t i = after_begin; i <= after_end; ++i)
        if (samples_[i].clipped || samples_[i - 1].clipped ||
            samples_[i].time_s - samples_[i - 1].time_s > kLongestGap_s)
            return false;
    return true;
}

BoardSignal::Sample BoardSignal::at(double time_s) const {
    const size_t i = std::clamp<size_t>(firstAfter(time_s), 1, samples_.size() - 1);
    const Sample &a = samples_[i - 1], &b = samples_[i];
    const double u = (time_s - a.time_s) / (b.time_s - a.time_s);
    return {time_s, a.gyro_rad_per_s + u * (b.gyro_rad_per_s - a.gyro_rad_per_s),
            a.accel_m_per_s2 + u * (b.accel_m_per_s2 - a.accel_m_per_s2), false};
}

std::vector<BoardSignal::Sample> BoardSignal::between(double begin_s, double end_s) const {
    std::vector<Sample> samples{at(begin_s)};
    for (size_t i = firstAfter(begin_s); i < samples_.size() && samples_[i].time_s < end_s; ++i)
        samples.push_back(samples_[i]);
    samples.push_back(at(end_s));
    return samples;
}

Quaterniond BoardSignal::turn(double begin_s, double end_s) const {
    const std::vector<Sample> samples = between(begin_s, end_s);
    Quaterniond q = Quaterniond::Identity();
    for (size_t i = 1; i < samples.size(); ++i)
        q = q * turnBy(samples[i - 1].gyro_rad_per_s, samples[i].gyro_rad_per_s,
                       samples[i].time_s - samples[i - 1].time_s);
    return q.normalized();
}

Vector3d BoardSignal::meanForce(double middle_s, double half_s) const {
    Vector3d total = Vector3d::Zero();
    for (const double begin_s : {middle_s - half_s, middle_s}) {
        const std::vector<Sample> samples = between(begin_s, begin_s + half_s);
        Vector3d sum = Vector3d::Zero();
        Quaterniond q = Quaterniond::Identity();  // from the beginning on
        const auto weighted = [&](double time_s, const Quaterniond& q_begin_now, const Vector3d& force) {
            return Vector3d((1 - std::abs(time_s - middle_s) / half_s) * (q_begin_now * force));
        };
        for (size_t i = 1; i < samples.size(); ++i) {  // Simpson's rule
            const Sample &a = samples[i - 1], &b = samples[i];
            const double lasts_s = b.time_s - a.time_s;
            const Vector3d half_way = (a.gyro_rad_per_s + b.gyro_rad_per_s) / 2;
            const Quaterniond q_middle = q * turnBy(a.gyro_rad_per_s, half_way, lasts_s / 2);
            const Quaterniond q_end = q * turnBy(a.gyro_rad_per_s, b.gyro_rad_per_s, lasts_s);
            sum += lasts_s / 6 *
                   (weighted(a.time_s, q, a.accel_m_per_s2) +
                    4 * weighted((a.time_s + b.time_s) / 2, q_middle,
                                 (a.accel_m_per_s2 + b.accel_m_per_s2) / 2) +
                    weighted(b.time_s, q_end, b.accel_m_per_s2));
            q = q_end;
        }
        total += begin_s < middle_s ? Vector3d(q.conjugate() * sum) : sum;
    }
    return total / half_s;
}

}  // namespace noctule
