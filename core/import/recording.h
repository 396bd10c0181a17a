// SPDX-License-Identifier: Apache-2.0
// A recording of another maker's sensors as it was read, before it becomes a take: SI units, each sensor's
// own frame.
#pragma once

#include <string>
#include <vector>

#include "core/orientation/imu_samples.h"

namespace noctule {

struct ImportedSensor {
    std::string id;  ///< as the file names it
    ImuSamples samples;
};

struct ImportedRecording {
    std::string name;
    std::vector<ImportedSensor> sensors;
    double start_s = 0;  ///< instant of the first row on the recording's own clock

    // An optical system's word on the only sensor, in our world frame; empty, or one per row. NaN: not seen.
    std::vector<Quaterniond> q_world_sensor;
    std::vector<Vector3d> p_world_sensor_m;
    std::vector<char> moves;  ///< rows of a phase that is meant to be scored; empty: all

    std::vector<std::string> warnings;  ///< what was converted or is odd, one sentence each
};

}  // namespace noctule
