// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/question.h"

#include <QMessageBox>
#include <QPushButton>

namespace noctule::ui {

bool isAnsweredYes(const Question& question, QWidget* parent) {
    QMessageBox box(parent);
    box.setWindowTitle(question.title);
    box.setText(question.text);
    box.setInformativeText(question.detail);
    QPushButton* no = box.addButton(question.no, QMessageBox::RejectRole);
    const QPushButton* yes = box.addButton(question.yes, QMessageBox::AcceptRole);
    box.setDefaultButton(no);
    box.setEscapeButton(no);
    box.exec();
    return box.clickedButton() == yes;
}

}  // namespace noctule::ui
