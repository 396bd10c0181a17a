// SPDX-License-Identifier: Apache-2.0
#include "core/orientation/field_reference.h"

#include <algorithm>

#include "core/math/rotation.h"

namespace noctule {

namespace {

constexpr double kReference_s = 0.5;

Vector3d meanOfFirst(const std::vector<Vector3d>& readings, size_t count) {
    Vector3d sum = Vector3d::Zero();
    int used = 0;
    for (size_t i = 0; i < std::min(count, readings.size()); ++i) {
        if (!readings[i].allFinite())
            continue;
        sum += readings[i];
        ++used;
    }
    return used > 0 ? Vector3d(sum / used) : Vector3d::Zero();
}

}  // namespace

Quaterniond attitudeFromFields(const Vector3d& up_sensor, const Vector3d& field_sensor) {
    const Quaterniond level = smallestRotation(up_sensor, Vector3d::UnitY());
    const Vector3d field = level * field_sensor;
    if (std::hypot(field.x(), field.z()) < 1e-9)
        return level;
    return axisAngle(Vector3d::UnitY(), -std::atan2(field.x(), field.z())) * level;
}

FieldReference initialReference(const ImuSamples& samples) {
    const auto count = static_cast<size_t>(std::max(1.0, kReference_s * samples.rate_hz));
    const Vector3d up = meanOfFirst(samples.accel_m_per_s2, count);
    const Vector3d field = meanOfFirst(samples.mag, count);
    FieldReference reference;
    if (up.isZero())
        return reference;
    reference.q_world_sensor = attitudeFromFields(up, field);
    reference.strength = field.norm();
    if (reference.strength > 0)
        reference.field_world = (reference.q_world_sensor * field).normalized();
    return reference;
}

}  // namespace noctule
