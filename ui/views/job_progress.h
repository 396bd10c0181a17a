// SPDX-License-Identifier: Apache-2.0
// Progress of one job in place, with Cancel; after it a line that says what went wrong. Nothing is shown for
// jobs that are done within a second.
#pragma once

#include <QPointer>
#include <QTimer>
#include <QWidget>

#include "ui/jobs/jobs.h"

namespace noctule::ui {

class Label;
class ProgressLine;

class JobProgress : public QWidget {
    Q_OBJECT
public:
    explicit JobProgress(QWidget* parent = nullptr);

    void follow(Job* job);
    Job* job() const { return job_; }
    bool isRunning() const { return job_ && job_->state() == Job::State::kRunning; }

signals:
    void ended();  ///< also when it failed or was cancelled

private:
    void refresh();
    void finish();

    QPointer<Job> job_;
    ProgressLine* line_;
    Label* error_;
    QTimer patience_;
};

}  // namespace noctule::ui
