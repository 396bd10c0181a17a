// SPDX-License-Identifier: Apache-2.0
#include "ui/jobs/jobs.h"

#include <QPointer>
#include <algorithm>
#include <atomic>
#include <mutex>

#include "ui/language/core_words.h"

namespace noctule::ui {
namespace {

constexpr int kPoll_ms = 50;
constexpr qint64 kQuietFor_ms = 1000;
// More than cores: a view that loads its table must not wait until two takes have been processed.
constexpr int kFewestThreads = 4;

QString inWords(const Error& error) {
    return coreWords(error);
}

}  // namespace

/// What the worker writes and the interface reads.
struct Job::Shared : ProgressSink {
    void progress(double fraction, const std::string& stage) override {
        const std::lock_guard lock(mutex);
        fraction_now = std::clamp(fraction, 0.0, 1.0);
        if (stage_now != stage)
            stage_now = stage;
    }

    CancelFlag cancel;
    std::mutex mutex;
    double fraction_now = 0;
    std::string stage_now;
};

Job::Job(JobTitle title, QObject* parent)
    : QObject(parent), title_(std::move(title)), shared_(std::make_shared<Shared>()) {
    clock_.start();
}

std::optional<int> Job::secondsLeft() const {
    return state_ == State::kRunning ? remaining_.seconds() : std::nullopt;
}

void Job::setSeen() {
    if (seen_)
        return;
    seen_ = true;
    emit changed();
}

void Job::cancel() {
    shared_->cancel.cancel();
}

bool Job::poll() {
    double fraction = 0;
    QString stage;
    {
        const std::lock_guard lock(shared_->mutex);
        fraction = shared_->fraction_now;
        stage = coreWords(shared_->stage_now);
    }
    const auto left_before = remaining_.seconds();
    remaining_.report(static_cast<double>(clock_.elapsed()) * 1e-3, fraction);
    if (fraction == fraction_ && stage == stage_ && left_before == remaining_.seconds())
        return false;
    fraction_ = fraction;
    stage_ = std::move(stage);
    emit changed();
    return true;
}

void Job::end(const Status& status, const QString& outcome) {
    outcome_ = outcome;
    if (status) {
        state_ = State::kDone;
        fraction_ = 1;
    } else {
        error_ = status.error();
        const bool cancelled = error_->kind == ErrorKind::kCancelled;
        state_ = cancelled ? State::kCancelled : State::kFailed;
        if (outcome_.isEmpty())
            outcome_ = cancelled ? tr("Cancelled") : inWords(*error_);
    }
    emit changed();
    emit ended();
}

Jobs::Jobs(QObject* parent) : QObject(parent) {
    pool_.setMaxThreadCount(std::max(kFewestThreads, QThread::idealThreadCount()));
    poll_timer_.setInterval(kPoll_ms);
    connect(&poll_timer_, &QTimer::timeout, this, &Jobs::poll);
}

Jobs::~Jobs() {
    for (const auto* list : {&jobs_, &quiet_})
        for (Job* job : *list)
            job->cancel();
    // What the workers post meanwhile goes with this object's event queue: no `done` runs any more.
    pool_.waitForDone();
}

Error Jobs::brokenPromise(std::exception_ptr thrown) {
    std::string what = "unknown";
    try {
        std::rethrow_exception(std::move(thrown));
    } catch (const std::exception& mistake) {
        what = mistake.what();
    } catch (...) {
        // Not ours: nothing can be said about it.
    }
    return {ErrorKind::kInternal, tr("The studio made a mistake: %1").arg(what.c_str()).toStdString(),
            tr("Nothing was changed. Report it together with the take").toStdString()};
}

Job* Jobs::startUntyped(const JobTitle& title, std::function<void(const JobContext&)> work,
                        std::function<void(Job*, const End&)> tell, Loudness loudness) {
    auto* job = new Job(title, this);
    job->quiet_ = loudness == Loudness::kQuiet;
    ++unfinished_;
    if (job->quiet_)
        quiet_.push_back(job);
    else
        show(job);
    pool_.start(
        [this, job, shared = job->shared_, work = std::move(work), tell = std::move(tell)]() mutable {
            work({shared.get(), &shared->cancel});
            work = nullptr;  // what it holds goes here and not on the interface's thread
            QMetaObject::invokeMethod(
                this, [this, job, tell = std::move(tell)] { finish(job, tell); }, Qt::QueuedConnection);
        },
        job->quiet_ ? 1 : 0);
    poll_timer_.start();
    return job;
}

void Jobs::show(Job* job) {
    jobs_.push_back(job);
    emit started(job);
    emit changed();
}

void Jobs::finish(Job* job, const std::function<void(Job*, const End&)>& tell) {
    const QPointer<Jobs> still_here(this);
    const QPointer<Job> unfinished(job);
    job->poll();
    const End end = [this, &still_here](Job* ended, const Status& status, const QString& outcome) {
        if (!still_here)
            return;  // `done` closed the studio
        --unfinished_;
        std::erase(quiet_, ended);
        const bool listed = std::find(jobs_.begin(), jobs_.end(), ended) != jobs_.end();
        const bool failed = !status && status.error().kind != ErrorKind::kCancelled;
        if (ended->quiet_ && failed && !listed)
            show(ended);
        ended->end(status, outcome);
        if (still_here && ended->quiet_ && !failed) {
            std::erase(jobs_, ended);
            ended->deleteLater();
        }
    };
    try {
        tell(job, end);
    } catch (...) {
        if (still_here && unfinished && job->state_ == Job::State::kRunning)
            end(job, brokenPromise(std::current_exception()), {});
    }
    if (still_here)
        emit changed();
}

void Jobs::poll() {
    bool any = false;
    for (Job* job : std::vector<Job*>(quiet_)) {
        job->poll();
        if (job->clock_.elapsed() > kQuietFor_ms) {
            std::erase(quiet_, job);
            show(job);
        }
    }
    for (Job* job : std::vector<Job*>(jobs_))
        if (job->state_ == Job::State::kRunning)
            any = job->poll() || any;
    if (any)
        emit changed();
    if (idle())
        poll_timer_.stop();
}

int Jobs::running() const {
    return static_cast<int>(std::count_if(
        jobs_.begin(), jobs_.end(), [](const Job* job) { return job->state() == Job::State::kRunning; }));
}

void Jobs::clearEnded() {
    const auto ended = std::stable_partition(
        jobs_.begin(), jobs_.end(), [](const Job* job) { return job->state() == Job::State::kRunning; });
    std::for_each(ended, jobs_.end(), [](Job* job) { job->deleteLater(); });
    jobs_.erase(ended, jobs_.end());
    emit changed();
}

}  // namespace noctule::ui
