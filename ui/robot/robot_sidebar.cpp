// SPDX-License-Identifier: Apache-2.0
#include "ui/robot/robot_sidebar.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSignalBlocker>
#include <QSlider>
#include <QStandardItemModel>

#include "ui/robot/robot_words.h"
#include "ui/style/lengths.h"
#include "ui/style/words.h"
#include "ui/views/number_rows.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/divider.h"
#include "ui/widgets/label.h"
#include "ui/widgets/problem_card.h"
#include "ui/widgets/section_header.h"

namespace noctule::ui {
namespace {

constexpr size_t kShownSpells = 5;

QString linkInWords(RobotDrive::Link link) {
    switch (link) {
        case RobotDrive::Link::kOff:
            return RobotSidebar::tr("not connected");
        case RobotDrive::Link::kConnecting:
            return RobotSidebar::tr("looking for the robot");
        case RobotDrive::Link::kAnswers:
            return RobotSidebar::tr("answers");
        case RobotDrive::Link::kSilent:
            return RobotSidebar::tr("does not answer");
    }
    return {};
}

Ink inkOf(RobotDrive::Link link) {
    return link == RobotDrive::Link::kAnswers  ? Ink::kOk
           : link == RobotDrive::Link::kSilent ? Ink::kError
                                               : Ink::kHint;
}

}  // namespace

RobotSidebar::RobotSidebar(RobotDrive& drive, QWidget* parent) : QWidget(parent), drive_(drive) {
    auto* column = makeColumn(this);
    column->addWidget(makeRobot());
    column->addWidget(new Divider);
    column->addWidget(makeLeading());
    column->addWidget(new Divider);
    column->addWidget(makeSpeed());
    column->addWidget(new Divider);
    column->addWidget(makeLimits());
    column->addWidget(new Divider);
    auto* history = new QWidget;
    auto* lines = makeColumn(history, {12, 8, 12, 12}, 4);
    lines->addWidget(new SectionHeader(tr("In this session")));
    spells_ = new Label({}, TextRole::kSecondary, Ink::kLabel);
    lines->addWidget(spells_->wrapped());
    column->addWidget(history);
    column->addStretch();
    connectFields();
    showRobot();
    showLink();
    showLeader();
    showSpells();
}

QWidget* RobotSidebar::makeRobot() {
    auto* part = new QWidget;
    robot_column_ = makeColumn(part, {12, 12, 12, 12}, 8);
    auto* card = new Card;
    card->setSelected(true);
    auto* lines = makeColumn(card, {12, 10, 12, 10}, 4);
    name_ = new Label({}, TextRole::kBody, Ink::kValue, true);
    answers_ = new Label({}, TextRole::kSecondary, Ink::kHint);
    about_ = new Label({}, TextRole::kSecondary, Ink::kLabel);
    lines->addWidget(name_->wrapped());
    lines->addWidget(answers_->wrapped());
    lines->addWidget(about_->wrapped());
    robot_column_->addWidget(card);
    connect_ = makeButton(ButtonKind::kOutlined, tr("Connect"), "link");
    robot_column_->addWidget(connect_);
    change_ = makeButton(ButtonKind::kText, tr("Choose another robot"), "edit");
    remove_ = makeButton(ButtonKind::kText, tr("Remove the robot"), "trash");
    robot_column_->addWidget(change_, 0, Qt::AlignLeft);
    robot_column_->addWidget(remove_, 0, Qt::AlignLeft);
    return part;
}

QWidget* RobotSidebar::makeLeading() {
    auto* part = new QWidget;
    auto* column = makeColumn(part, {12, 8, 12, 12}, 8);
    column->addWidget(new SectionHeader(tr("Led by")));
    const auto add = [&](const QString& name, const QStringList& choices) {
        auto* box = new QComboBox;
        box->addItems(choices);
        box->setAccessibleName(name);
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(12);
        column->addWidget(box);
        return box;
    };
    leader_ = add(tr("Led by"), {tr("The suit, live"), tr("The take in Review")});
    body_ = add(tr("Driven"), bodyChoices());
    follows_ = add(tr("Follows"), {tr("The whole posture"), tr("Path of the hand only")});
    lengths_ = new Label({}, TextRole::kSecondary, Ink::kLabel);
    column->addWidget(lengths_->wrapped());
    return part;
}

QWidget* RobotSidebar::makeSpeed() {
    auto* part = new QWidget;
    auto* column = makeColumn(part, {12, 8, 12, 12}, 4);
    auto* header = new SectionHeader(tr("Speed of the robot"));
    speed_text_ = new Label({}, TextRole::kSecondary, Ink::kValue);
    header->addTrailing(speed_text_);
    column->addWidget(header);
    speed_ = new QSlider(Qt::Horizontal);
    speed_->setRange(10, 100);
    speed_->setPageStep(10);
    speed_->setAccessibleName(tr("Speed of the robot"));
    column->addWidget(speed_);
    fastest_ = new Label({}, TextRole::kCaption, Ink::kHint);
    column->addWidget(fastest_->wrapped());
    return part;
}

QWidget* RobotSidebar::makeLimits() {
    auto* part = new QWidget;
    auto* column = makeColumn(part, {12, 8, 12, 12}, 4);
    column->addWidget(new SectionHeader(tr("It begins to follow when")));
    auto* row = addRow(column);
    row->addWidget((new Label(tr("each joint is within"), TextRole::kSecondary, Ink::kLabel))->wrapped(), 1);
    within_ = new QDoubleSpinBox;
    within_->setRange(1, 90);
    within_->setDecimals(0);
    within_->setSuffix(QStringLiteral("°"));
    within_->setAccessibleName(tr("Largest distance of a joint at which following can begin"));
    row->addWidget(within_);
    column->addWidget(new SectionHeader(tr("The robot holds by itself when")));
    auto* rows = new NumberRows;
    const robot::DriveSettings usual;
    rows->setValue(rows->addRow("clock", tr("no pose for")), millisecondsText(usual.teleop.stale_s));
    rows->setValue(rows->addRow("link", tr("no answer for")), millisecondsText(usual.robot_stale_s));
    rows->setValue(rows->addRow("angle", tr("joint off by")), degreesText(usual.off_rad, 0));
    column->addWidget(rows);
    return part;
}

void RobotSidebar::connectFields() {
    connect(connect_, &QPushButton::clicked, this, [this] {
        if (drive_.link() == RobotDrive::Link::kOff)
            drive_.connectRobot();
        else
            drive_.disconnectRobot();
    });
    connect(change_, &QPushButton::clicked, this, &RobotSidebar::changeWanted);
    connect(remove_, &QPushButton::clicked, &drive_, &RobotDrive::removeRobot);
    connect(leader_, qOverload<int>(&QComboBox::activated), this,
            [this](int index) { drive_.setLeader(static_cast<RobotDrive::Leader>(index)); });
    for (QComboBox* box : {body_, follows_})
        connect(box, qOverload<int>(&QComboBox::activated), this, &RobotSidebar::choose);
    connect(within_, &QDoubleSpinBox::editingFinished, this, &RobotSidebar::choose);
    connect(speed_, &QSlider::valueChanged, this, [this](int percent) {
        drive_.setSpeed(percent / 100.0);
        showLeader();
    });
    connect(&drive_, &RobotDrive::robotChanged, this, &RobotSidebar::showRobot);
    connect(&drive_, &RobotDrive::robotChanged, this, &RobotSidebar::showLeader);
    connect(&drive_, &RobotDrive::linkChanged, this, &RobotSidebar::showLink);
    connect(&drive_, &RobotDrive::leaderChanged, this, &RobotSidebar::showLeader);
    connect(&drive_, &RobotDrive::wordChanged, this, &RobotSidebar::showSpells);
}

/// Another arm or another way to follow: the robot is let go, read and connected anew.
void RobotSidebar::choose() {
    RobotChoice choice = drive_.choice();
    choice.body = static_cast<DrivenBody>(body_->currentIndex());
    choice.follows_posture = follows_->currentIndex() == 0;
    choice.accept_within_rad = radians(within_->value());
    const RobotChoice& before = drive_.choice();
    const bool is_same = choice.body == before.body && choice.follows_posture == before.follows_posture &&
                         std::abs(choice.accept_within_rad - before.accept_within_rad) < 1e-9;
    if (!is_same)
        drive_.setRobot(choice);
}

void RobotSidebar::showRobot() {
    const RobotChoice& choice = drive_.choice();
    const QSignalBlocker no_speed(speed_), no_within(within_);
    body_->setCurrentIndex(static_cast<int>(choice.body));
    follows_->setCurrentIndex(choice.follows_posture ? 0 : 1);
    within_->setValue(degrees(choice.accept_within_rad));
    speed_->setValue(static_cast<int>(std::lround(100 * choice.speed)));
    const auto parts = drive_.parts();
    name_->setText(parts ? robotInWords(parts->model.name) : tr("Robot"));
    if (auto* items = qobject_cast<QStandardItemModel*>(body_->model()))
        items->item(static_cast<int>(DrivenBody::kUpperBody))
            ->setEnabled(!parts || !parts->profile.trunk_joints.empty());
    const QString joints =
        parts ? tr("%n joint(s) driven", nullptr, static_cast<int>(parts->joints.size())) : QString();
    about_->setText(joints.isEmpty() ? choice.address
                                     : tr("%1\n%2", "address, joints").arg(choice.address, joints));
    setEnabled(drive_.hasRobot());
    showLink();
}

void RobotSidebar::showLink() {
    const RobotDrive::Link link = drive_.link();
    answers_->setText(linkInWords(link));
    answers_->setInk(inkOf(link));
    connect_->setText(link == RobotDrive::Link::kOff ? tr("Connect") : tr("Disconnect"));
    const QString& trouble = drive_.trouble();
    if (problem_ && trouble.isEmpty()) {
        problem_->deleteLater();
        problem_ = nullptr;
    }
    if (trouble.isEmpty())
        return;
    if (!problem_) {
        problem_ = new ProblemCard(Tone::kError, {}, {});
        robot_column_->insertWidget(1, problem_);
    }
    problem_->setTexts(tr("The robot gets no commands"), trouble);
}

void RobotSidebar::showLeader() {
    leader_->setCurrentIndex(static_cast<int>(drive_.leader()));
    speed_text_->setText(percentText(drive_.choice().speed));
    const auto parts = drive_.parts();
    double fastest = 0;
    for (size_t i = 0; parts && i < parts->speeds.size(); ++i)
        fastest = std::max(fastest, parts->speeds[i]);
    fastest_->setText(
        parts
            ? tr("a joint turns by at most %1 a second").arg(degreesText(drive_.choice().speed * fastest, 0))
            : QString());
    const QString lack = drive_.whyNoLeader();
    QString lengths;
    for (size_t i = 0; parts && i < parts->driven.arms.size() && i < 1; ++i)
        lengths = tr("The robot’s arm is %1 long. The position of your hand is measured from your chest, so "
                     "walking does not move the arm.")
                      .arg(lengthText(parts->driven.arms[i].length_m));
    lengths_->setInk(lack.isEmpty() ? Ink::kLabel : Ink::kWarn);
    lengths_->setText(lack.isEmpty() ? lengths : lack);
}

void RobotSidebar::showSpells() {
    const auto& spells = drive_.spells();
    QStringList lines;
    for (size_t i = spells.size(); i-- > 0 && lines.size() < static_cast<int>(kShownSpells);) {
        const RobotSpell& spell = spells[i];
        const QString what =
            spell.reason.isEmpty()
                ? nameOf(spell.word)
                : tr("%1: %2", "state of the robot: reason").arg(nameOf(spell.word), spell.reason);
        lines << tr("%1  %2", "time, state").arg(clockText(spell.since.time()), what);
    }
    spells_->setText(lines.isEmpty() ? tr("Nothing yet") : lines.join('\n'));
}

}  // namespace noctule::ui
