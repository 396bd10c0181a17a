// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/room_run.h"

#include <QFileInfo>
#include <algorithm>

#include "core/job/atomic_file.h"
#include "ui/language/core_words.h"

namespace noctule::ui {

namespace {

bool hasAnchors(const TakeDocument& take) {
    const auto overview = take.overview();
    return overview &&
           std::ranges::any_of(overview->parties, [](const TakeParty& party) { return party.subject.room; });
}

/// Anchors that are not in `places` stay where they are.
Suit placedInto(Suit room, const Suit& places) {
    for (Board& board : room.boards)
        if (const int found = places.findBoard(board.id); found >= 0)
            board = places.boards[static_cast<size_t>(found)];
    for (Source& source : room.sources)
        if (const int found = places.findSource(source.id); found >= 0)
            source = places.sources[static_cast<size_t>(found)];
    return room;
}

}  // namespace

Error namingTake(Error error, const std::string& take_path) {
    const QString path = QString::fromStdString(take_path);
    const QString name = QFileInfo(path).completeBaseName();
    for (std::string* words : {&error.message, &error.remedy})
        *words = QString::fromStdString(*words).replace(path, name).toStdString();
    return error;
}

RoomRun::RoomRun(Studio& studio, QObject* parent) : QObject(parent), studio_(studio) {
    connect(&studio.take(), &TakeDocument::opened, this, &RoomRun::follow);
    connect(&studio.session(), &SessionModel::takeRenamed, this,
            [this](const QString& before, const QString& now) {
                if (path_ == before)
                    path_ = now;
            });
    connect(&studio.changes(), &TakeChanges::written, this, &RoomRun::placed);
}

bool RoomRun::hasRoom(Studio& studio) {
    return hasAnchors(studio.take()) ||
           std::ranges::any_of(studio.suits().connected(),
                               [](const SuitInUse* worn) { return worn->suit.suit().isFixed(); });
}

/// What was found belongs to its take.
void RoomRun::follow() {
    if (studio_.take().path() != path_) {
        if (job_)
            job_->cancel();
        job_.clear(), path_.clear();
        forget();
    }
    emit changed();
}

void RoomRun::forget() {
    all_.reset(), result_.reset(), error_.reset(), in_force_.reset();
    without_.clear();
}

RoomRun::Phase RoomRun::phase() const {
    if (job_ && job_->state() == Job::State::kRunning)
        return Phase::kSurveying;
    if (result_)
        return Phase::kResult;
    if (error_)
        return Phase::kFailed;
    return hasAnchors(studio_.take()) ? Phase::kReady : Phase::kNoTake;
}

QString RoomRun::takeName() const {
    return QFileInfo(studio_.take().path()).completeBaseName();
}

void RoomRun::survey() {
    if (phase() == Phase::kSurveying || phase() == Phase::kNoTake)
        return;
    path_ = studio_.take().path();
    forget();
    RoomRequest request;
    request.take_path = path_.toStdString();
    request.created_utc = studio_.parts().utc_now();
    job_ = studio_.jobs().start<SurveyedTake>(
        {tr("Surveying the room of %1"), takeName()},
        [request](const JobContext& job) { return calibrateRoom(request, job); },
        [self = QPointer(this), path = path_,
         kept = studio_.session().keepInPlace(path_)](Result<SurveyedTake> result) -> QString {
            if (self && self->path_ == path)
                self->accept(std::move(result));
            return {};
        });
    connect(job_, &Job::ended, this, &RoomRun::changed);
    emit changed();
}

/// The job's end is told next.
void RoomRun::accept(Result<SurveyedTake> result) {
    if (result)
        all_ = result_ = std::make_shared<const SurveyedTake>(std::move(*result));
    else if (result.error().kind != ErrorKind::kCancelled)
        error_ = namingTake(result.error(), path_.toStdString());
}

bool RoomRun::isInUse() const {
    return result_ && in_force_ &&
           toJson(placedInto(*in_force_, *result_->result.room)) == toJson(*in_force_);
}

QString RoomRun::whyNotWithout(size_t anchor) const {
    return room_survey::canLeaveOut(result_->survey, anchor)
               ? QString()
               : tr("A room needs three anchors that have a place.");
}

void RoomRun::setWithout(size_t anchor, bool is_without) {
    if (phase() != Phase::kResult || (is_without && !whyNotWithout(anchor).isEmpty()))
        return;
    if (is_without)
        without_.insert(anchor);
    else
        without_.erase(anchor);
    auto without = withoutAnchors(*all_, {without_.begin(), without_.end()});
    require(without.ok(), "each of them could be left out");
    result_ = std::make_shared<const SurveyedTake>(std::move(*without));
    emit changed();
}

void RoomRun::use() {
    if (result_ && !isInUse() && studio_.changes().waiting<RoomChange>(path_).empty())
        studio_.changes().push(tr("Using the surveyed places of anchors"),
                               RoomChange{in_force_.value_or(result_->before), *result_->result.room,
                                          studio_.parts().utc_now()});
}

void RoomRun::placed(const QString& path, const TakeChange& change) {
    const auto* room = std::get_if<RoomChange>(&change);
    if (!room || path != path_ || !result_)
        return;
    in_force_ = placedInto(in_force_.value_or(result_->before), room->after);
    emit changed();
}

QString RoomRun::save(const QString& path) const {
    const Status written =
        writeFileAtomically(path.toStdString(), toJson(*result_->result.room).dump(1) + "\n", true);
    return written ? QString() : coreWords(written.error());
}

}  // namespace noctule::ui
