// SPDX-License-Identifier: Apache-2.0
// What was found of one sensor, to be shown before the take is made.
#pragma once

#include "core/import/recording.h"

namespace noctule {

struct SensorFindings {
    bool gyroscope = false, accelerometer = false, magnetometer = false, attitude = false;
    size_t rows = 0;
    size_t missing = 0;  ///< rows with neither rate, acceleration nor attitude
    double duration_s = 0;
};

SensorFindings findingsOf(const ImportedSensor& sensor);

}  // namespace noctule
