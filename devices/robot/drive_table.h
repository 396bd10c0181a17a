// SPDX-License-Identifier: Apache-2.0
// The commands of a drive and the robot's states beside them, as CSV (README.md).
#pragma once

#include <string>
#include <utility>

#include "devices/robot/drive_loop.h"

namespace noctule::robot_link {

class DriveTable {
public:
    /// Rows at most: two hours at 140 commands a second.
    static constexpr int64_t kMostRows = 1'000'000;

    explicit DriveTable(const std::vector<std::string>& joints);

    void add(const DriveMoment& moment);
    const std::string& text() const { return text_; }
    /// What came since the last call.
    std::string takeText() { return std::exchange(text_, {}); }

private:
    int64_t rows_ = 0;
    std::string text_;
};

}  // namespace noctule::robot_link
