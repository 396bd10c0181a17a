// SPDX-License-Identifier: Apache-2.0
// The commands of a drive and the robot's states beside them, as CSV (README.md).
#pragma once

#include <string>

#include "core/robot/live_drive.h"
#include "devices/robot/robot_interface.h"

namespace noctule::robot_link {

class DriveTable {
public:
    /// Rows at most: two hours at 140 commands a second.
    static constexpr int64_t kMostRows = 1'000'000;

    explicit DriveTable(const std::vector<std::string>& joints);

    struct Moment {
        int64_t start_ns, now_ns;
        const robot::DriveInput& input;
        int64_t pose_time_ns;
        const LinkStatus& link;
    };
    void add(const Moment& moment, const robot::DriveOutput& output, uint64_t sequence, const char* state);
    const std::string& text() const { return text_; }

private:
    void number(double value);

    size_t joints_;
    int64_t rows_ = 0;
    std::string text_;
};

}  // namespace noctule::robot_link
