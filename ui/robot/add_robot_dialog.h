// SPDX-License-Identifier: Apache-2.0
// Which robot, and where it answers: its URDF, its profile if not the shipped one, interface and address.
#pragma once

#include "ui/robot/robot_choice.h"
#include "ui/views/dialog_frame.h"

class QComboBox;
class QLineEdit;

namespace noctule::ui {

class AddRobotDialog : public DialogFrame {
    Q_OBJECT
public:
    /// `choice`: what stands there at first.
    explicit AddRobotDialog(const RobotChoice& choice, QWidget* parent = nullptr);

    RobotChoice choice() const;
    void setUrdf(const QString& path);
    void setAddress(const QString& address);
    void accept() override;

private:
    QWidget* fileField(QLineEdit* field, const QString& what, const QString& filter);
    QString complaint() const;

    RobotChoice before_;
    QLineEdit *urdf_, *profile_, *address_;
    QComboBox *interface_, *body_, *follows_;
};

}  // namespace noctule::ui
