// SPDX-License-Identifier: Apache-2.0
// A take of several suits: they lend their sessions to a group until it is saved.
#include <QFileInfo>
#include <algorithm>

#include "core/session/shot_list.h"
#include "ui/language/core_words.h"
#include "ui/models/live_steps.h"
#include "ui/models/live_suits.h"

namespace noctule::ui {
namespace {

double committed_s(const LiveSuit& suit) {
    const auto recorder = suit.recording();
    const auto hello = suit.status()->hello;
    return recorder && hello ? static_cast<double>(recorder->committed_samples) / hello->sample_rate_hz : 0;
}

bool flows(const LiveSuit& suit) {
    return suit.status()->stream_is_open && suit.status()->link != LinkState::kLost;
}

}  // namespace

LiveSuits::Phase LiveSuits::phase() const {
    return take_phase_ != Phase::kNone ? take_phase_ : current_->suit.phase();
}

bool LiveSuits::isTakeOpen() const {
    return phase() == Phase::kStarting || phase() == Phase::kRecording || phase() == Phase::kSaving;
}

QString LiveSuits::whyNotRecord() const {
    for (const SuitInUse* worn : connected())
        if (const QString why = worn->suit.whyNotRecord(); !why.isEmpty())
            return tr("%1: %2", "who wears a suit, what hinders it").arg(nameOf(*worn), why);
    const auto apart = whyNotTogether();
    return apart ? coreWords(*apart) : QString();
}

QString LiveSuits::record(const LiveSuit::TakePlan& plan) {
    if (take_phase_ != Phase::kNone)
        return tr("A take is being recorded already.");
    if (!areSeveral()) {
        const QString why = current_->suit.record(plan);
        if (why.isEmpty())
            plan_ = plan;
        return why;
    }
    if (const QString why = whyNotRecord(); !why.isEmpty())
        return why;
    if (!session_.makeSure())
        return tr("There is no session to record into, and none could be made. Make one first.");
    if (const QString gone = session_.whyNotHere(); !gone.isEmpty())
        return gone;
    plan_ = plan;
    stop_wanted_ = false;
    recorded_ = connected();
    take_phase_ = Phase::kStarting;
    for (SuitInUse* worn : recorded_)
        worn->suit.lend();
    timer_.start();
    emit changed();
    return {};
}

void LiveSuits::lookAtTake() {
    if (take_phase_ == Phase::kStarting && !group_ &&
        std::ranges::all_of(recorded_, [](const SuitInUse* worn) { return worn->suit.isAtRest(); }))
        beginTake();
    else if (take_phase_ == Phase::kRecording && !group_->isRecording())
        endTake();
}

GroupRequest LiveSuits::requestOf(const LiveSuit::TakePlan& plan) const {
    GroupRequest request;
    request.all.software = surroundings_.software;
    request.all.created_utc = surroundings_.utc_now();
    RecordingRequest take;
    take.folder = session_.session().takesFolder();
    take.name = plan.base_name.toStdString();
    if (const std::string& performer = recorded_.front()->suit.wearing().performer; !performer.empty())
        take.meta["performer"] = performer;
    if (!plan.shot.isEmpty())
        take.meta[kShotKey] = plan.shot.toStdString();
    request.all.take = std::move(take);
    for (const SuitInUse* worn : recorded_) {
        request.suits.push_back(worn->suit.groupSuit());
        if (worn->suit.suit().isFixed())
            continue;
        GroupSuit& suit = request.suits.back();
        suit.subject = nameOf(*worn).toStdString();
        suit.rest_s = std::max(suit.rest_s.value_or(0), plan.rest_s);
    }
    return request;
}

void LiveSuits::beginTake() {
    std::vector<LiveGroup::Connected> members;
    for (const SuitInUse* worn : recorded_)
        members.push_back({nameInTake(*worn), worn->suit.session()});
    group_ = std::make_shared<LiveGroup>(std::move(members));
    using Warnings = std::vector<std::string>;
    jobs_.start<Warnings>(
        tr("Starting the recording"),
        [group = group_, request = requestOf(plan_)](const JobContext& job) -> Result<Warnings> {
            group->stop();
            for (size_t i = 0; i < group->size(); ++i)
                endStream(group->session(i), job);
            return beginTogether(*group, request, job);
        },
        [self = QPointer(this)](Result<Warnings> begun) -> QString {
            if (self)
                self->takeBegun(begun);
            return {};
        },
        Jobs::Loudness::kQuiet);
}

void LiveSuits::takeBegun(const Result<std::vector<std::string>>& begun) {
    if (!begun) {
        giveBack();
        emit failed(coreWords(begun.error().message), coreWords(begun.error().remedy));
        return;
    }
    take_name_ = QFileInfo(QString::fromStdString(group_->session(0).recording()->path)).completeBaseName();
    take_phase_ = Phase::kRecording;
    for (SuitInUse* worn : recorded_)
        worn->suit.followTake(Phase::kRecording, take_name_);
    for (const std::string& warning : *begun)
        emit warned(QStringLiteral("%1: %2").arg(take_name_, coreWords(warning)));
    emit recordingStarted(take_name_);
    emit changed();
    if (std::exchange(stop_wanted_, false))
        endTake();
}

void LiveSuits::stopRecording() {
    if (take_phase_ == Phase::kNone)
        current_->suit.stopRecording();
    else if (take_phase_ == Phase::kStarting)
        stop_wanted_ = true;
    else if (take_phase_ == Phase::kRecording)
        endTake();
}

void LiveSuits::endTake() {
    const bool unasked = !group_->isRecording();
    take_phase_ = Phase::kSaving;
    for (SuitInUse* worn : recorded_)
        worn->suit.followTake(Phase::kSaving, take_name_);
    emit changed();
    jobs_.start<GroupReport>(
        {tr("Saving %1"), take_name_},
        [group = group_](const JobContext& job) -> Result<GroupReport> { return endTogether(*group, job); },
        [self = QPointer(this), unasked](Result<GroupReport> report) -> QString {
            if (self && report)
                self->takeEnded(*report, unasked);
            else if (self)
                self->giveBack();
            return report ? QString() : coreWords(report.error());
        },
        Jobs::Loudness::kQuiet);
}

/// The suits look by themselves again.
void LiveSuits::giveBack() {
    timer_.stop();
    group_.reset();
    take_phase_ = Phase::kNone;
    for (SuitInUse* worn : std::exchange(recorded_, {}))
        worn->suit.takeBack({});
    emit changed();
}

/// A box that was lost on the way has a warning of its own; what ended the take for all is its trouble.
void LiveSuits::takeEnded(const GroupReport& report, bool unasked) {
    const TakeEnd end = endOfTake({report.suits.begin(), report.suits.end()}, unasked);
    bool can_be_processed = !end.is_empty;
    for (size_t i = 0; i < report.suits.size(); ++i) {
        for (const std::string& warning : report.suits[i].stream.warnings)
            emit warned(QStringLiteral("%1: %2").arg(take_name_, coreWords(warning)));
        can_be_processed = can_be_processed && (report.suits[i].is_room || recorded_[i]->suit.canMoveBody());
    }
    if (!end.is_empty)
        session_.refresh(end.path);
    giveBack();
    emit recordingEnded(take_name_, end.trouble);
    if (can_be_processed && !plan_.is_survey)
        emit takeOfSeveral(end.path);
}

double LiveSuits::recordedSeconds() const {
    if (take_phase_ == Phase::kNone)
        return current_->suit.recordedSeconds();
    double most_s = 0;
    for (const SuitInUse* worn : recorded_)
        most_s = std::max(most_s, worn->suit.recordedSeconds());
    return most_s;
}

LiveSuits::OnDisk LiveSuits::onDisk() const {
    const LiveSuit* least = &current_->suit;
    if (take_phase_ == Phase::kRecording) {
        least = nullptr;
        for (const SuitInUse* worn : recorded_)
            if (flows(worn->suit) && (!least || committed_s(worn->suit) < committed_s(*least)))
                least = &worn->suit;
        if (!least)
            least = &recorded_.front()->suit;
    }
    const auto hello = least->status()->hello;
    return {least->recording(), hello ? hello->sample_rate_hz : 0};
}

double LiveSuits::bytesPerSecond() const {
    double bytes_per_s = 0;
    for (const SuitInUse* worn : connected())
        if (const auto hello = worn->suit.status()->hello)
            bytes_per_s += 2.0 * hello->boardCount() * hello->sample_rate_hz;
    return bytes_per_s > 0 ? bytes_per_s : kUsualBytesPerSecond;
}

std::optional<double> LiveSuits::measuredBytesPerSecond() const {
    std::optional<double> bytes_per_s;
    for (const SuitInUse* worn : connected()) {
        if (worn->suit.isSilent() || !worn->suit.status()->stream_is_open)
            continue;
        const auto one_per_s = worn->check.bytesPerSecond();
        if (!one_per_s)
            return std::nullopt;
        bytes_per_s = bytes_per_s.value_or(0) + *one_per_s;
    }
    return bytes_per_s;
}

std::optional<double> LiveSuits::storageLeft_s() const {
    if (group_)
        if (const auto left_s = group_->remaining_s())
            return left_s;
    if (const auto recording = current_->suit.recording();
        take_phase_ == Phase::kNone && recording && recording->remaining_s)
        return recording->remaining_s;
    if (storage_.freeBytes() < 0)
        return std::nullopt;
    return recordingSeconds(storage_.freeBytes(), bytesPerSecond());
}

double LiveSuits::addMarker(const QString& label) {
    const auto worn =
        std::ranges::find_if(recorded_, [](const SuitInUse* one) { return !one->suit.suit().isFixed(); });
    return (worn == recorded_.end() ? *current_ : **worn).suit.addMarker(label);
}

void LiveSuits::addNote(const QString& text) {
    (recorded_.empty() ? *current_ : *recorded_.front()).suit.addNote(text);
}

}  // namespace noctule::ui
