// SPDX-License-Identifier: Apache-2.0
#include "core/orientation/imu_samples.h"

#include <algorithm>

namespace noctule {

Vector3d ImuSamples::rateInPause_rad_per_s(size_t i) const {
    constexpr double kMost_s = 1;
    const double span_s = std::min(pause_s(i), kMost_s);
    Vector3d sum = Vector3d::Zero();
    double read_s = 0;
    const auto add = [&](size_t row) {
        if (!gyro_rad_per_s[row].allFinite())
            return;
        sum += interval_s(row) * gyro_rad_per_s[row];
        read_s += interval_s(row);
    };
    double gone_s = 0;
    for (size_t row = i; row < size() && gone_s < span_s && (row == i || pause_s(row) == 0); ++row) {
        add(row);
        gone_s += interval_s(row);
    }
    gone_s = 0;
    for (size_t row = i; row-- > 0 && gone_s < span_s;) {
        add(row);
        gone_s += interval_s(row);
        if (pause_s(row) > 0)
            break;
    }
    return read_s > 0 ? Vector3d(sum / read_s) : Vector3d::Zero();
}

}  // namespace noctule
