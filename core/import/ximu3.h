// SPDX-License-Identifier: Apache-2.0
// What one x-IMU3 device recorded, and its byte stream.
#pragma once

#include <string_view>
#include <vector>

#include "core/import/ximu3_commands.h"
#include "core/job/job.h"

namespace noctule {

/// Rows of equal width under instants, in the device's units.
struct Ximu3Table {
    std::vector<double> time_s;
    std::vector<double> values;

    void add(double time, const double* row, size_t width);
    size_t rows() const { return time_s.size(); }
    const double* row(size_t i, size_t width) const { return values.data() + i * width; }
};

struct Ximu3Device {
    Ximu3Table inertial;      ///< deg/s, g
    Ximu3Table magnetometer;  ///< the device's own unit
    Ximu3Table quaternion;    ///< w x y z, sensor to earth
    Ximu3Table matrix;        ///< row by row
    /// As `quaternion`, from Euler angles, or from accelerations, which older firmware sends behind a
    /// quaternion. A device sends its attitude in one kind of messages only.
    Ximu3Table other_attitude;
    Ximu3Settings settings;  ///< as the device states them
    size_t damaged = 0;      ///< messages that could not be read
    bool cut = false;        ///< the last message has no end
};

/// Adds roll, pitch and yaw in degrees (turns about z, y, x), or what begins with w, x, y, z, as a
/// quaternion.
void addOtherAttitude(Ximu3Table& attitude, double time_s, const double* values, bool are_angles);

/// Messages end with 0x0A. Text: letter, microseconds, values. Binary: letter | 0x80, u64 microseconds, f32
/// values, with 0x0A and 0xDB stuffed. Answers to commands are lines of JSON. Messages of other kinds are
/// skipped.
Result<Ximu3Device> parseXimu3(std::string_view bytes, const JobContext& job);

}  // namespace noctule
