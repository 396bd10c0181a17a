// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/room_run.h"

#include <QFileInfo>
#include <QUndoCommand>
#include <algorithm>

#include "core/job/atomic_file.h"
#include "devices/live/suit_voices.h"
#include "ui/language/core_words.h"

namespace noctule::ui {

/// Places of anchors, put into a take and taken back.
class RoomCommand : public QObject, public QUndoCommand {
public:
    RoomCommand(RoomRun& run, std::shared_ptr<const SurveyedTake> surveyed)
        : QUndoCommand(RoomRun::tr("Using the surveyed places of anchors")),
          run_(&run),
          path_(run.path_),
          surveyed_(std::move(surveyed)) {
        connect(&run.studio_.session(), &SessionModel::takeRenamed, this,
                [this](const QString& before, const QString& now) {
                    if (path_ == before)
                        path_ = now;
                });
    }

    void redo() override { place(*surveyed_->result.room, true); }
    void undo() override { place(surveyed_->before, false); }

private:
    void place(const Suit& room, bool as_surveyed) {
        if (!run_)
            return;
        Studio& studio = run_->studio_;
        studio.jobs().start<Done>(
            RoomRun::tr("Writing the places of anchors into %1").arg(QFileInfo(path_).completeBaseName()),
            [path = path_.toStdString(), room, utc = studio.parts().utc_now(),
             turn = run_->one_at_a_time_](const JobContext&) {
                const std::lock_guard<std::mutex> lock(*turn);
                std::vector<std::string> lacking;  // anchors without a place, as the result says
                return placeAnchors(path, room, utc, lacking);
            },
            [run = run_, path = path_, as_surveyed,
             kept = studio.session().keepInPlace(path_)](const Status& status) -> QString {
                if (run && status)
                    run->placed(path, as_surveyed);
                else if (run)
                    emit run->studio_.failed(coreWords(status.error().message),
                                             coreWords(status.error().remedy));
                return {};
            },
            Jobs::Loudness::kQuiet);
    }

    QPointer<RoomRun> run_;
    QString path_;
    std::shared_ptr<const SurveyedTake> surveyed_;
};

RoomRun::RoomRun(Studio& studio, QObject* parent) : QObject(parent), studio_(studio) {
    connect(&studio.take(), &TakeDocument::opened, this, &RoomRun::follow);
}

bool RoomRun::hasRoom(Studio& studio) {
    const auto overview = studio.take().overview();
    if (overview &&
        std::ranges::any_of(overview->parties, [](const TakeParty& party) { return party.subject.room; }))
        return true;
    return std::ranges::any_of(studio.suits().connected(),
                               [](const SuitInUse* worn) { return isFixed(worn->suit.suit()); });
}

/// What was found belongs to its take.
void RoomRun::follow() {
    if (studio_.take().path() != path_) {
        if (job_)
            job_->cancel();
        job_.clear(), path_.clear(), result_.reset(), error_.reset();
        in_use_ = false;
    }
    emit changed();
}

RoomRun::Phase RoomRun::phase() const {
    if (job_ && job_->state() == Job::State::kRunning)
        return Phase::kSurveying;
    if (result_)
        return Phase::kResult;
    if (error_)
        return Phase::kFailed;
    const auto overview = studio_.take().overview();
    const bool has_anchors = overview && std::ranges::any_of(overview->parties, [](const TakeParty& party) {
                                 return party.subject.room;
                             });
    return has_anchors ? Phase::kReady : Phase::kNoTake;
}

QString RoomRun::takeName() const {
    return QFileInfo(studio_.take().path()).completeBaseName();
}

void RoomRun::survey() {
    if (phase() == Phase::kSurveying || phase() == Phase::kNoTake)
        return;
    path_ = studio_.take().path();
    result_.reset(), error_.reset();
    in_use_ = false;
    RoomRequest request;
    request.take_path = path_.toStdString();
    request.created_utc = studio_.parts().utc_now();
    job_ = studio_.jobs().start<SurveyedTake>(
        tr("Surveying the room of %1").arg(takeName()),
        [request, turn = one_at_a_time_](const JobContext& job) {
            const std::lock_guard<std::mutex> lock(*turn);
            return calibrateRoom(request, job);
        },
        [self = QPointer(this), path = path_,
         kept = studio_.session().keepInPlace(path_)](Result<SurveyedTake> result) -> QString {
            if (self)
                self->accept(std::move(result), path);
            return {};
        });
    connect(job_, &Job::ended, this, &RoomRun::changed);
    emit changed();
}

void RoomRun::accept(Result<SurveyedTake> result, const QString& path) {
    if (path != path_)
        return;
    if (result)
        result_ = std::make_shared<const SurveyedTake>(std::move(*result));
    else if (result.error().kind != ErrorKind::kCancelled)
        error_ = result.error();
    emit changed();
}

void RoomRun::use() {
    if (result_ && !in_use_)
        studio_.session().undoStack().push(new RoomCommand(*this, result_));
}

void RoomRun::placed(const QString& path, bool as_surveyed) {
    if (studio_.take().path() == path)
        studio_.take().reload(false);
    if (path == path_)
        in_use_ = as_surveyed;
    emit changed();
}

QString RoomRun::save(const QString& path) const {
    const Status written =
        writeFileAtomically(path.toStdString(), toJson(*result_->result.room).dump(1) + "\n", true);
    return written ? QString() : coreWords(written.error());
}

}  // namespace noctule::ui
