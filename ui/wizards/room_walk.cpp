// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/room_walk.h"

#include <algorithm>
#include <utility>

#include "core/processing/room_evidence.h"
#include "ui/models/voice.h"
#include "ui/wizards/room_drawing.h"
#include "ui/wizards/room_run.h"

namespace noctule::ui {
namespace {

constexpr int kWalkTick_ms = 200;

bool isAnchors(const SuitInUse* worn) {
    return worn->suit.suit().isFixed();
}

}  // namespace

/// What a survey yields that must not fail as a job: too little is heard at first.
struct RoomWalk::SoFar {
    std::shared_ptr<const SurveyedTake> found;
    std::optional<Error> hindrance;
};

RoomWalk::RoomWalk(Studio& studio, QObject* parent) : QObject(parent), studio_(studio) {
    tick_.setInterval(kWalkTick_ms);
    connect(&tick_, &QTimer::timeout, this, &RoomWalk::tick);
    connect(&studio.suits(), &LiveSuits::changed, this, &RoomWalk::follow);
    connect(&studio.suits(), &LiveSuits::recordingEnded, this, &RoomWalk::onEnded);
    connect(&studio.suits(), &LiveSuits::failed, this, [this](const QString& what, const QString& remedy) {
        not_begun_ = remedy.isEmpty() ? what : what + QStringLiteral(". ") + remedy;
    });
}

RoomWalk::~RoomWalk() {
    stopSurvey();
}

QString RoomWalk::whoIsMissing() const {
    const auto connected = studio_.suits().connected();
    if (std::ranges::none_of(connected, isAnchors))
        return tr("No box of anchors is connected. Connect one first.");
    if (std::ranges::all_of(connected, isAnchors))
        return tr("No suit is connected. Connect the suit of whoever walks past the anchors.");
    if (std::ranges::none_of(
            connected, [](const SuitInUse* worn) { return !isAnchors(worn) && worn->suit.canMoveBody(); }))
        return tr("The suit is not calibrated, so nobody knows where it hears from. Calibrate it first.");
    return {};
}

QString RoomWalk::whyNotBegin() const {
    if (runs_)
        return tr("It runs already.");
    const QString missing = whoIsMissing();
    return missing.isEmpty() ? studio_.suits().whyNotRecord() : missing;
}

QString RoomWalk::caution() const {
    for (const SuitInUse* worn : studio_.suits().connected())
        if (isAnchors(worn) && !worn->suit.suit().sources.empty() && !worn->suit.canMoveBody())
            return tr(
                "The anchors' sources are not calibrated, so places are found to decimetres only. "
                "Import the calibration of their box first.");
    return {};
}

void RoomWalk::begin() {
    if (runs_)
        return;
    found_.reset(), hindrance_.reset();
    take_name_.clear(), not_begun_.clear();
    ends_ = false;
    surveyed_s_ = 0;
    LiveSuit::TakePlan plan;
    plan.base_name = tr("room", "first part of the names of takes");
    plan.rest_s = times_.stand_s;
    plan.is_survey = true;
    trouble_ = whyNotBegin();
    if (trouble_.isEmpty())
        trouble_ = studio_.suits().record(plan);
    runs_ = trouble_.isEmpty();
    if (runs_)
        tick_.start();
    told_ = phase();
    emit changed();
}

void RoomWalk::end() {
    if (!runs_ || std::exchange(ends_, true))
        return;
    stopSurvey();
    studio_.suits().stopRecording();
    emit changed();
}

/// Whoever reads the take keeps it from becoming one file.
void RoomWalk::stopSurvey() {
    if (job_)
        job_->cancel();
    job_.clear();
    ++surveying_;
}

RoomWalk::Phase RoomWalk::phase() const {
    if (!runs_)
        return Phase::kIdle;
    switch (studio_.suits().phase()) {
        case LiveSuits::Phase::kStarting:
            return Phase::kStarting;
        case LiveSuits::Phase::kRecording:
            if (!ends_)
                return seconds() < times_.stand_s ? Phase::kStanding : Phase::kWalking;
            return Phase::kSaving;
        default:
            return Phase::kSaving;
    }
}

double RoomWalk::seconds() const {
    return runs_ ? studio_.suits().recordedSeconds() : 0;
}

int RoomWalk::anchorCount() const {
    for (const SuitInUse* worn : studio_.suits().connected())
        if (isAnchors(worn))
            return static_cast<int>(anchorParts(worn->suit.suit()).size());
    return 0;
}

bool RoomWalk::isEnough(const room_survey::RoomSurvey& survey) {
    return survey.frame.of_performer &&
           std::ranges::all_of(survey.anchors, [](const room_survey::SurveyedAnchor& anchor) {
               return stateOf(anchor).tone == Tone::kOk;
           });
}

/// Of a take that did not come to be nothing else is told.
void RoomWalk::follow() {
    if (!runs_)
        return;
    if (studio_.suits().phase() == LiveSuits::Phase::kSaving)
        stopSurvey();
    if (!studio_.suits().isTakeOpen())
        QMetaObject::invokeMethod(this, &RoomWalk::settle, Qt::QueuedConnection);
}

void RoomWalk::settle() {
    if (runs_ && !studio_.suits().isTakeOpen())
        onEnded({}, not_begun_);
}

void RoomWalk::tick() {
    const Phase now = phase();
    if (std::exchange(told_, now) != now) {
        if (now == Phase::kStanding)
            Voice::get().say(tr("Stand still"));
        else if (now == Phase::kWalking)
            Voice::get().say(tr("Walk slowly past all anchors"));
        emit changed();
    }
    if (now == Phase::kWalking) {
        lookForLost();
        surveyWhenDue();
        if (seconds() >= times_.most_s)
            end();
    }
    emit ticked();
}

/// The others would be recorded on, of no use to a survey.
void RoomWalk::lookForLost() {
    for (const SuitInUse* worn : studio_.suits().connected()) {
        const auto status = worn->suit.status();
        if (!worn->suit.isLent() || (status->stream_is_open && status->link != LinkState::kLost))
            continue;
        trouble_ = tr("The link to %1 broke, so the recording has ended. What it holds is surveyed.",
                      "name of a performer, or Room")
                       .arg(studio_.suits().nameOf(*worn));
        return end();
    }
}

void RoomWalk::surveyWhenDue() {
    const bool is_surveying = job_ && job_->state() == Job::State::kRunning;
    const LiveSuits::OnDisk disk = studio_.suits().onDisk();
    if (ends_ || is_surveying || !disk.recorder || disk.sample_rate_hz <= 0)
        return;
    const double safe_s = static_cast<double>(disk.recorder->committed_samples) / disk.sample_rate_hz;
    if (safe_s < std::max(times_.first_s, surveyed_s_ + times_.every_s))
        return;
    surveyed_s_ = safe_s;
    startSurvey(disk.recorder->path);
}

void RoomWalk::startSurvey(const std::string& path) {
    RoomRequest request;
    request.take_path = path;
    request.created_utc = studio_.parts().utc_now();
    job_ = studio_.jobs().start<SoFar>(
        tr("Surveying the room while it is recorded"),
        [request](const JobContext& job) -> Result<SoFar> {
            auto surveyed = calibrateRoom(request, job);
            SoFar so_far;
            if (surveyed)
                so_far.found = std::make_shared<const SurveyedTake>(std::move(*surveyed));
            else if (surveyed.error().kind == ErrorKind::kCancelled)
                return surveyed.error();
            else
                so_far.hindrance = namingTake(surveyed.error(), request.take_path);
            return so_far;
        },
        [self = QPointer(this), surveying = ++surveying_](Result<SoFar> so_far) -> QString {
            if (self && so_far && self->surveying_ == surveying)
                self->accept(std::move(*so_far));
            return {};
        },
        Jobs::Loudness::kQuiet);
}

void RoomWalk::accept(SoFar so_far) {
    hindrance_ = std::move(so_far.hindrance);
    if (so_far.found)
        found_ = std::move(so_far.found);
    if (found_ && !hindrance_ && seconds() >= times_.least_s && isEnough(found_->survey))
        return end();
    emit changed();
}

void RoomWalk::onEnded(const QString& take, const QString& trouble) {
    if (!runs_)
        return;
    stopSurvey();
    tick_.stop();
    runs_ = ends_ = false;
    told_ = Phase::kIdle;
    // One that ended before anything was recorded was removed.
    const SessionModel& session = studio_.session();
    if (session.isOpen() && session.session().findTake(take.toStdString()) >= 0)
        take_name_ = take;
    const bool tells_more = !trouble.isEmpty() && (trouble_.isEmpty() || take_name_.isEmpty());
    if (tells_more)
        trouble_ = trouble;
    else if (trouble_.isEmpty() && take_name_.isEmpty())
        trouble_ = tr("The recording did not begin, or could not be saved.");
    Voice::get().say(tr("Done"));
    emit changed();
    if (!take_name_.isEmpty())
        emit ended(take_name_);
}

}  // namespace noctule::ui
