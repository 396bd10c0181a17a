// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/measurement.h"

#include <Eigen/LU>

namespace noctule {

std::optional<Vector3d> sensedVector(const TriadReading& triad) {
    if (triad.count < 3 || triad.isClipped())
        return std::nullopt;
    Matrix3d axes;
    Vector3d values;
    for (int i = 0; i < 3; ++i) {
        axes.row(i) = triad.axes[static_cast<size_t>(i)].sensitive_axis_board.transpose();
        values[i] = triad.axes[static_cast<size_t>(i)].value;
    }
    return Vector3d(axes.inverse() * values);
}

}  // namespace noctule
