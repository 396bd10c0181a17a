// SPDX-License-Identifier: Apache-2.0
// Streams of the connected suit: those that are only looked at, and takes.
#include <QFileInfo>
#include <QPointer>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/session/shot_list.h"
#include "core/suit/calibration_lack.h"
#include "ui/language/core_words.h"
#include "ui/models/live_steps.h"
#include "ui/models/live_suit.h"

namespace noctule::ui {
namespace {

QString wordsOf(const std::string& text) {
    return QString::fromStdString(text);
}

QString takeNameOf(const RecorderState& recording) {
    return QFileInfo(wordsOf(recording.path)).completeBaseName();
}

}  // namespace

StreamRequest LiveSuit::requestOf(const std::optional<TakePlan>& plan) const {
    StreamRequest request;
    request.suit = wearing_.suit;
    request.calibration = known_.calibration;
    request.actor = wearing_.actor;
    request.rest_s = std::max(known_.rest_s, plan ? plan->rest_s : 0.0);
    request.software = surroundings_.software;
    request.created_utc = surroundings_.utc_now();
    request.pose_listener = [tap = pose_tap_](const TimedPose& pose, int64_t arrived_ns) {
        const std::lock_guard lock(tap->mutex);
        if (tap->listener)
            tap->listener(pose, arrived_ns);
    };
    if (!plan)
        return request;
    request.keep_results = canMoveBody();
    RecordingRequest take;
    take.folder = session_.session().takesFolder();
    take.name = plan->base_name.toStdString();
    take.pre_roll_s = plan->pre_roll_s;
    take.meta["actor_name"] = wearing_.actor.name;
    if (!wearing_.performer.empty())
        take.meta["performer"] = wearing_.performer;
    if (!plan->shot.isEmpty())
        take.meta[kShotKey] = plan->shot.toStdString();
    request.take = std::move(take);
    return request;
}

StreamRequest LiveSuit::requestOf(const EvidencePlan& plan) const {
    StreamRequest request = requestOf(std::optional<TakePlan>());
    request.rest_s = 0;
    request.process = false;
    RecordingRequest take;
    take.folder = session_.session().evidenceFolder();
    take.name = plan.base_name.toStdString();
    take.pre_roll_s = plan.length_s;
    take.length_s = plan.length_s;
    take.seen_sample = plan.seen_sample;
    take.take_kind = plan.kind;
    request.take = std::move(take);
    return request;
}

bool LiveSuit::canMoveBody() const {
    return known_.calibration && !lackOf(wearing_.suit, *known_.calibration).stopsTheBody();
}

void LiveSuit::setPoseListener(PoseListener listener) {
    const std::lock_guard lock(pose_tap_->mutex);
    pose_tap_->listener = std::move(listener);
}

/// One source alone, or all again after that.
std::optional<link::Settings> LiveSuit::settings() const {
    if (!lone_source_ && !sources_set_)
        return std::nullopt;
    std::vector<int> sources(wearing_.suit.sources.size());
    std::iota(sources.begin(), sources.end(), 0);
    link::Settings settings;
    settings.enabled_sources = lone_source_ ? std::vector{*lone_source_} : sources;
    return settings;
}

void LiveSuit::begin(const std::optional<TakePlan>& plan) {
    if (!live_ || working_)
        return;
    working_ = true;
    const bool in_midst = plan && plan->pre_roll_s > 0 && canPreRoll() && !lone_source_ && !sources_set_ &&
                          live_->status()->stream_is_open;
    look_again_ = look_again_ && in_midst;
    if (plan)
        lone_source_.reset();
    const auto settings = this->settings();
    sources_set_ = lone_source_.has_value();
    const bool of_take = plan.has_value();
    using Trouble = std::optional<Error>;
    jobs_.start<Trouble>(
        of_take ? tr("Starting the recording") : tr("Looking at %1").arg(address_),
        [live = live_, request = requestOf(plan), settings,
         in_midst](const JobContext& job) -> Result<Trouble> {
            if (!in_midst) {
                endStream(*live, job);
                if (settings)
                    live->set(*settings);
            }
            return beginStream(*live, request, job);
        },
        [self = QPointer(this), connection = connection_, of_take,
         in_midst](Result<Trouble> trouble) -> QString {
            if (self && self->connection_ == connection)
                self->begun(of_take, in_midst, trouble ? *trouble : Trouble(trouble.error()));
            return {};
        },
        Jobs::Loudness::kQuiet);
}

void LiveSuit::begun(bool of_take, bool in_midst, const std::optional<Error>& trouble) {
    working_ = false;
    if (is_lent_)
        return;  // a take of several begins instead, and tells what is wrong
    if (trouble) {
        since_trouble_.start();
        next_take_.reset();
        const bool tell = of_take || !told_ || phase_ == Phase::kStarting;
        told_ = true;
        stop_wanted_ = false;
        if (leave_wanted_)
            return release();
        setPhase(phaseWithoutTake());
        if (tell && live_->status()->link != LinkState::kRefused)
            emit failed(coreWords(trouble->message), coreWords(trouble->remedy));
        return;
    }
    told_ = false;
    since_trouble_.invalidate();
    if (!in_midst)
        emit streamBegan();
    if (!of_take) {
        if (const auto plan = std::exchange(next_take_, std::nullopt))
            return begin(plan);
        return setPhase(Phase::kLooking);
    }
    recorded_ = live_->recording();
    take_name_ = takeNameOf(*recorded_);
    setPhase(Phase::kRecording);
    emit recordingStarted(take_name_);
    if (std::exchange(stop_wanted_, false))
        endTake();
}

QString LiveSuit::whyNotRecord() const {
    switch (phase_) {
        case Phase::kNone:
            return tr("No suit is connected. Connect one first.");
        case Phase::kConnecting:
            return tr("The driver box has not answered yet. Wait a moment.");
        case Phase::kStarting:
        case Phase::kRecording:
            return tr("A take is being recorded already.");
        case Phase::kSaving:
            return tr("The take before is being saved. Wait a moment.");
        case Phase::kRefused:
            return tr("The driver box does not answer. Connect it again.");
        case Phase::kReady:
        case Phase::kLooking:
            break;
    }
    if (status()->link == LinkState::kLost)
        return tr("The link to the driver box is broken. Recording can begin when it is back.");
    return {};
}

QString LiveSuit::keepEvidence(const EvidencePlan& plan) {
    if (const QString why = whyNotRecord(); !why.isEmpty())
        return why;
    if (phase_ != Phase::kLooking || working_)
        return tr("The driver box is busy. Wait a moment.");
    if (!session_.makeSure())
        return tr("There is no session to keep the calibration in, and none could be made. Make one first.");
    working_ = true;
    setPhase(Phase::kSaving);
    jobs_.start<StreamResult>(
        {tr("Keeping %1"), plan.base_name},
        [live = live_, request = requestOf(plan), placement = plan.placement.toStdString(),
         seen = plan.seen_sample, rest_s = plan.rest_s](const JobContext& job) -> Result<StreamResult> {
            if (!live->status()->stream_is_open)
                return Error{ErrorKind::kDevice, "The stream broke off before the step was kept",
                             "It begins again when the suit is back"};
            if (const auto trouble = beginStream(*live, request, job))
                return *trouble;
            if (!placement.empty())
                live->addMarker("placement", placement, 0);
            if (const auto hello = live->status()->hello; hello && rest_s > 0) {
                const auto take = live->takeInput();
                const double origin_s = take ? static_cast<double>(take->origin_ns) * 1e-9 : 0;
                const int64_t end = seen - std::llround(origin_s * hello->sample_rate_hz);
                live->addMarker("rest", "begin",
                                std::max<int64_t>(0, end - std::llround(rest_s * hello->sample_rate_hz)));
                live->addMarker("rest", "end", end);
            }
            return endStream(*live, job);
        },
        [self = QPointer(this), connection = connection_](Result<StreamResult> result) -> QString {
            if (self && self->connection_ == connection)
                self->evidenceEnded(result ? *result : StreamResult{{}, {}, {}, {}, result.error()});
            return {};
        },
        Jobs::Loudness::kQuiet);
    return {};
}

void LiveSuit::evidenceEnded(const StreamResult& result) {
    working_ = false;
    std::optional<Error> trouble = result.trouble;
    if (result.recording && result.recording->trouble)
        trouble = result.recording->trouble;
    if (std::exchange(leave_wanted_, false))
        release();
    else
        setPhase(phaseWithoutTake());
    emit evidenceRecorded(result.recording ? wordsOf(result.recording->path) : QString(),
                          trouble ? coreWords(*trouble) : QString());
}

QString LiveSuit::record(const TakePlan& plan) {
    if (const QString why = whyNotRecord(); !why.isEmpty())
        return why;
    if (!session_.makeSure())
        return tr("There is no session to record into, and none could be made. Make one first.");
    if (const QString gone = session_.whyNotHere(); !gone.isEmpty())
        return gone;
    stop_wanted_ = false;
    recorded_.reset();
    setPhase(Phase::kStarting);
    if (working_)
        next_take_ = plan;
    else
        begin(plan);
    return {};
}

void LiveSuit::stopRecording() {
    if (phase_ == Phase::kStarting)
        stop_wanted_ = true;
    else if (phase_ == Phase::kRecording)
        endTake();
}

LiveSuit::Phase LiveSuit::phaseWithoutTake() const {
    return live_->status()->stream_is_open ? Phase::kLooking : Phase::kReady;
}

void LiveSuit::endTake() {
    working_ = true;
    const bool unasked = !live_->status()->stream_is_open || live_->recording()->ended;
    setPhase(Phase::kSaving);
    jobs_.start<StreamResult>(
        {tr("Saving %1"), take_name_},
        [live = live_](const JobContext& job) -> Result<StreamResult> { return endStream(*live, job); },
        [self = QPointer(this), connection = connection_, unasked](Result<StreamResult> result) -> QString {
            if (!self || self->connection_ != connection)
                return {};
            if (!result)
                result = StreamResult{{}, {}, {}, {}, result.error()};
            self->ended(*result, unasked);
            return {};
        },
        Jobs::Loudness::kQuiet);
}

void LiveSuit::ended(const StreamResult& result, bool unasked) {
    working_ = false;
    const auto hello = status()->hello;
    const TakeEnd end = endOfTake({{result, {}, hello ? hello->sample_rate_hz : 0}}, unasked);
    if (result.recording)
        recorded_ = result.recording;
    if (result.recording && !end.is_empty)
        session_.refresh(end.path);
    for (const std::string& warning : result.warnings)
        emit warned(QStringLiteral("%1: %2").arg(take_name_, coreWords(warning)));
    if (result.lacks_poses && !end.is_empty)
        emit posesMissing(take_name_);
    const QString name = take_name_;
    if (leave_wanted_)
        release();
    else
        setPhase(phaseWithoutTake());
    since_trouble_.invalidate();
    emit recordingEnded(name, end.trouble);
}

void LiveSuit::lend() {
    is_lent_ = true;
    look_again_ = false;
    lone_source_.reset();
    recorded_.reset();
    setPhase(Phase::kStarting);
}

GroupSuit LiveSuit::groupSuit() const {
    const StreamRequest request = requestOf(std::optional<TakePlan>());
    GroupSuit suit;
    suit.suit = wearing_.suit;
    suit.calibration = request.calibration;
    if (wearing_.suit.isFixed())
        return suit;  // anchors in the room
    suit.subject = wearing_.performer;
    suit.actor = request.actor;
    suit.process = request.calibration.has_value();
    suit.rest_s = request.rest_s;
    suit.pose_listener = request.pose_listener;
    return suit;
}

void LiveSuit::followTake(Phase phase, const QString& take_name) {
    take_name_ = take_name;
    if (const auto now = live_->recording())
        recorded_ = now;
    if (phase == Phase::kRecording)
        emit streamBegan();
    setPhase(phase);
}

void LiveSuit::takeBack(const std::optional<RecorderState>& recorded) {
    is_lent_ = false;
    look_again_ = sources_set_;
    recorded_ = recorded;
    since_trouble_.invalidate();
    if (leave_wanted_)
        return release();
    setPhase(phaseWithoutTake());
}

double LiveSuit::addMarker(const QString& label) {
    const auto hello = status()->hello;
    if (!live_ || !hello)
        return 0;
    const int64_t sample = live_->reachedSample();
    live_->addMarker("user", label.toStdString(), sample);
    return static_cast<double>(sample) / hello->sample_rate_hz;
}

void LiveSuit::addNote(const QString& text) {
    if (live_)
        live_->addNote(text.toStdString());
}

std::optional<RecorderState> LiveSuit::recording() const {
    if (phase_ == Phase::kRecording)
        if (const auto now = live_->recording())
            return now;
    return phase_ == Phase::kRecording || phase_ == Phase::kSaving ? recorded_ : std::nullopt;
}

double LiveSuit::recordedSeconds() const {
    const auto hello = status()->hello;
    if (!hello)
        return 0;
    if (phase_ == Phase::kRecording)
        return static_cast<double>(live_->reachedSample()) / hello->sample_rate_hz;
    return phase_ == Phase::kSaving && recorded_
               ? static_cast<double>(recorded_->samples) / hello->sample_rate_hz
               : 0;
}

}  // namespace noctule::ui
