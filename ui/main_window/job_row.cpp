// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/job_row.h"

#include <QHBoxLayout>

#include "ui/style/ink.h"
#include "ui/views/job_words.h"
#include "ui/views/scaled_layout.h"
#include "ui/widgets/label.h"
#include "ui/widgets/progress_line.h"

namespace noctule::ui {
namespace {

Tone toneOf(Job::State state) {
    switch (state) {
        case Job::State::kDone:
            return Tone::kOk;
        case Job::State::kFailed:
            return Tone::kError;
        default:
            return Tone::kNeutral;
    }
}

}  // namespace

JobRow::JobRow(Job& job, QWidget* parent) : QWidget(parent), job_(job) {
    auto* column = makeColumn(this, {12, 8, 12, 8}, 4);
    progress_ = new ProgressLine;
    column->addWidget(progress_);
    ended_ = new QWidget;
    auto* row = makeRow(ended_, {}, 8);
    icon_ = new QLabel;
    row->addWidget(icon_, 0, Qt::AlignTop);
    auto* words = new QWidget;
    auto* lines = makeColumn(words, {}, 2);
    title_ = new Label(job.title(), TextRole::kBody, Ink::kValue, true);
    title_->wrapped();
    outcome_ = new Label({}, TextRole::kSecondary, Ink::kLabel);
    outcome_->wrapped()->selectable();
    lines->addWidget(title_);
    lines->addWidget(outcome_);
    row->addWidget(words, 1);
    column->addWidget(ended_);
    connect(progress_, &ProgressLine::cancelled, &job, &Job::cancel);
    connect(&job, &Job::changed, this, &JobRow::follow);
    connect(&Theme::get(), &Theme::changed, this, &JobRow::follow);
    follow();
}

void JobRow::follow() {
    const bool running = job_.state() == Job::State::kRunning;
    progress_->setVisible(running);
    ended_->setVisible(!running);
    if (running) {
        progress_->setText(JobWords::progress(job_));
        progress_->setFraction(job_.fraction());
        return;
    }
    const Theme& theme = Theme::get();
    const Tone tone = toneOf(job_.state());
    icon_->setPixmap(theme.pixmap(iconOf(tone), theme.px(16), colorOf(tone)));
    outcome_->setText(job_.outcome());
    outcome_->setVisible(!job_.outcome().isEmpty());
    setAccessibleName(job_.title());
    setAccessibleDescription(job_.outcome());
}

}  // namespace noctule::ui
