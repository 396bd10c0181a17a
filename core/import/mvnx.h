// SPDX-License-Identifier: Apache-2.0
// The XML of Xsens MVN (MVNX, versions 3 and 4), parsed frame by frame.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/job/job.h"

namespace noctule {

struct MvnxJoint {
    std::string label, parent, child;  ///< segments
};

/// Children of one frame that are read, each as many numbers as the file's counts ask for, or none.
struct MvnxFrame {
    std::string type;                                       ///< identity, tpose, npose, normal
    double index = -1, time_ms = -1;                        ///< -1: not stated
    std::vector<double> orientation, position;              ///< 4 and 3 per segment; w x y z, metres
    std::vector<double> sensor_orientation;                 ///< 4 per sensor
    std::vector<double> free_acceleration, magnetic_field;  ///< 3 per sensor, of the world and of the sensor
};

struct MvnxFile {
    std::string version;
    double rate_hz = 0;
    std::vector<std::string> segments, sensors;
    std::vector<MvnxJoint> joints;
    std::vector<MvnxFrame> poses;     ///< identity and the like
    std::vector<MvnxFrame> frames;    ///< the motion
    std::vector<std::string> unread;  ///< elements of frames that are not imported
    bool cut = false;                 ///< it ends in the middle; whole frames before that are there
};

/// kUnreadable: no MVNX, damaged XML, a document type (none is ever expanded), an element whose count of
/// numbers does not fit; the message names line or frame and element.
Result<MvnxFile> parseMvnx(std::string_view bytes, const std::string& where, const JobContext& job);

}  // namespace noctule
