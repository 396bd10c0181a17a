// SPDX-License-Identifier: Apache-2.0
#include "ui/robot/robot_choice.h"

namespace noctule::ui {
namespace {

double numberWithin(const QSettings& settings, const char* key, double usual, double least, double most) {
    const double value = settings.value(key, usual).toDouble();
    return value >= least && value <= most ? value : usual;
}

}  // namespace

RobotChoice loadRobot(QSettings& settings) {
    RobotChoice choice;
    settings.beginGroup("robot");
    choice.urdf = settings.value("urdf").toString();
    choice.profile = settings.value("profile").toString();
    choice.address = settings.value("address").toString();
    choice.body = static_cast<DrivenBody>(static_cast<int>(numberWithin(settings, "arms", 0, 0, 3)));
    choice.follows_posture = settings.value("follows_posture", true).toBool();
    choice.speed = numberWithin(settings, "speed", choice.speed, 0.05, 1);
    choice.accept_within_rad =
        radians(numberWithin(settings, "accept_within_deg", degrees(choice.accept_within_rad), 1, 90));
    settings.endGroup();
    return choice;
}

void saveRobot(QSettings& settings, const RobotChoice& choice) {
    settings.remove("robot");
    if (choice.isEmpty())
        return;
    settings.beginGroup("robot");
    settings.setValue("urdf", choice.urdf);
    settings.setValue("profile", choice.profile);
    settings.setValue("address", choice.address);
    settings.setValue("arms", static_cast<int>(choice.body));
    settings.setValue("follows_posture", choice.follows_posture);
    settings.setValue("speed", choice.speed);
    settings.setValue("accept_within_deg", degrees(choice.accept_within_rad));
    settings.endGroup();
}

}  // namespace noctule::ui
