// SPDX-License-Identifier: Apache-2.0
#include "ui/robot/robot_words.h"

#include <QCoreApplication>

#include "ui/style/words.h"

namespace noctule::ui {
namespace {

using robot::DriveTrouble;
using robot::TeleopState;

QString said(const char* text) {
    return QCoreApplication::translate("noctule::ui::RobotWords", text);
}

double farthest(const robot::DriveOutput& output) {
    double off_rad = 0;
    for (size_t i = 0; i < std::min(output.q.size(), output.ghost.size()); ++i)
        off_rad = std::max(off_rad, std::abs(output.q[i] - output.ghost[i]));
    return off_rad;
}

QString whyHeld(const robot::DriveOutput& output, const OperatorHolds& keys) {
    if (output.trouble == DriveTrouble::kRobotSilent)
        return said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "the robot does not answer"));
    if (output.trouble == DriveTrouble::kRobotRefuses)
        return said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "the robot refuses commands"));
    if (output.trouble == DriveTrouble::kJointOff)
        return said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "a joint does not follow"));
    if (output.state == TeleopState::kStopped)
        return said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "stopped"));
    if (output.state == TeleopState::kLost || output.trouble == DriveTrouble::kNoPose)
        return said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "no pose of the performer"));
    if (!keys.dead_man)
        return said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "key released"));
    return keys.clutch ? QString() : said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "the clutch is out"));
}

QString readable(QString name) {
    name.replace('_', ' ');
    name = name.simplified();
    if (!name.isEmpty())
        name[0] = name[0].toUpper();
    return name;
}

}  // namespace

std::pair<RobotWord, QString> wordFor(const robot::DriveOutput& output, const OperatorHolds& keys) {
    const bool is_broken = output.trouble <= DriveTrouble::kJointOff;
    switch (output.state) {
        case TeleopState::kSynchronising:
            return {
                farthest(output) <= keys.accept_within_rad ? RobotWord::kReady : RobotWord::kNotSynchronised,
                {}};
        case TeleopState::kBlending:
        case TeleopState::kFollowing:
            return {RobotWord::kFollowing, {}};
        case TeleopState::kIdle:
            if (!is_broken)
                return {RobotWord::kNotSynchronised, {}};
            break;
        case TeleopState::kHolding:
        case TeleopState::kLost:
        case TeleopState::kStopped:
            break;
    }
    return {RobotWord::kHolding, whyHeld(output, keys)};
}

QString nameOf(RobotWord word) {
    switch (word) {
        case RobotWord::kNotSynchronised:
            return said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "Not synchronised"));
        case RobotWord::kReady:
            return said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "Ready"));
        case RobotWord::kFollowing:
            return said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "Following"));
        case RobotWord::kHolding:
            return said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "Holding"));
    }
    return {};
}

QString iconOf(RobotWord word) {
    constexpr const char* kIcons[] = {"swap", "check", "play", "pause"};
    return kIcons[static_cast<size_t>(word)];
}

Tone toneOf(RobotWord word) {
    constexpr Tone kTones[] = {Tone::kNeutral, Tone::kOk, Tone::kOk, Tone::kWarn};
    return kTones[static_cast<size_t>(word)];
}

RobotProblem problemOf(const robot::DriveOutput& output) {
    const QString about = jointInWords(output.about), off = degreesText(output.off_rad, 0);
    switch (output.trouble) {
        case DriveTrouble::kRobotSilent:
            return {said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "The robot does not answer")),
                    said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords",
                                           "It is told to hold. Check its program and the network.")),
                    true};
        case DriveTrouble::kRobotRefuses:
            return {said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "The robot refuses commands")),
                    said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords",
                                           "A command was too far from where it stands. They begin there "
                                           "again: bring your arms near, then press Follow.")),
                    true};
        case DriveTrouble::kJointOff:
            return {said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "%1 does not follow")).arg(about),
                    said(QT_TRANSLATE_NOOP(
                             "noctule::ui::RobotWords",
                             "It is %1 away from its command. Check the joint. Commands begin again where "
                             "the robot stands: bring your arms near, then press Follow."))
                        .arg(off),
                    true};
        case DriveTrouble::kNoPose:
            return {said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "No fresh pose of the performer")),
                    said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords",
                                           "The robot holds. Check the suit and its link.")),
                    false};
        case DriveTrouble::kTooFar:
            return {said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "%1 is %2 from your posture"))
                        .arg(about, off),
                    said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords",
                                           "Bring the arm nearer to the robot’s posture.")),
                    false};
        case DriveTrouble::kTooNear:
            return {said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "Too near to each other")),
                    said(QT_TRANSLATE_NOOP(
                             "noctule::ui::RobotWords",
                             "%1 would touch, so the robot’s arms slow down. Move your arms apart."))
                        .arg(about),
                    false};
        case DriveTrouble::kUncertain:
            return {said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "The pose is uncertain")),
                    said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords",
                                           "The robot moves slowly until the suit is sure again.")),
                    false};
        case DriveTrouble::kOutsideBox:
            return {
                said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "The hand would leave the allowed box")),
                said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords",
                                       "The robot stays at the border of it. Bring your hand back.")),
                false};
        case DriveTrouble::kNone:
            break;
    }
    return {};
}

QString jointInWords(const std::string& name) {
    QString words = QString::fromStdString(name);
    if (words.endsWith("_joint"))
        words.chop(6);
    return readable(words);
}

QString robotInWords(const std::string& name) {
    return readable(QString::fromStdString(name));
}

QStringList bodyChoices() {
    return {said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "Both arms")),
            said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "Left arm")),
            said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "Right arm")),
            said(QT_TRANSLATE_NOOP("noctule::ui::RobotWords", "Both arms and the trunk"))};
}

}  // namespace noctule::ui
