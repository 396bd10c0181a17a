// SPDX-License-Identifier: Apache-2.0
#include "ui/views/job_progress.h"

#include "ui/language/core_words.h"
#include "ui/views/job_words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/label.h"
#include "ui/widgets/progress_line.h"

namespace noctule::ui {

namespace {
constexpr int kPatience_ms = 1000;
}

JobProgress::JobProgress(QWidget* parent)
    : QWidget(parent), line_(new ProgressLine), error_(new Label({}, TextRole::kSecondary, Ink::kError)) {
    auto* column = makeColumn(this);
    column->addWidget(line_);
    column->addWidget(error_->wrapped()->selectable());
    patience_.setSingleShot(true);
    connect(&patience_, &QTimer::timeout, this, [this] {
        show();
        line_->show();
    });
    connect(line_, &ProgressLine::cancelled, this, [this] {
        if (job_)
            job_->cancel();
    });
    hide();
}

void JobProgress::follow(Job* job) {
    if (job_)
        job_->disconnect(this);
    job_ = job;
    patience_.stop();
    hide();
    line_->hide();
    error_->hide();
    if (!job)
        return;
    connect(job, &Job::changed, this, &JobProgress::refresh);
    connect(job, &Job::ended, this, &JobProgress::finish);
    refresh();
    patience_.start(kPatience_ms);
}

void JobProgress::refresh() {
    line_->setText(JobWords::progress(*job_));
    line_->setFraction(job_->fraction());
}

void JobProgress::finish() {
    patience_.stop();
    line_->hide();
    const bool failed = job_ && job_->state() == Job::State::kFailed && job_->error();
    if (failed)
        error_->setText(coreWords(job_->error()->text()));
    error_->setVisible(failed);
    setVisible(failed);
    emit ended();
}

}  // namespace noctule::ui
