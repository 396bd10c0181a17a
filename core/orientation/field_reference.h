// SPDX-License-Identifier: Apache-2.0
// The two directions that an orientation is told by: gravity and the Earth's magnetic field. World: Y up, Z
// magnetic north, X west. Without a magnetometer Z is any horizontal direction.
#pragma once

#include "core/orientation/imu_samples.h"

namespace noctule {

/// Means over the first half second, or what is there of it.
struct FieldReference {
    Quaterniond q_world_sensor = Quaterniond::Identity();  ///< levelled and turned to north by the means
    Vector3d up_world = Vector3d::UnitY();
    Vector3d field_world =
        Vector3d::UnitZ();  ///< unit vector, with its inclination; UnitZ without magnetometer
    double strength = 0;    ///< mean norm of the field; 0 without magnetometer
};
FieldReference initialReference(const ImuSamples& samples);

/// The attitude whose sensor reads `up` as upward and whose field's horizontal part points to Z. Zero or
/// vertical field: any heading.
Quaterniond attitudeFromFields(const Vector3d& up_sensor, const Vector3d& field_sensor);

}  // namespace noctule
