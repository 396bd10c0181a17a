// SPDX-License-Identifier: Apache-2.0
#include "core/import/unit_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace noctule {

namespace {

double medianNorm(const std::vector<Vector3d>& readings) {
    std::vector<double> norms;
    for (const Vector3d& reading : readings)
        if (reading.allFinite())
            norms.push_back(reading.norm());
    if (norms.empty())
        return 0;
    std::nth_element(norms.begin(), norms.begin() + long(norms.size() / 2), norms.end());
    return norms[norms.size() / 2];
}

struct Unit {
    const char* name;
    double gravity;  ///< what gravity reads in it
};

void scale(std::vector<Vector3d>& readings, double factor) {
    for (Vector3d& reading : readings)
        reading *= factor;
}

void convertAccelerations(ImportedSensor& sensor, std::vector<std::string>& warnings) {
    const double median = medianNorm(sensor.samples.accel_m_per_s2);
    for (const Unit& unit : {Unit{"g", 1}, Unit{"cm/s^2", 981}, Unit{"mg", 1000}})
        if (std::abs(median / unit.gravity - 1) < 0.012 ||
            (unit.gravity == 1 && std::abs(median - 1) < 0.25)) {
            scale(sensor.samples.accel_m_per_s2, kStandardGravity_m_per_s2 / unit.gravity);
            warnings.push_back(sensor.id + ": accelerations were read as " + unit.name +
                               " and converted to m/s^2");
            return;
        }
    if (median < 6 || median > 14)
        warnings.push_back(sensor.id + ": accelerations have a median of " + std::to_string(median) +
                           ", which is gravity in no known unit");
}

void convertRates(ImportedSensor& sensor, std::vector<std::string>& warnings) {
    const double slope = gyroscopeSlope(sensor.samples);
    if (!std::isfinite(slope))
        return;
    if (slope > 0.008 && slope < 0.03) {
        scale(sensor.samples.gyro_rad_per_s, radians(1));
        warnings.push_back(sensor.id + ": rates were read as deg/s and converted to rad/s");
    } else if (slope < 0.5 || slope > 2) {
        warnings.push_back(sensor.id + ": gravity turns " + std::to_string(slope) +
                           " times as fast as the gyroscope says; check unit and axes of the gyroscope");
    }
}

}  // namespace

double gyroscopeSlope(const ImuSamples& samples) {
    // Means over a tenth of a second: gravity's direction by finite differences drowns in noise otherwise.
    const auto block = static_cast<size_t>(std::max(1.0, samples.rate_hz / 10));
    std::vector<Vector3d> up, rate;
    for (size_t begin = 0; begin + block <= samples.size(); begin += block) {
        Vector3d a = Vector3d::Zero(), w = Vector3d::Zero();
        for (size_t i = begin; i < begin + block; ++i) {
            a += samples.accel_m_per_s2[i];
            w += samples.gyro_rad_per_s[i];
        }
        up.push_back(a / double(block));
        rate.push_back(w / double(block));
    }
    const double gravity = medianNorm(up);
    double cross = 0, square = 0, moved = 0;
    for (size_t k = 1; k + 1 < up.size(); ++k) {
        if (!up[k - 1].allFinite() || !up[k + 1].allFinite() || !rate[k].allFinite())
            continue;
        // Only where gravity is all that is felt, and the turn is slow enough for a difference.
        if (std::abs(up[k].norm() / gravity - 1) > 0.05)
            continue;
        const Vector3d turned = (up[k + 1] - up[k - 1]) / (2 * double(block) / samples.rate_hz);
        if (turned.norm() > 1.5 * gravity)
            continue;
        const Vector3d told = -rate[k].cross(up[k]);
        cross += turned.dot(told);
        square += told.squaredNorm();
        moved += turned.squaredNorm() / (gravity * gravity);
    }
    if (!(moved > 0.05 * double(up.size()) * 0.1) || square == 0)
        return std::numeric_limits<double>::quiet_NaN();
    return cross / square;
}

void convertToSi(ImportedRecording& recording) {
    for (ImportedSensor& sensor : recording.sensors) {
        convertAccelerations(sensor, recording.warnings);
        convertRates(sensor, recording.warnings);
        if (!sensor.samples.mag.empty() && !(medianNorm(sensor.samples.mag) > 0)) {
            sensor.samples.mag.clear();
            recording.warnings.push_back(sensor.id +
                                         ": the magnetometer reads zero throughout and is left out");
        }
    }
}

}  // namespace noctule
