// SPDX-License-Identifier: Apache-2.0
// Which robot is driven, where it answers and how it follows; kept in the settings.
#pragma once

#include <QSettings>
#include <QString>

#include "core/robot/motion_mapping.h"

namespace noctule::ui {

enum class DrivenArms { kBoth, kLeft, kRight };

struct RobotChoice {
    QString urdf;
    QString profile;  ///< a JSON file; empty: the shipped one of the robot's name, else made from the URDF
    QString address;  ///< "udp://10.0.0.5:41950", "ws://10.0.0.5:9090"
    DrivenArms arms = DrivenArms::kBoth;
    bool follows_posture = true;  ///< false: the hand's way from where it engaged
    double speed = 0.4;           ///< share of the joints' limits
    double accept_within_rad = radians(20);

    bool isEmpty() const { return urdf.isEmpty(); }
    robot::MappingChoice mapping() const {
        robot::MappingChoice choice;
        choice.left = arms != DrivenArms::kRight;
        choice.right = arms != DrivenArms::kLeft;
        return choice;
    }
};

/// Numbers out of their range become the usual ones.
RobotChoice loadRobot(QSettings& settings);
void saveRobot(QSettings& settings, const RobotChoice& choice);

}  // namespace noctule::ui
