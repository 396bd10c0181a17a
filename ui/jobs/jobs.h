// SPDX-License-Identifier: Apache-2.0
// Long work off the interface's thread, with progress, cancel and an end in words. A job ends as exactly one
// of done, failed or cancelled. `work` runs on a thread of its own pool; `done` runs on the interface's
// thread, and never after the Jobs object is gone.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QThreadPool>
#include <QTimer>
#include <exception>
#include <functional>
#include <memory>
#include <vector>

#include "core/job/job.h"
#include "core/job/result.h"
#include "ui/jobs/remaining_time.h"

namespace noctule::ui {

/// Words for the panel, and the names in them that users gave (takes, sessions, files): the log leaves those
/// out.
struct JobTitle {
    JobTitle(const char* text) : text(text) {}
    JobTitle(QString text) : text(std::move(text)) {}
    /// `pattern` has %1, and %2 for a second name.
    JobTitle(const QString& pattern, const QString& name) : text(pattern.arg(name)), names{name} {}
    JobTitle(const QString& pattern, const QString& name, const QString& second)
        : text(pattern.arg(name, second)), names{name, second} {}

    QString text;
    QStringList names;
};

class Job : public QObject {
    Q_OBJECT
public:
    enum class State { kRunning, kDone, kFailed, kCancelled };

    const QString& title() const { return title_.text; }
    const QStringList& namesInTitle() const { return title_.names; }
    State state() const { return state_; }
    double fraction() const { return fraction_; }
    const QString& stage() const { return stage_; }
    /// Absent while it cannot be told.
    std::optional<int> secondsLeft() const;
    /// In words, once it ended: the result, or what went wrong and what to do.
    const QString& outcome() const { return outcome_; }
    const std::optional<Error>& error() const { return error_; }
    bool seen() const { return seen_; }
    void setSeen();

public slots:
    void cancel();

signals:
    void changed();  ///< at most 20 times a second
    void ended();

private:
    friend class Jobs;
    struct Shared;
    Job(JobTitle title, QObject* parent);
    bool poll();  ///< true: something changed
    void end(const Status& status, const QString& outcome);

    JobTitle title_;
    QString stage_, outcome_;
    State state_ = State::kRunning;
    double fraction_ = 0;
    std::optional<Error> error_;
    bool seen_ = false;
    bool quiet_ = false;
    QElapsedTimer clock_;
    RemainingTime remaining_;
    std::shared_ptr<Shared> shared_;
};

class Jobs : public QObject {
    Q_OBJECT
public:
    explicit Jobs(QObject* parent = nullptr);
    ~Jobs() override;  ///< cancels what runs and waits for it

    /// Short work (loading for a view) is `quiet`: it appears in all() only when it fails or lasts over a
    /// second, and leaves again by itself when it is done; keep it in a QPointer.
    enum class Loudness { kNormal, kQuiet };

    /// `done` gets the value on success and errors alike, also a mistake that `work` threw; returns words for
    /// the panel (empty: none).
    template <class T>
    Job* start(const JobTitle& title, std::function<Result<T>(const JobContext&)> work,
               std::function<QString(Result<T>)> done, Loudness loudness = Loudness::kNormal) {
        auto slot = std::make_shared<std::optional<Result<T>>>();
        return startUntyped(
            title,
            [slot, work = std::move(work)](const JobContext& job) {
                try {
                    slot->emplace(job.cancelled() ? Result<T>(JobContext::cancelledError()) : work(job));
                } catch (...) {
                    slot->emplace(brokenPromise(std::current_exception()));
                }
            },
            [slot, done = std::move(done)](Job* job, const auto& end) {
                const bool ok = (*slot)->ok();
                const Status status = ok ? Status(Done{}) : Status((*slot)->error());
                end(job, status, done(std::move(**slot)));
            },
            loudness);
    }

    const std::vector<Job*>& all() const { return jobs_; }  ///< newest last
    int running() const;                                    ///< of all()
    bool idle() const { return unfinished_ == 0; }          ///< no quiet work either
    void clearEnded();

signals:
    void started(noctule::ui::Job* job);  ///< it appeared in all()
    void changed();                       ///< any job's state or progress

private:
    using End = std::function<void(Job*, const Status&, const QString&)>;
    Job* startUntyped(const JobTitle& title, std::function<void(const JobContext&)> work,
                      std::function<void(Job*, const End&)> finish, Loudness loudness);
    static Error brokenPromise(std::exception_ptr thrown);
    void show(Job* job);
    void finish(Job* job, const std::function<void(Job*, const End&)>& tell);
    void poll();

    std::vector<Job*> jobs_;
    std::vector<Job*> quiet_;  ///< run without being in jobs_
    int unfinished_ = 0;
    QThreadPool pool_;
    QTimer poll_timer_;
};

}  // namespace noctule::ui
