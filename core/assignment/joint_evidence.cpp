// SPDX-License-Identifier: Apache-2.0
#include "core/assignment/joint_evidence.h"

#include <algorithm>
#include <cmath>

#include "core/math/linear_solvers.h"

namespace noctule::assignment {

namespace {

constexpr double kCutoff_hz = 8;  ///< above it soft tissue shakes
constexpr double kThinned_hz = 25;
constexpr double kLeverSigma_m = 0.3;        ///< segments are shorter than that
constexpr double kMisfitSigma_m_per_s2 = 1;  ///< of usual misfits; beyond it a row counts less
constexpr double kPriorShare = 0.09 * 0.09;
constexpr int kFitSteps = 12;

using Levers = Eigen::Matrix<double, 6, 1>;

template <class T>
std::vector<T> smoothed(const std::vector<T>& values, double rate_hz, double cutoff_hz, T zero) {
    const auto taps = long(2 * rate_hz / cutoff_hz) | 1, half = taps / 2, count = long(values.size());
    std::vector<double> window;
    double sum = 0;
    for (long k = 0; k < taps; ++k) {
        window.push_back(
            taps == 1 ? 1 : 0.5 - 0.5 * std::cos(2 * std::numbers::pi * double(k) / double(taps - 1)));
        sum += window.back();
    }
    std::vector<T> out(values.size(), zero);
    for (long i = 0; i < count; ++i)
        for (long k = 0; k < taps; ++k)
            out[size_t(i)] +=
                window[size_t(k)] / sum * values[size_t(std::clamp(i + k - half, 0L, count - 1))];
    return out;
}

/// A missing reading repeats the one before.
std::vector<Vector3d> held(const std::vector<Vector3d>& readings) {
    std::vector<Vector3d> out = readings;
    Vector3d last = Vector3d::Zero();
    for (Vector3d& reading : out) {
        if (!reading.allFinite())
            reading = last;
        last = reading;
    }
    return out;
}

Matrix3d crossMatrix(const Vector3d& v) {
    return (Matrix3d() << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0).finished();
}

}  // namespace

std::vector<Vector3d> lowPassed(const std::vector<Vector3d>& values, double rate_hz, double cutoff_hz) {
    return smoothed<Vector3d>(values, rate_hz, cutoff_hz, Vector3d::Zero());
}
std::vector<double> lowPassed(const std::vector<double>& values, double rate_hz, double cutoff_hz) {
    return smoothed<double>(values, rate_hz, cutoff_hz, 0);
}

SmoothMotion smoothMotion(const ImuSamples& samples) {
    const auto rates = lowPassed(held(samples.gyro_rad_per_s), samples.rate_hz, kCutoff_hz);
    const auto accels = lowPassed(held(samples.accel_m_per_s2), samples.rate_hz, kCutoff_hz);
    const auto step = std::max<size_t>(1, size_t(std::lround(samples.rate_hz / kThinned_hz)));
    SmoothMotion motion;
    for (size_t i = 1; i + 1 < rates.size(); i += step) {
        const Vector3d& w = rates[i];
        const Vector3d turning = (rates[i + 1] - rates[i - 1]) * samples.rate_hz / 2;
        motion.rate_rad_per_s.push_back(w);
        motion.accel_m_per_s2.push_back(accels[i]);
        motion.lever.push_back(crossMatrix(turning) + w * w.transpose() -
                               w.squaredNorm() * Matrix3d::Identity());
    }
    return motion;
}

JointEvidence jointEvidence(const SmoothMotion& first, const SmoothMotion& second) {
    const size_t rows = std::min(first.lever.size(), second.lever.size());
    Levers x = Levers::Zero();
    JointEvidence evidence;
    for (int step = 0; step <= kFitSteps; ++step) {
        Eigen::Matrix<double, 6, 6> N =
            kPriorShare / (kLeverSigma_m * kLeverSigma_m) * Eigen::Matrix<double, 6, 6>::Identity();
        Levers right = -kPriorShare / (kLeverSigma_m * kLeverSigma_m) * x;
        double sum = 0;
        for (size_t i = 0; i < rows; ++i) {
            const Vector3d u = first.accel_m_per_s2[i] - first.lever[i] * x.head<3>();
            const Vector3d v = second.accel_m_per_s2[i] - second.lever[i] * x.tail<3>();
            const double e = u.norm() - v.norm();
            sum += std::abs(e);
            Levers g;
            g << -first.lever[i].transpose() * u.normalized(), second.lever[i].transpose() * v.normalized();
            const double weight = 1 / (std::max(1.0, std::abs(e) / kMisfitSigma_m_per_s2) * double(rows));
            N += weight * g * g.transpose();
            right -= weight * e * g;
        }
        evidence = {sum / double(std::max<size_t>(rows, 1)), x.head<3>(), x.tail<3>()};
        x += solveSymmetric(N, right);
    }
    return evidence;
}

}  // namespace noctule::assignment
