// SPDX-License-Identifier: Apache-2.0
#include "core/posing/still_bias.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/order_statistics.h"

namespace noctule::posing {

namespace {

constexpr double kWindow_s = 1;
constexpr double kRestRate_rad_per_s = 0.05;  ///< standard deviation within a window
constexpr double kRestAccel_m_per_s2 = 0.3;
constexpr double kMostBias_rad_per_s = 0.1;  ///< more is a slow turn
constexpr double kBridged_s = 0.1;
constexpr size_t kFewest = 2;
constexpr double kBiasLeft_rad_per_s = 0.002;  ///< after the mean at rest was taken off
constexpr double kWalkingSpeed_m_per_s = 2;    ///< people walk away: their velocity is not 0 +- 1
constexpr double kAnyPlace_m = 1e4;

struct Spread {
    Vector3d mean = Vector3d::Zero();
    double deviation = 1e9;
};

Spread spreadOf(const std::vector<Vector3d>& values, size_t begin, size_t count) {
    Spread spread;
    Vector3d sum = Vector3d::Zero();
    double squares = 0;
    for (size_t i = begin; i < begin + count; ++i) {
        if (!values[i].allFinite())
            return spread;
        sum += values[i];
        squares += values[i].squaredNorm();
    }
    spread.mean = sum / double(count);
    spread.deviation = std::sqrt(std::max(0.0, squares / double(count) - spread.mean.squaredNorm()));
    return spread;
}

/// Short gaps become straight lines, axis by axis: a turn that is left out would stay.
void bridge(std::vector<Vector3d>& readings, size_t most) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        size_t last = readings.size();
        for (size_t i = 0; i < readings.size(); ++i) {
            if (!std::isfinite(readings[i][axis]))
                continue;
            const double from = last < i ? readings[last][axis] : 0, to = readings[i][axis];
            for (size_t k = last + 1; last < i && i - last <= most + 1 && k < i; ++k)
                readings[k][axis] = from + (to - from) * double(k - last) / double(i - last);
            last = i;
        }
    }
}

}  // namespace

std::optional<Vector3d> stillBias_rad_per_s(const ImuSamples& samples) {
    const auto window = std::max<size_t>(2, size_t(kWindow_s * samples.rate_hz));
    std::vector<Vector3d> rests;
    for (size_t begin = 0; begin + window <= samples.size(); begin += window / 2) {
        const Spread rate = spreadOf(samples.gyro_rad_per_s, begin, window);
        const Spread accel = spreadOf(samples.accel_m_per_s2, begin, window);
        if (rate.deviation < kRestRate_rad_per_s && accel.deviation < kRestAccel_m_per_s2 &&
            rate.mean.norm() < kMostBias_rad_per_s)
            rests.push_back(rate.mean);
    }
    if (rests.size() < kFewest)
        return std::nullopt;
    Vector3d bias;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (const Vector3d& rest : rests)
            values.push_back(rest[axis]);
        bias[axis] = middleValue(std::move(values));
    }
    return bias;
}

Result<OrientationRun> wornOrientation(ImuSamples& samples, bool smooth, const JobContext& job) {
    OrientationSettings settings;
    settings.smooth = smooth;
    settings.velocity_m_per_s = kWalkingSpeed_m_per_s;
    settings.place_m = kAnyPlace_m;
    for (auto* readings : {&samples.gyro_rad_per_s, &samples.accel_m_per_s2})
        bridge(*readings, size_t(kBridged_s * samples.rate_hz));
    if (const auto bias = stillBias_rad_per_s(samples)) {
        settings.start_gyro_bias_rad_per_s = kBiasLeft_rad_per_s;
        for (Vector3d& rate : samples.gyro_rad_per_s)
            rate -= *bias;
    }
    return estimateOrientation(samples, settings, job);
}

}  // namespace noctule::posing
