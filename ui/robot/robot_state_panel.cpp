// SPDX-License-Identifier: Apache-2.0
#include "ui/robot/robot_state_panel.h"

#include <QBoxLayout>
#include <QPointer>

#include "ui/robot/joint_bars.h"
#include "ui/robot/robot_words.h"
#include "ui/style/words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/label.h"
#include "ui/widgets/problem_card.h"
#include "ui/widgets/section_header.h"
#include "ui/widgets/verdict_header.h"

namespace noctule::ui {
namespace {

/// So long the clutch is out before postures are compared anew; some steps of the drive.
constexpr int kClutchOut_ms = 100;

const robot::DriveOutput* outputOf(const RobotDrive& drive) {
    return drive.moments().empty() ? nullptr : &drive.moments().back().output;
}

}  // namespace

RobotStatePanel::RobotStatePanel(RobotDrive& drive, QWidget* parent)
    : QWidget(parent), drive_(drive), verdict_(new VerdictHeader), joints_(new JointBars) {
    auto* column = makeColumn(this);
    addRow(column, 0, {12, 16, 12, 12})->addWidget(verdict_);
    auto* head = addRow(column, 0, {12, 0, 12, 4});
    head->addWidget(new SectionHeader(tr("Joints"), tr("achieved, commanded")));
    joints_head_ = head->parentWidget();
    column->addWidget(joints_);
    auto* problems = new QWidget;
    problems_ = makeColumn(problems, {12, 12, 12, 12}, 8);
    column->addWidget(problems);
    column->addStretch();
    auto* foot = new QWidget;
    auto* foot_column = makeColumn(foot, {12, 8, 12, 12}, 4);
    way_on_ = makeButton(ButtonKind::kPrimary, tr("Connect"));
    foot_column->addWidget(way_on_);
    way_about_ = new Label({}, TextRole::kSecondary, Ink::kHint);
    foot_column->addWidget(way_about_->wrapped());
    column->addWidget(foot);
    connect(way_on_, &QPushButton::clicked, this, &RobotStatePanel::goOn);
    const auto all = [this] {
        showState();
        showProblem();
        showWayOn();
    };
    connect(&drive, &RobotDrive::wordChanged, this, all);
    connect(&drive, &RobotDrive::linkChanged, this, all);
    connect(&drive, &RobotDrive::keysChanged, this, all);
    const auto show_robot = [this, all] {
        joints_->setParts(drive_.parts());
        joints_head_->setVisible(drive_.parts() && !drive_.parts()->axes.empty());
        all();
    };
    connect(&drive, &RobotDrive::robotChanged, this, show_robot);
    connect(&drive, &RobotDrive::ticked, this, [this, all] {
        showJoints();
        all();
    });
    show_robot();
}

void RobotStatePanel::showState() {
    QString title = nameOf(drive_.word()), text;
    Tone tone = toneOf(drive_.word());
    if (!drive_.hasRobot()) {
        title = tr("No robot");
        text = tr("Choose one, and it appears here.");
    } else if (drive_.link() == RobotDrive::Link::kOff) {
        title = tr("Not connected");
        tone = Tone::kNeutral;
        text = tr("The robot gets no commands from here.");
    } else if (drive_.link() == RobotDrive::Link::kConnecting) {
        title = tr("Looking for the robot");
        tone = Tone::kNeutral;
        text = tr("It has not sent its joint angles yet.");
    } else {
        switch (drive_.word()) {
            case RobotWord::kNotSynchronised:
                text = drive_.deadMan() && drive_.clutch()
                           ? tr("Bring your arms to the robot’s posture. The outline shows yours.")
                           : tr("Hold F8 with the clutch in: your posture is compared with the robot’s.");
                break;
            case RobotWord::kReady:
                text =
                    tr("Every joint is near enough. Press Follow (A) when nobody is in reach of the robot.");
                break;
            case RobotWord::kFollowing:
                text = tr("The robot moves as the performer does.");
                break;
            case RobotWord::kHolding:
                title = drive_.holdingReason().isEmpty()
                            ? nameOf(RobotWord::kHolding)
                            : tr("%1: %2", "state of the robot: reason")
                                  .arg(nameOf(RobotWord::kHolding), drive_.holdingReason());
                text = tr("The robot stands where it is.");
                break;
        }
        const auto* output = outputOf(drive_);
        if (output && problemOf(*output).is_error)
            tone = Tone::kError;
    }
    verdict_text_ = title + "\n" + text;
    verdict_->setVerdict(tone, title, text);
}

void RobotStatePanel::showJoints() {
    if (drive_.moments().empty())
        return;
    const RobotMoment& newest = drive_.moments().back();
    const bool follows = drive_.word() == RobotWord::kFollowing;
    joints_->show(newest.actual,
                  follows || newest.output.ghost.empty() ? newest.output.q : newest.output.ghost);
}

void RobotStatePanel::showProblem() {
    const auto* output = outputOf(drive_);
    const RobotProblem problem =
        output && drive_.link() != RobotDrive::Link::kOff ? problemOf(*output) : RobotProblem{};
    if (problem_ && (problem.title.isEmpty() || problem.is_error != problem_is_error_)) {
        problem_->deleteLater();
        problem_ = nullptr;
    }
    if (problem.title.isEmpty())
        return;
    if (!problem_) {
        problem_is_error_ = problem.is_error;
        problem_ =
            new ProblemCard(problem.is_error ? Tone::kError : Tone::kWarn, problem.title, problem.text);
        problems_->addWidget(problem_);
    }
    problem_->setTexts(problem.title, problem.text);
}

void RobotStatePanel::showWayOn() {
    const auto* output = outputOf(drive_);
    const bool is_off = drive_.link() == RobotDrive::Link::kOff;
    const bool is_stopped = !is_off && output && output->state == robot::TeleopState::kStopped;
    QString words = tr("Follow"),
            about = tr("Within a second the robot takes the performer’s posture and follows."), lack;
    if (is_off) {
        words = tr("Connect");
        about = tr("The robot stands still until you press Follow.");
        lack = drive_.hasRobot() ? QString() : tr("Choose a robot first.");
    } else if (is_stopped) {
        words = tr("Release the stop");
        about = tr("Then hold F8, bring your arms near, and press Follow.");
    } else if (drive_.word() == RobotWord::kFollowing) {
        words = tr("Synchronise again");
        about = tr("The robot holds, and you see how far each joint is from yours.");
    } else if (drive_.word() != RobotWord::kReady) {
        lack = tr("Hold F8 with the clutch in, and bring your arms near to the robot’s posture.");
    }
    way_on_->setText(words);
    way_on_->setDisabledBecause(lack);
    way_about_->setText(lack.isEmpty() ? about : lack);
}

void RobotStatePanel::goOn() {
    const auto* output = outputOf(drive_);
    if (drive_.link() == RobotDrive::Link::kOff)
        return drive_.connectRobot();
    if (output && output->state == robot::TeleopState::kStopped)
        return drive_.reset();
    if (drive_.word() != RobotWord::kFollowing)
        return drive_.accept();
    drive_.setClutch(false);
    QTimer::singleShot(kClutchOut_ms, &drive_, [drive = &drive_] { drive->setClutch(drive->deadMan()); });
}

}  // namespace noctule::ui
