// SPDX-License-Identifier: Apache-2.0
#include "ui/views/record/record_run.h"

#include <QDir>
#include <utility>

#include "core/session/shot_list.h"
#include "core/session/take_folder.h"
#include "ui/language/core_words.h"
#include "ui/models/countdown_setting.h"
#include "ui/style/words.h"
#include "ui/views/readiness_words.h"

namespace noctule::ui {
namespace {

constexpr const char *kPreRoll = "record/pre_roll_s", *kReview = "record/open_review",
                     *kBase = "record/base_name";
constexpr int kTick_ms = 33;
constexpr double kLeastRoom_s = 5;  ///< with less the recorder ends a take as soon as it begins

QString sentences(const RecordObstacle& obstacle) {
    return obstacle.text.isEmpty() ? obstacle.title + QLatin1Char('.')
                                   : obstacle.title + QStringLiteral(". ") + obstacle.text;
}

}  // namespace

RecordRun::RecordRun(CaptureContext& capture, QObject* parent)
    : QObject(parent),
      capture_(capture),
      countdown_(CountdownSetting::get().seconds()),
      pre_roll_s_(capture.shared().settings().value(kPreRoll, 0).toInt()),
      tones_(capture.shared().settings().value(kTonesSetting, true).toBool()),
      opens_review_(capture.shared().settings().value(kReview, true).toBool()),
      base_(capture.shared()
                .settings()
                .value(kBase, tr("take", "first part of the names of takes"))
                .toString()) {
    tick_.setInterval(kTick_ms);
    tick_.setTimerType(Qt::PreciseTimer);
    connect(&tick_, &QTimer::timeout, this, [this] {
        if (countdown_.look(tones_))
            beginOwn();
        emit ticked();
    });
    connect(&CountdownSetting::get(), &CountdownSetting::changed, this, [this] {
        countdown_.setSeconds(CountdownSetting::get().seconds());
        emit changed();
    });
    LiveSuits& suits = capture.suits();
    suits.forEach(this, [this](SuitInUse& worn) {
        connect(&worn.suit, &LiveSuit::phaseChanged, this, &RecordRun::follow);
        connect(&worn.suit, &LiveSuit::statusChanged, this, &RecordRun::follow);
        connect(&worn.check, &SuitCheck::changed, this, &RecordRun::follow);
        connect(&worn.suit, &LiveSuit::wearingChanged, this, &RecordRun::changed);  // with a pre-roll or not
    });
    connect(&suits, &LiveSuits::changed, this, &RecordRun::follow);
    connect(&suits, &LiveSuits::recordingStarted, this, &RecordRun::onStarted);
    connect(&suits, &LiveSuits::recordingEnded, this, &RecordRun::onEnded);
    connect(&capture.placeReset(), &PlaceReset::marked, this, [this](double t_s, const QString& label) {
        marks_.push_back({TakeMark::Kind::kMarker, t_s, label});
        emit marksChanged();
    });
    connect(&capture.shared().session(), &SessionModel::opened, this, [this] {
        shot_ = -1;
        without_shot_ = false;
        chooseDueShot();
    });
    connect(&capture.shared().session(), &SessionModel::changed, this, &RecordRun::followSession);
    chooseDueShot();
    obstacle_ = obstacleNow();
    state_ = stateNow();  // a take may run already
    follow();
}

/// Of several suits the first that has one, with the name of who wears it.
RecordObstacle RecordRun::obstacleNow() const {
    LiveSuits& suits = capture_.suits();
    if (!suits.areSeveral())
        return obstacleOfSuit(suits.current());
    RecordObstacle mild;
    for (const SuitInUse* worn : suits.connected()) {
        RecordObstacle obstacle = obstacleOfSuit(*worn);
        if (!obstacle)
            continue;
        obstacle.title =
            tr("%1: %2", "who wears a suit, what hinders it").arg(suits.nameOf(*worn), obstacle.title);
        if (!obstacle.may_record_anyway)
            return obstacle;
        if (!mild)
            mild = obstacle;
    }
    if (const auto apart = suits.whyNotTogether())
        return {coreWords(apart->message), coreWords(apart->remedy) + '.'};
    return mild;
}

RecordObstacle obstacleOf(const ReadinessProblem& problem, const SuitCheck& check, const QString& folder) {
    const HindranceWords words = wordsOf(problem, check);
    if (problem.kind == ProblemKind::kStorageShort && problem.value < kLeastRoom_s)
        return {words.title,
                RecordRun::tr("There is no room for a take in %1. Free some space, or record into a session "
                              "in another folder.")
                    .arg(QDir::toNativeSeparators(folder)),
                false, true};
    // Without sound there is no take to make; anything else costs a part of it.
    return {words.title, words.text, problem.kind != ProblemKind::kNoSound};
}

RecordObstacle RecordRun::obstacleOfSuit(const SuitInUse& worn) const {
    const LiveSuit& suit = worn.suit;
    const auto status = suit.status();
    if (suit.isLent())
        return {};
    if (suit.phase() == LiveSuit::Phase::kRefused && status->trouble)
        return {coreWords(status->trouble->message), coreWords(status->trouble->remedy)};
    if (suit.phase() == LiveSuit::Phase::kConnecting)
        return {tr("The driver box has not answered yet"), tr("It usually takes a second or two.")};
    if (status->link == LinkState::kLost)
        return {tr("The link to the driver box is broken"),
                tr("Recording can begin as soon as it is back; the studio tries by itself.")};
    for (const ReadinessProblem& problem : worn.check.readiness().problems)
        if (problem.hinders && !problem.accepted)
            return obstacleOf(problem, worn.check, capture_.shared().takesFolder());
    return {};
}

std::span<const PhaseTransition<RecordRun::State>> RecordRun::transitions() {
    using enum State;
    static constexpr PhaseTransition<State> kTable[] = {
        {kNoSuit, kReady},        {kNoSuit, kRefused},                            //
        {kReady, kNoSuit},        {kReady, kRefused},                             //
        {kReady, kCountdown},     {kReady, kRecording},                           // without a countdown
        {kRefused, kNoSuit},      {kRefused, kReady},                             //
        {kRefused, kCountdown},   {kRefused, kRecording},                         // all the same
        {kCountdown, kReady},     {kCountdown, kRefused}, {kCountdown, kNoSuit},  //
        {kCountdown, kRecording}, {kCountdown, kSaving},                          //
        {kRecording, kSaving},    {kRecording, kNoSuit},                          //
        {kRecording, kReady},     {kRecording, kRefused},                         // no take came to be
        {kReady, kSaving},        {kRefused, kSaving},                            // evidence of a calibration
        {kSaving, kReady},        {kSaving, kRefused},    {kSaving, kNoSuit},
    };
    return kTable;
}

RecordRun::State RecordRun::stateNow() const {
    switch (capture_.suits().phase()) {
        case LiveSuit::Phase::kNone:
            return State::kNoSuit;
        case LiveSuit::Phase::kStarting:
        case LiveSuit::Phase::kRecording:
            return State::kRecording;
        case LiveSuit::Phase::kSaving:
            return State::kSaving;
        default:
            break;
    }
    if (countdown_.runs())
        return State::kCountdown;
    return obstacle_ ? State::kRefused : State::kReady;
}

void RecordRun::follow() {
    const RecordObstacle obstacle = obstacleNow();
    const bool same = obstacle.title == obstacle_.title && obstacle.text == obstacle_.text &&
                      std::exchange(suits_, suitCount()) == suitCount();
    obstacle_ = obstacle;
    const bool cannot = obstacle_ && !obstacle_.may_record_anyway;
    const LiveSuit::Phase phase = capture_.suits().phase();
    if (cannot || phase == LiveSuit::Phase::kNone || phase == LiveSuit::Phase::kSaving)
        countdown_.end();
    const State now = stateNow();
    const bool ticks = now == State::kCountdown || now == State::kRecording;
    if (ticks && !tick_.isActive())
        tick_.start();
    else if (!ticks)
        tick_.stop();
    if (now == state_ && same)
        return;
    if (now != state_)
        expectTransition(transitions(), state_, now, "recording");
    state_ = now;
    emit changed();
}

void RecordRun::press() {
    switch (state_) {
        case State::kNoSuit:
        case State::kRefused:
            emit refused();
            break;
        case State::kReady:
            beginOrCount();
            break;
        case State::kCountdown:
            endCountdown();
            break;
        case State::kRecording:
            stop();
            break;
        case State::kSaving:
            break;
    }
}

void RecordRun::recordAnyway() {
    if (state_ == State::kRefused && obstacle_.may_record_anyway)
        beginOrCount();
}

void RecordRun::beginOrCount() {
    told_notes_.clear();
    if (countdown_.seconds() == 0)
        return beginOwn();
    countdown_.start(tones_);
    follow();
}

bool RecordRun::endCountdown() {
    if (!countdown_.runs())
        return false;
    countdown_.end();
    follow();
    return true;
}

void RecordRun::beginOwn() {
    if (const QString why = begin(base_); !why.isEmpty())
        emit capture_.shared().failed(tr("Recording did not begin"), why, About::kCapture);
}

QString RecordRun::begin(const QString& base) {
    countdown_.end();
    LiveSuit::TakePlan plan;
    plan.base_name = base;
    plan.pre_roll_s = preRollSeconds();
    if (shot_ >= 0)
        plan.shot = QString::fromStdString(
            capture_.shared().session().session().shots[static_cast<size_t>(shot_)].name);
    const QString why = capture_.suits().record(plan);
    follow();
    return why;
}

void RecordRun::stop() {
    cue(tr("Stopped"));
    capture_.suits().stopRecording();
}

void RecordRun::beginFromElsewhere(const QString& name, const QString& notes) {
    QString why;
    if (state_ == State::kRefused && !obstacle_.may_record_anyway)
        why = sentences(obstacle_);
    else
        why = begin(name.trimmed().isEmpty()
                        ? base_
                        : QString::fromStdString(takeBaseName(name.trimmed().toStdString())));
    if (why.isEmpty())
        told_notes_ = notes.trimmed();
    else
        emit capture_.shared().failed(tr("Another program asked for a recording, which did not begin"), why,
                                      About::kCapture);
}

void RecordRun::stopFromElsewhere() {
    if (state_ == State::kRecording)
        stop();
}

void RecordRun::onStarted(const QString& take) {
    running_ = take;
    marks_.clear();
    markers_ = 0;
    cue(tr("Recording"));
    emit marksChanged();
    emit changed();
    addNote(std::exchange(told_notes_, {}));
}

void RecordRun::onEnded(const QString& take, const QString& trouble) {
    running_.clear();
    if (!trouble.isEmpty()) {
        cue(tr("The recording has ended by itself"));
        emit capture_.shared().failed(tr("%1 ended by itself", "name of a take").arg(take), trouble,
                                      About::kCapture);
    }
    chooseDueShot();
    emit changed();
    if (capture_.suits().isSurvey())
        return;  // it is shown where it was begun
    SessionModel& session = capture_.shared().session();
    const int index = session.isOpen() ? session.session().findTake(take.toStdString()) : -1;
    if (index < 0)
        return;
    session.setCurrentTake(index);
    if (opens_review_)
        capture_.shared().goTo(Step::kReview);
}

void RecordRun::setPreRollSeconds(int seconds) {
    pre_roll_s_ = seconds;
    capture_.shared().settings().setValue(kPreRoll, seconds);
    emit changed();
}

void RecordRun::setTones(bool tones) {
    tones_ = tones;
    capture_.shared().settings().setValue(kTonesSetting, tones);
    emit changed();
}

void RecordRun::setOpensReview(bool opens) {
    opens_review_ = opens;
    capture_.shared().settings().setValue(kReview, opens);
    emit changed();
}

QString RecordRun::takeName() const {
    return running_.isEmpty() ? nextName() : running_;
}

QString RecordRun::nextName() const {
    const SessionModel& session = capture_.shared().session();
    const std::string base = base_.toStdString();
    return QString::fromStdString(session.isOpen()
                                      ? nextTakeName(session.session(), base)
                                      : numberedTakeName(base, [](const std::string&) { return true; }));
}

void RecordRun::setName(const QString& typed) {
    if (!typed.trimmed().isEmpty()) {
        base_ = QString::fromStdString(takeBaseName(typed.trimmed().toStdString()));
        capture_.shared().settings().setValue(kBase, base_);
    }
    emit changed();
}

void RecordRun::setShot(int shot) {
    without_shot_ = shot < 0;
    applyShot(shot);
}

void RecordRun::applyShot(int shot) {
    const SessionModel& session = capture_.shared().session();
    const int count = session.isOpen() ? static_cast<int>(session.session().shots.size()) : 0;
    shot_ = shot >= 0 && shot < count ? shot : -1;
    if (shot_ >= 0)
        base_ = QString::fromStdString(takeBaseOf(session.session().shots[static_cast<size_t>(shot_)]));
    emit changed();
}

void RecordRun::chooseDueShot() {
    const SessionModel& session = capture_.shared().session();
    applyShot(session.isOpen() && !without_shot_ ? dueShot(session.session(), shot_) : -1);
}

/// The list may have become another one under the shot that was chosen.
void RecordRun::followSession() {
    const SessionModel& session = capture_.shared().session();
    const int count = session.isOpen() ? static_cast<int>(session.session().shots.size()) : 0;
    if (state_ != State::kRecording && state_ != State::kSaving && (shot_ >= count || shot_ < 0))
        chooseDueShot();
    emit changed();
}

void RecordRun::addMarker() {
    if (state_ != State::kRecording || running_.isEmpty())
        return;
    const QString label = tr("Marker %1").arg(++markers_);
    marks_.push_back({TakeMark::Kind::kMarker, capture_.suits().addMarker(label), label});
    emit marksChanged();
}

void RecordRun::addNote(const QString& text) {
    if (state_ != State::kRecording || running_.isEmpty() || text.trimmed().isEmpty())
        return;
    const double t_s = capture_.suits().recordedSeconds();
    capture_.suits().addNote(QStringLiteral("%1 %2").arg(timeText(t_s), text.trimmed()));
    marks_.push_back({TakeMark::Kind::kNote, t_s, text.trimmed()});
    emit marksChanged();
}

}  // namespace noctule::ui
