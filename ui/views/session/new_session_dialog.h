// SPDX-License-Identifier: Apache-2.0
// Asks for what a session needs: name, folder, who performs and how tall. What is wrong is said beside the
// field.
#pragma once

#include <QDialog>

class QLineEdit;
class QVBoxLayout;

namespace noctule::ui {

class Button;
class Label;
class LengthBox;
class SharedContext;

class NewSessionDialog : public QDialog {
    Q_OBJECT
public:
    explicit NewSessionDialog(SharedContext& shared, QWidget* parent = nullptr);

    QString sessionName() const;
    QString folder() const;
    QString performerName() const;
    double height_m() const;

public slots:
    void accept() override;  ///< makes the session; stays open with words when that fails

private:
    void buildFields(QVBoxLayout& column);
    void followName();
    void chooseFolder();
    void check();
    bool showProblem(const QString& problem);
    QString problemOfFolder() const;

    SharedContext& shared_;
    QLineEdit *name_, *folder_, *performer_;
    LengthBox* height_;
    Label* problem_;
    Button* create_;
    bool folder_edited_ = false;
};

}  // namespace noctule::ui
