// SPDX-License-Identifier: Apache-2.0
#include "core/math/segment_distance.h"

#include <algorithm>

namespace noctule {

double segmentDistance(const Vector3d& a0, const Vector3d& a1, const Vector3d& b0, const Vector3d& b1) {
    constexpr double kPoint = 1e-12;
    const Vector3d u = a1 - a0, v = b1 - b0, w = a0 - b0;
    const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), uw = u.dot(w), vw = v.dot(w);
    const double denominator = uu * vv - uv * uv;
    double s = denominator > kPoint ? std::clamp((uv * vw - uw * vv) / denominator, 0.0, 1.0) : 0;
    double t = vv > kPoint ? (uv * s + vw) / vv : 0;
    if (t < 0 || t > 1) {
        t = std::clamp(t, 0.0, 1.0);
        s = uu > kPoint ? std::clamp((uv * t - uw) / uu, 0.0, 1.0) : 0;
    }
    return (w + s * u - t * v).norm();
}

}  // namespace noctule
