// SPDX-License-Identifier: Apache-2.0
#include "ui/views/report/full_report.h"

#include "core/processing/evaluate_take.h"

namespace noctule::ui {

FullReport::FullReport(ReviewContext& review, QObject* parent) : QObject(parent), review_(review) {
    connect(&review.take(), &TakeDocument::opened, this, &FullReport::outdate);
    connect(&review.take(), &TakeDocument::runsChanged, this, [this] {
        if (review_.take().shownRun() != shown_)
            outdate();
    });
    connect(&review.take(), &TakeDocument::reportChanged, this, &FullReport::consider);
}

void FullReport::outdate() {
    if (job_)
        job_->cancel();
    job_.clear();  // until it has ended it would keep the next one from beginning
    ++ticket_;
    shown_ = review_.take().shownRun();
    failed_ = false;
    if (std::exchange(data_, nullptr))
        emit changed();
    consider();
}

void FullReport::consider() {
    const auto overview = review_.take().overview();
    if (overview && overview->has_reference && review_.take().report())
        need();
}

void FullReport::need() {
    TakeDocument& take = review_.take();
    if (data_ || failed_ || (job_ && job_->state() == Job::State::kRunning) || take.shownRun() < 0)
        return;
    EvaluateRequest request;
    request.take_path = take.path().toStdString();
    request.run_number = take.overview()->runs[static_cast<size_t>(take.shownRun())].run.run;
    request.suit = take.overview()->suit_in_view;
    request.all_runs = true;
    job_ = review_.shared().jobs().start<ReportData>(
        tr("Comparing all results"), [request](const JobContext& job) { return evaluateTake(request, job); },
        [self = QPointer(this), ticket = ticket_](Result<ReportData> data) -> QString {
            if (!self || self->ticket_ != ticket)
                return {};
            self->failed_ = !data.ok();
            if (data)
                self->data_ = std::make_shared<const ReportData>(std::move(*data));
            emit self->changed();
            return {};
        },
        Jobs::Loudness::kQuiet);
}

std::optional<double> FullReport::meanError_deg(int run) const {
    if (data_ && run < static_cast<int>(data_->runs.size())) {
        const auto& comparison = data_->runs[static_cast<size_t>(run)].comparison;
        return comparison ? std::optional(comparison->mean_deg) : std::nullopt;
    }
    const auto verdict = run == review_.take().shownRun() ? review_.take().verdict() : nullptr;
    return verdict ? verdict->mean_error_deg : std::nullopt;
}

}  // namespace noctule::ui
