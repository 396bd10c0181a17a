// SPDX-License-Identifier: Apache-2.0
// One sensor's rows as a file gives them, and their place on an even grid.
#pragma once

#include <string>
#include <vector>

#include "core/import/recording.h"
#include "core/import/row_grid.h"

namespace noctule {

/// Each list is empty or has one entry per row of the file; NaN: missing.
struct SensorRows {
    std::vector<Vector3d> gyro_rad_per_s, accel_m_per_s2, mag;
    std::vector<Quaterniond> q_world_sensor;
};

inline Vector3d missingVector() {
    return Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
}
inline Quaterniond missingRotation() {
    return Quaterniond(Eigen::Vector4d::Constant(std::numeric_limits<double>::quiet_NaN()));
}
/// Unit, or missing when it is no rotation within 5 %.
Quaterniond checkedRotation(const Quaterniond& q);

/// Lost rows are NaN.
ImportedSensor sensorOnGrid(const std::string& id, const SensorRows& rows, const RowGrid& grid);

/// Three columns as vectors, scaled.
std::vector<Vector3d> vectorsOf(const std::vector<double>& x, const std::vector<double>& y,
                                const std::vector<double>& z, double scale = 1);

}  // namespace noctule
