// SPDX-License-Identifier: Apache-2.0
// One job of the panel.
#pragma once

#include <QLabel>
#include <QWidget>

#include "ui/jobs/jobs.h"

namespace noctule::ui {

class Label;
class ProgressLine;

class JobRow : public QWidget {
    Q_OBJECT
public:
    explicit JobRow(Job& job, QWidget* parent = nullptr);

private:
    void follow();

    Job& job_;
    ProgressLine* progress_;
    QWidget* ended_;
    QLabel* icon_;
    Label *title_, *outcome_;
};

}  // namespace noctule::ui
