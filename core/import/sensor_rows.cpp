// SPDX-License-Identifier: Apache-2.0
#include "core/import/sensor_rows.h"

#include <cmath>

namespace noctule {

namespace {

template <class T>
std::vector<T> placed(const std::vector<T>& rows, const RowGrid& grid, const T& missing) {
    std::vector<T> out(grid.rows, missing);
    for (size_t i = 0; i < grid.rows; ++i)
        if (grid.from[i] < rows.size())
            out[i] = rows[grid.from[i]];
    return out;
}

}  // namespace

Quaterniond checkedRotation(const Quaterniond& q) {
    const double norm = q.norm();
    return std::abs(norm - 1) < 0.05 ? Quaterniond(q.coeffs() / norm) : missingRotation();
}

ImportedSensor sensorOnGrid(const std::string& id, const SensorRows& rows, const RowGrid& grid) {
    ImportedSensor sensor{id, {}};
    sensor.samples.rate_hz = grid.rate_hz;
    sensor.samples.gyro_rad_per_s = placed(rows.gyro_rad_per_s, grid, missingVector());
    sensor.samples.accel_m_per_s2 = placed(rows.accel_m_per_s2, grid, missingVector());
    if (!rows.mag.empty())
        sensor.samples.mag = placed(rows.mag, grid, missingVector());
    if (!rows.q_world_sensor.empty())
        sensor.q_world_sensor = placed(rows.q_world_sensor, grid, missingRotation());
    return sensor;
}

std::vector<Vector3d> vectorsOf(const std::vector<double>& x, const std::vector<double>& y,
                                const std::vector<double>& z, double scale) {
    std::vector<Vector3d> out(x.size());
    for (size_t i = 0; i < out.size(); ++i)
        out[i] = scale * Vector3d(x[i], y[i], z[i]);
    return out;
}

}  // namespace noctule
