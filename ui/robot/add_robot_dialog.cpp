// SPDX-License-Identifier: Apache-2.0
#include "ui/robot/add_robot_dialog.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QDialog>
#include <QFileInfo>
#include <QLineEdit>

#include "devices/robot/robot_interface.h"
#include "ui/language/core_words.h"
#include "ui/models/file_choice.h"
#include "ui/robot/robot_words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/label.h"
#include "ui/widgets/tool_button.h"

namespace noctule::ui {
namespace {

constexpr const char* kSchemes[] = {"ws://", "udp://"};
constexpr const char* kUsualAddresses[] = {"127.0.0.1:9090", "127.0.0.1:41950"};

}  // namespace

AddRobotDialog::AddRobotDialog(const RobotChoice& choice, QWidget* parent)
    : DialogFrame(tr("Robot"),
                  tr("A robot is described by its URDF file. Robots hurt people: keep an emergency stop in "
                     "reach that does not depend on this program."),
                  tr("Connect the robot"), parent),
      before_(choice),
      urdf_(new QLineEdit(choice.urdf)),
      profile_(new QLineEdit(choice.profile)),
      address_(new QLineEdit),
      interface_(new QComboBox),
      body_(new QComboBox),
      follows_(new QComboBox) {
    auto* rows = new FormRows(110);
    rows->addRow(tr("URDF"), fileField(urdf_, tr("URDF"), tr("Robot descriptions (*.urdf);;All files (*)")));
    rows->addRow(tr("Profile"), fileField(profile_, tr("Profile"), tr("Profiles (*.json)")));
    profile_->setPlaceholderText(tr("found by the robot’s name"));
    rows->addHint(
        tr("Robonaut 2, Unitree G1 and H1, Panda, UR5 and Baxter have a profile of their own; for "
           "others one is made from the URDF."));
    interface_->addItem(tr("rosbridge (ROS)"));
    interface_->addItem(tr("UDP"));
    rows->addRow(tr("Interface"), interface_);
    rows->addRow(tr("Address"), address_);
    body_->addItems(bodyChoices());
    rows->addRow(tr("Driven"), body_);
    follows_->addItems({tr("The whole posture"), tr("Path of the hand only")});
    rows->addRow(tr("Follows"), follows_);
    content()->addWidget(rows);
    const bool is_udp = choice.address.startsWith(kSchemes[1]);
    interface_->setCurrentIndex(is_udp ? 1 : 0);
    address_->setText(choice.address.isEmpty() ? QString(kUsualAddresses[0])
                                               : choice.address.section("://", 1));
    body_->setCurrentIndex(static_cast<int>(choice.body));
    follows_->setCurrentIndex(choice.follows_posture ? 0 : 1);
    connect(interface_, qOverload<int>(&QComboBox::activated), this, [this](int index) {
        if (address_->text() == kUsualAddresses[1 - index])
            address_->setText(kUsualAddresses[index]);
    });
    connect(address_, &QLineEdit::textEdited, this, [this](const QString& text) {
        if (text.contains("://"))
            setAddress(text.trimmed());  // as the robot's program prints it
    });
    for (QLineEdit* field : {urdf_, profile_, address_})
        connect(field, &QLineEdit::textChanged, this, [this] { setProblem({}); });
    keepMinimumWidth(*this, 560);
}

QWidget* AddRobotDialog::fileField(QLineEdit* field, const QString& what, const QString& filter) {
    auto* both = new QWidget;
    auto* row = makeRow(both, {}, 8);
    auto* browse = new ToolButton("folder", tr("Choose the file"));
    row->addWidget(field);
    row->addWidget(browse);
    both->setFocusProxy(field);
    field->setAccessibleName(what);
    connect(browse, &QToolButton::clicked, this, [this, field, what, filter] {
        const QString path =
            FileChoice{.kind = "robots", .title = what, .filter = filter, .at = field->text()}.toOpen(this);
        if (!path.isEmpty())
            field->setText(path);
    });
    return both;
}

void AddRobotDialog::setUrdf(const QString& path) {
    urdf_->setText(path);
}

void AddRobotDialog::setAddress(const QString& address) {
    interface_->setCurrentIndex(address.startsWith(kSchemes[1]) ? 1 : 0);
    address_->setText(address.section("://", 1));
}

RobotChoice AddRobotDialog::choice() const {
    RobotChoice choice = before_;
    choice.urdf = urdf_->text().trimmed();
    choice.profile = profile_->text().trimmed();
    choice.address = kSchemes[interface_->currentIndex()] + address_->text().trimmed();
    choice.body = static_cast<DrivenBody>(body_->currentIndex());
    choice.follows_posture = follows_->currentIndex() == 0;
    return choice;
}

QString AddRobotDialog::complaint() const {
    const RobotChoice wanted = choice();
    if (wanted.urdf.isEmpty())
        return tr("Choose the robot’s URDF file.");
    for (const QString& path : {wanted.urdf, wanted.profile})
        if (!path.isEmpty() && !QFileInfo(path).isFile())
            return tr("%1 is not there. Choose another file.").arg(QFileInfo(path).fileName());
    robot_link::LinkOptions options;
    options.joints = {"any"};
    const auto link = robot_link::makeInterface(wanted.address.toStdString(), options);
    return link ? QString() : coreWords(link.error());
}

void AddRobotDialog::accept() {
    const QString problem = complaint();
    setProblem(problem);
    if (problem.isEmpty())
        QDialog::accept();
}

}  // namespace noctule::ui
