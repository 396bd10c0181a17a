// SPDX-License-Identifier: Apache-2.0
// A recording of another maker's sensors as it was read, before it becomes a take: SI units, each sensor's
// own frame, attitudes in our world.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/timed_poses.h"
#include "core/orientation/imu_samples.h"

namespace noctule {

struct ImportedSensor {
    std::string id;      ///< as the file names it
    ImuSamples samples;  ///< a quantity that the file lacks is NaN in every row
    /// The maker's own attitudes; empty, or one per row. NaN: missing.
    std::vector<Quaterniond> q_world_sensor{};
    double offset_s = 0;    ///< first row after the recording's start; 0 or more
    std::string segment{};  ///< canonical joint that the name means; empty: not known
};

struct ImportedRecording {
    std::string name;
    std::vector<ImportedSensor> sensors;
    double start_s = 0;  ///< instant of the first row on the recording's own clock

    // An optical system's word on the only sensor, in our world frame; empty, or one per row. NaN: not seen.
    std::vector<Quaterniond> q_world_sensor;
    std::vector<Vector3d> p_world_sensor_m;
    std::vector<char> moves;  ///< rows of a phase that is meant to be scored; empty: all

    /// What the file's own method made of the whole body; times from the recording's start.
    std::optional<TimedMotion> reference{};

    std::string format{};                 ///< name in importFormats()
    std::vector<std::string> notes{};     ///< what the file states: units, axes, rate; one sentence each
    std::vector<std::string> warnings{};  ///< what was converted, assumed or is odd, one sentence each
};

}  // namespace noctule
