// SPDX-License-Identifier: Apache-2.0
// The state of a robot in words, for screens.
#pragma once

#include <QString>
#include <utility>

#include "ui/robot/robot_drive.h"
#include "ui/style/ink.h"

namespace noctule::ui {

struct OperatorHolds {
    bool dead_man = false, clutch = false;
    double accept_within_rad = 0;
};

/// The word, and of kHolding the reason.
std::pair<RobotWord, QString> wordFor(const robot::DriveOutput& output, const OperatorHolds& keys);

QString nameOf(RobotWord word);
QString iconOf(RobotWord word);
Tone toneOf(RobotWord word);

/// What is the matter, of which thing, and what to do; title empty: nothing.
struct RobotProblem {
    QString title, text;
    bool is_error = false;
};
RobotProblem problemOf(const robot::DriveOutput& output);

/// "left_shoulder_pitch_joint" reads "Left shoulder pitch".
QString jointInWords(const std::string& name);
QString robotInWords(const std::string& name);
/// In the order of DrivenBody.
QStringList bodyChoices();

}  // namespace noctule::ui
