// SPDX-License-Identifier: Apache-2.0
// How the suit is put on: the body with every board and source in its place, and the order in which to do it.
#pragma once

#include <QDialog>

namespace noctule::ui {

class Studio;

class PutOnDialog : public QDialog {
    Q_OBJECT
public:
    explicit PutOnDialog(Studio& studio, QWidget* parent = nullptr);

private:
    QWidget* makeSteps();
};

}  // namespace noctule::ui
