// SPDX-License-Identifier: Apache-2.0
// What the verb `drive` tells at its end: as JSON, as a line, and as a page with the hands.
#pragma once

#include "core/recording/robot_rows.h"
#include "core/robot/robot_report.h"
#include "devices/robot/drive_loop.h"

namespace noctule::batch {

/// The hands as they were told and as they went, for the report.
class HandRecord {
public:
    /// `arms` outlive it.
    explicit HandRecord(const std::vector<robot::RobotArm>& arms) : arms_(arms) {
        for (const robot::RobotArm& arm : arms)
            hands_.push_back({arm.profile.name, {}, {}});
    }
    void add(const robot_link::DriveMoment& moment);
    const std::vector<robot::HandPair>& hands() const { return hands_; }

private:
    static constexpr size_t kMostPoints = 1'000'000;
    const std::vector<robot::RobotArm>& arms_;
    std::vector<robot::HandPair> hands_;
    int64_t last_state_ns_ = 0;
};

/// Why the robot did not obey to the end; none: it did.
std::optional<Error> robotTrouble(const robot_link::DriveReport& report, const std::string& address);

/// Of `drive` its robot, address and joints count.
nlohmann::json driveJson(const robot_link::DriveReport& report, const RobotDriveRow& drive,
                         const std::vector<robot::HandPair>& hands);
/// "robot G1: 2378 commands, ...", a line.
std::string driveText(const robot_link::DriveReport& report, const RobotDriveRow& drive);
std::string driveHtml(const robot_link::DriveReport& report, const RobotDriveRow& drive,
                      const std::vector<robot::HandPair>& hands);

}  // namespace noctule::batch
