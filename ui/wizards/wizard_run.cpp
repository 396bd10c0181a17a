// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/wizard_run.h"

#include <algorithm>
#include <utility>

#include "core/guide/movement_guide.h"
#include "devices/live/live_session.h"
#include "ui/language/core_words.h"
#include "ui/wizards/field_words.h"

namespace noctule::ui {
namespace {

constexpr double kLookEvery_s = 0.1;
/// The take is a little longer than the step was right: solvers leave out its edges.
constexpr double kMargin_s = 0.5;
static_assert(MovementGuide::kStand_s + MovementGuide::kMove_s + kMargin_s <= LiveSession::kLongestPreRoll_s,
              "else an exercise would lose its rest pose");
constexpr const char* kTones = "calibrate/tones";

/// Without the confidence that comes from a pose: on a rig nobody wears the suit.
HealthReport healthOnRig(const LiveFrame& frame) {
    HealthReport health = frame.health;
    for (PairHealth& pair : health.pairs)
        pair.confidence = pair.heard;
    return health;
}

}  // namespace

WizardRun::WizardRun(CaptureContext& capture, WizardTask task, QObject* parent)
    : QObject(parent), capture_(capture), task_(task) {
    capture.suits().follow(&LiveSuit::frameChanged, this, &WizardRun::look);
    capture.suits().follow(&LiveSuit::statusChanged, this, &WizardRun::followLink);
    capture.suits().forEach(this, [this](SuitInUse& worn) {
        connect(&worn.suit, &LiveSuit::evidenceRecorded, this, &WizardRun::kept);
    });
    connect(&capture.suits(), &LiveSuits::currentChanged, this, &WizardRun::leaveSuit);
    capture.suits().follow(&LiveSuit::phaseChanged, this, [this] {
        if (phase_ == Phase::kIntro)
            followBox();
        emit changed();
    });
    capture.suits().follow(&LiveSuit::wearingChanged, this, &WizardRun::followWearing);
    capture.suits().follow(&CalibrationShelf::changed, this, &WizardRun::changed);
    connect(&capture.shared().session(), &SessionModel::opened, this, [this] {
        if (phase_ == Phase::kIntro)
            restore();
        emit changed();
    });
    restore();
    followBox();
}

WizardRun::~WizardRun() {
    if (job_)
        job_->cancel();
    if (phase_ == Phase::kGuiding && hasReadings())
        keepReadings();
}

std::span<const PhaseTransition<WizardRun::Phase>> WizardRun::transitions() {
    using enum Phase;
    static constexpr PhaseTransition<Phase> kTable[] = {
        {kIntro, kGuiding},  {kIntro, kSolving},                        // takes that are there
        {kGuiding, kTaking}, {kGuiding, kSolving}, {kGuiding, kIntro},  //
        {kTaking, kGuiding}, {kTaking, kIntro},                         //
        {kSolving, kResult}, {kSolving, kGuiding}, {kSolving, kIntro},  //
        {kResult, kGuiding}, {kResult, kIntro},
    };
    return kTable;
}

void WizardRun::setPhase(Phase phase) {
    if (phase != phase_)
        expectTransition(transitions(), phase_, phase, "calibration");
    phase_ = phase;
    emit changed();
}

QString WizardRun::setDistances(const QString& path) {
    auto known = readDistances(path);
    if (!known)
        return coreWords(known.error());
    known_ = std::move(*known);
    trouble_.clear();
    unfinished_.distances_path = path;
    emit changed();
    return {};
}

QString WizardRun::whyNotBegin() const {
    if (task_ == WizardTask::kSources && known_.distances.empty())
        return tr("Choose the file with the distances first.");
    if (task_ == WizardTask::kCheck && !base())
        return tr("There is no calibration to check. Calibrate the rest pose first.");
    if (task_ == WizardTask::kMagnetometers && !isWaitingForSuit() &&
        std::ranges::none_of(capture_.suit().suit().boards, &Board::has_magnetometer))
        return tr("No board of this suit has a magnetometer.");
    if (isWaitingForSuit())
        return tr("No suit is connected. Connect one first, or use takes that were recorded before.");
    return {};
}

std::optional<Calibration> WizardRun::base() const {
    return capture_.calibrations().inForce();
}

int WizardRun::sampleRate_hz() const {
    const auto hello = capture_.suit().status()->hello;
    return hello ? hello->sample_rate_hz : link::Hello{}.sample_rate_hz;
}

/// The suit as it is now, with what was taken of its boards before.
void WizardRun::watch() {
    followBox();
    std::set<std::string> skipped;
    for (int board = 0; guide_ && board < static_cast<int>(suit_.boards.size()); ++board)
        if (guide_->isSkipped(board))
            skipped.insert(suit_.boards[static_cast<size_t>(board)].id);
    const std::unique_ptr<Guide> before = std::move(guide_);
    const Suit suit_before = std::exchange(suit_, capture_.suit().suit());
    guide_ = makeGuide(task_, suit_, base().value_or(nominalCalibration(suit_)), sampleRate_hz(), known_);
    for (int board = 0; board < static_cast<int>(suit_.boards.size()); ++board)
        if (skipped.contains(suit_.boards[static_cast<size_t>(board)].id))
            guide_->skip(board, true);
    restoreReadings(dynamic_cast<const FieldGuide*>(before.get()), suit_before);
    std::erase_if(unfinished_.evidence, [this](WizardEvidence& part) {
        const auto step = stepShownBy(part);
        if (!step)
            return true;  // of a placement that is not asked for any more; the take stays in its folder
        part.step = *step;
        for (const std::string& id : part.boards)
            if (const int board = suit_.findBoard(id); board >= 0)
                guide_->setDone(*step, board);
        return false;
    });
    if (unfinished_.started_utc.isEmpty())
        unfinished_.started_utc = QString::fromStdString(capture_.shared().parts().utc_now());
}

/// What was taken of one suit says nothing of another one, whose own steps are looked up.
void WizardRun::followBox() {
    const QString serial = capture_.suit().serial();
    if (serial.isEmpty() || serial == of_suit_)
        return;
    of_suit_ = serial;
    guide_.reset();
    field_path_.clear();
    restore();
}

/// By its label where steps have one: a file of distances may have been changed since.
std::optional<int> WizardRun::stepShownBy(const WizardEvidence& part) const {
    for (int step = 0; step < guide_->stepCount(); ++step) {
        const QString label = QString::fromStdString(guide_->labelOf(step));
        if (label.isEmpty() ? part.step == step : part.placement == label)
            return step;
    }
    return std::nullopt;
}

/// Another suit, or the same one named otherwise.
void WizardRun::followWearing() {
    if (phase_ == Phase::kGuiding && !isWaitingForSuit() && toJson(capture_.suit().suit()) != toJson(suit_))
        watch();
    emit changed();
}

/// Another one is looked at now.
void WizardRun::leaveSuit() {
    trouble_.clear();
    if (phase_ != Phase::kIntro) {
        if (job_)
            job_->cancel();
        ++solving_;
        guide_.reset();
        result_.reset();
        phase_ = Phase::kIntro;
    }
    followBox();
    emit changed();
}

void WizardRun::begin() {
    if (!whyNotBegin().isEmpty() || !capture_.shared().session().makeSure())
        return;
    result_.reset();
    trouble_.clear();
    saved_file_.clear();
    watch();
    since_begin_.start();
    setPhase(Phase::kGuiding);
    if (guide_->isFinished())
        solveNow();
}

void WizardRun::beginAnew() {
    if (!whyNotBegin().isEmpty())
        return;
    forget();
    begin();
}

bool WizardRun::isWaitingForSuit() const {
    const LiveSuit::Phase phase = capture_.suit().phase();
    const bool streams = phase == LiveSuit::Phase::kLooking || phase == LiveSuit::Phase::kSaving;
    return !streams || capture_.suit().isSilent();
}

/// A suit that is gone sends no frame that would say so.
void WizardRun::followLink() {
    const bool is_gone = phase_ == Phase::kGuiding && guide_ && isWaitingForSuit();
    if (is_gone == std::exchange(is_gone_, is_gone))
        return;
    if (is_gone)
        guide_->lose();
    emit changed();
}

void WizardRun::look() {
    const auto frame = capture_.suit().frame();
    if (phase_ != Phase::kGuiding || paused_ || !guide_ || !frame || isWaitingForSuit())
        return;
    const int64_t every = std::llround(kLookEvery_s * sampleRate_hz());
    if (frame->sample >= looked_at_ && frame->sample < looked_at_ + every)
        return;
    looked_at_ = frame->sample;
    const Guidance& now = guide_->look(healthOnRig(*frame));
    keepReadingsBesides();
    emit guided();
    if (now.isRight() && now.held_s >= holdOf(task_))
        keep();
}

void WizardRun::keep() {
    const Guidance& now = guide_->guidance();
    if (guide_->keepsReadings()) {
        const int taken = *now.step;
        guide_->take();
        guide_->restart();
        keepReadings();
        emit changed();
        emit stepKept(taken);
        if (guide_->isFinished())
            solveNow();
        return;
    }
    LiveSuit::EvidencePlan plan;
    plan.kind = takeKindOf(task_).toStdString();
    plan.base_name = QStringLiteral("%1_%2").arg(keyOf(task_)).arg(*now.step + 1);
    plan.seen_sample = looked_at_;
    plan.length_s = leadOf(task_) + holdOf(task_) + kMargin_s;
    // Without its margin, in which the performer may not have stood still yet.
    if (task_ == WizardTask::kRestPose || task_ == WizardTask::kCheck)
        plan.rest_s = holdOf(task_);
    plan.placement = QString::fromStdString(guide_->labelOf(*now.step));
    trouble_ = capture_.suit().keepEvidence(plan);
    if (trouble_.isEmpty())
        return setPhase(Phase::kTaking);
    guide_->restart();
    emit changed();
}

void WizardRun::kept(const QString& path, const QString& trouble) {
    if (phase_ != Phase::kTaking)
        return;
    trouble_ = trouble;
    if (!trouble.isEmpty() || path.isEmpty()) {
        guide_->restart();
        return setPhase(Phase::kGuiding);
    }
    const Guidance now = guide_->guidance();
    guide_->take();
    WizardEvidence part{path, *now.step, QString::fromStdString(guide_->labelOf(*now.step)), {}};
    for (size_t board = 0; board < suit_.boards.size(); ++board)
        if (now.boards[board] == GuidedBoard::kRight && !guide_->isSkipped(static_cast<int>(board)))
            part.boards.push_back(suit_.boards[board].id);
    unfinished_.evidence.push_back(std::move(part));
    store();
    setPhase(Phase::kGuiding);
    emit stepKept(*now.step);
    if (guide_->isFinished())
        solveNow();
}

int WizardRun::step() const {
    if (!guide_)
        return 0;
    const Guidance& now = guide_->guidance();
    if (now.step && !guide_->isDone(*now.step))
        return *now.step;
    for (int step = 0; step < guide_->stepCount(); ++step)
        if (!guide_->isDone(step))
            return step;
    return guide_->stepCount() - 1;
}

int WizardRun::sideOf(int step) const {
    return guide_ ? guide_->sideUpIn(step) : step;
}

StepWords WizardRun::stepWords(int step) const {
    StepWords words = stepWordsOf(task_, step, sideOf(step), QString::fromStdString(guide_->labelOf(step)));
    if (const FieldGuide* guide = fieldGuide())
        if (const QString found = fieldFound(*guide, step); !found.isEmpty())
            words.hint = found;
    return words;
}

double WizardRun::heldShare() const {
    if (phase_ == Phase::kTaking)
        return 1;
    return guide_ && guide_->guidance().isRight() ? std::min(1.0, guide_->guidance().held_s / holdOf(task_))
                                                  : 0;
}

double WizardRun::secondsSoFar() const {
    return since_begin_.isValid() ? static_cast<double>(since_begin_.elapsed()) * 1e-3 : 0;
}

void WizardRun::skip(int board, bool skipped) {
    if (!guide_ || phase_ != Phase::kGuiding)
        return;
    guide_->skip(board, skipped);
    emit changed();
    if (guide_->isFinished())
        solveNow();
}

void WizardRun::repeat(int step) {
    if (!guide_ || phase_ == Phase::kTaking || phase_ == Phase::kSolving)
        return;
    guide_->repeat(step);
    if (guide_->keepsReadings())
        dropReadings();
    else
        dropEvidence(step);
    store();
    setPhase(Phase::kGuiding);
}

void WizardRun::goBack() {
    if (guide_ && guide_->keepsReadings())
        return lookAtSpotAgain();
    if (canGoBack())
        repeat(unfinished_.evidence.back().step);
}

void WizardRun::resume() {
    if (!guide_ || phase_ != Phase::kResult)
        return;
    for (const int board : std::exchange(left_out_, {}))
        guide_->skip(board, false);
    setPhase(Phase::kGuiding);
}

void WizardRun::setPaused(bool paused) {
    paused_ = paused;
    if (paused && phase_ == Phase::kGuiding && hasReadings())
        keepReadings();
    if (guide_ && !paused)
        guide_->restart();
}

bool WizardRun::tones() const {
    return capture_.shared().settings().value(kTones, true).toBool();
}

void WizardRun::setTones(bool tones) {
    if (tones == this->tones())
        return;
    capture_.shared().settings().setValue(kTones, tones);
    emit changed();
}

}  // namespace noctule::ui
