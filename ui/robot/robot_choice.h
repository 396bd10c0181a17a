// SPDX-License-Identifier: Apache-2.0
// Which robot is driven, where it answers and how it follows; kept in the settings.
#pragma once

#include <QSettings>
#include <QString>

#include "core/robot/motion_mapping.h"

namespace noctule::ui {

enum class DrivenBody { kBothArms, kLeftArm, kRightArm, kUpperBody };

struct RobotChoice {
    QString urdf;
    QString profile;  ///< a JSON file; empty: the shipped one of the robot's name, else made from the URDF
    QString address;  ///< "udp://10.0.0.5:41950", "ws://10.0.0.5:9090"
    DrivenBody body = DrivenBody::kBothArms;  ///< the upper body: both arms and the trunk
    bool follows_posture = true;              ///< false: the hand's way from where it engaged
    double speed = 0.4;                       ///< share of the joints' limits
    double accept_within_rad = radians(20);

    bool isEmpty() const { return urdf.isEmpty(); }
    robot::MappingChoice mapping() const {
        robot::MappingChoice choice;
        choice.left = body != DrivenBody::kRightArm;
        choice.right = body != DrivenBody::kLeftArm;
        choice.trunk = body == DrivenBody::kUpperBody;
        return choice;
    }
};

/// Numbers out of their range become the usual ones.
RobotChoice loadRobot(QSettings& settings);
void saveRobot(QSettings& settings, const RobotChoice& choice);

}  // namespace noctule::ui
