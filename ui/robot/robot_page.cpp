// SPDX-License-Identifier: Apache-2.0
#include "ui/robot/robot_page.h"

#include <QApplication>
#include <QKeyEvent>
#include <QStackedWidget>

#include "ui/robot/add_robot_dialog.h"
#include "ui/robot/robot_center.h"
#include "ui/robot/robot_sidebar.h"
#include "ui/robot/robot_state_panel.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/button.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/scroll_area.h"

namespace noctule::ui {

RobotPage::RobotPage(Studio& studio, RobotDrive& drive, QWidget* parent)
    : Page(parent),
      drive_(drive),
      center_(new RobotCenter(studio, drive)),
      sidebar_(new RobotSidebar(drive)),
      state_(new RobotStatePanel(drive)),
      stack_(new QStackedWidget),
      robot_part_(new ScrollArea(center_)),
      left_(new ScrollArea(sidebar_)),
      right_(new ScrollArea(state_)) {
    makeColumn(this)->addWidget(stack_);
    auto* empty = new EmptyState(
        tr("A suit or a take can drive a robot’s arms. The robot appears here once it is chosen."),
        tr("Choose the robot"));
    empty_ = empty;
    stack_->addWidget(robot_part_);
    stack_->addWidget(empty_);
    setFocusPolicy(Qt::ClickFocus);
    setDockTitles(tr("Robot"), tr("Robot state"));
    addActions();
    connect(empty, &EmptyState::activated, this, &RobotPage::chooseRobot);
    connect(sidebar_, &RobotSidebar::changeWanted, this, &RobotPage::chooseRobot);
    connect(&drive, &RobotDrive::robotChanged, this, &RobotPage::showRobot);
    connect(center_, &RobotCenter::suitRecordingWanted, this, &RobotPage::suitRecordingWanted);
    qApp->installEventFilter(this);
    showRobot();
}

RobotPage::~RobotPage() {
    qApp->removeEventFilter(this);
}

void RobotPage::addActions() {
    const auto add = [this](const QString& text, const QKeySequence& key, auto&& act) {
        auto* action = new QAction(text, this);
        action->setShortcut(key);
        connect(action, &QAction::triggered, this, std::forward<decltype(act)>(act));
        QWidget::addAction(action);
        return action;
    };
    add(tr("Choose the robot"), {}, [this] { chooseRobot(); });
    of_robot_ = {
        add(tr("Clutch in or out"), QKeySequence("C"), [this] { drive_.setClutch(!drive_.clutch()); }),
        add(tr("Follow"), QKeySequence("A"), [this] { drive_.accept(); }),
        add(tr("Hold now"), QKeySequence("H"), [this] { drive_.hold(); }),
        add(tr("Stop the robot"), QKeySequence("Esc"), [this] { drive_.stop(); }),
        add(tr("Release the stop"), {}, [this] { drive_.reset(); }),
        add(tr("Record the robot’s commands, or stop"), {}, [this] { center_->record().click(); }),
        add(tr("Export commands"), {}, [this] { center_->exportCommands(); }),
        add(tr("Remove the robot"), {}, [this] { drive_.removeRobot(); })};
}

void RobotPage::showRobot() {
    const bool any = drive_.hasRobot();
    stack_->setCurrentWidget(any ? robot_part_ : empty_);
    for (QAction* action : of_robot_)
        action->setEnabled(any);
}

void RobotPage::enter() {
    setFocus();
}

void RobotPage::leave() {
    drive_.hold();
}

void RobotPage::chooseRobot() {
    drive_.hold();
    AddRobotDialog dialog(drive_.choice(), window());
    if (dialog.exec() == QDialog::Accepted)
        drive_.setRobot(dialog.choice());
}

bool RobotPage::actOnKey(QEvent& event) {
    const auto& key = static_cast<const QKeyEvent&>(event);
    if (key.key() != Qt::Key_F8 || !isVisible())
        return false;
    if (!key.isAutoRepeat())
        drive_.setDeadMan(event.type() == QEvent::KeyPress && !QApplication::activeModalWidget());
    return true;
}

/// The key is let go wherever the keyboard goes.
bool RobotPage::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::KeyPress:
        case QEvent::KeyRelease:
            return actOnKey(*event);
        case QEvent::WindowDeactivate:
            if (watched == window())
                drive_.setDeadMan(false);
            return false;
        default:
            return Page::eventFilter(watched, event);
    }
}

}  // namespace noctule::ui
