// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/wizard_run.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/guide/placement_guide.h"
#include "core/guide/side_guide.h"
#include "core/guide/stand_guide.h"
#include "core/guide/turn_guide.h"
#include "core/job/atomic_file.h"
#include "core/session/take_folder.h"
#include "core/suit/calibration_entries.h"

namespace noctule::ui {
namespace {

constexpr double kLookEvery_s = 0.1;
/// The take is a little longer than the step was right: solvers leave out its edges.
constexpr double kMargin_s = 0.5;
constexpr const char* kTones = "calibrate/tones";

int oppositeSide(int side) {
    return side ^ 1;
}

/// Without the confidence that comes from a pose: on a rig nobody wears the suit.
HealthReport healthOnRig(const LiveFrame& frame) {
    HealthReport health = frame.health;
    for (size_t pair = 0; pair < std::min(health.pairs.size(), frame.ranges.size()); ++pair)
        if (const auto& range = frame.ranges[pair])
            health.pairs[pair].confidence = range->w_s * range->w_t;
    return health;
}

/// Points of a digitizer, or distances of a tape measure: the header tells.
Result<KnownDistances> readDistances(const QString& path) {
    const auto text = readWholeFile(path.toStdString());
    if (!text)
        return text.error();
    const std::string name = QFileInfo(path).fileName().toStdString();
    const std::string header = text->substr(0, text->find('\n'));
    return header.find("distance") != std::string::npos ? readTapeMeasureCsv(*text, name)
                                                        : readDigitizerCsv(*text, name);
}

Result<CalibrationResult> solveTask(WizardTask task, const CalibrateRequest& request,
                                    const KnownDistances& known, const JobContext& job) {
    switch (task) {
        case WizardTask::kSources:
            return calibrateSources(request, known, {}, job);
        case WizardTask::kAccelerometers:
            return calibrateAccelerometers(request, job);
        case WizardTask::kGyroscopes:
            return calibrateGyroscopes(request, 0, job);
        case WizardTask::kRestPose:
            return calibrateRestPose(request, job);
        case WizardTask::kCheck:
            return checkStill(request, job);
    }
    throw std::logic_error("every task has a solver");
}

}  // namespace

WizardRun::WizardRun(Studio& studio, WizardTask task, QObject* parent)
    : QObject(parent), studio_(studio), task_(task) {
    connect(&studio.suit(), &LiveSuit::frameChanged, this, &WizardRun::look);
    connect(&studio.suit(), &LiveSuit::evidenceRecorded, this, &WizardRun::kept);
    connect(&studio.suit(), &LiveSuit::phaseChanged, this, &WizardRun::changed);
    connect(&studio.session(), &SessionModel::opened, this, [this] {
        if (phase_ == Phase::kIntro) {
            evidence_.clear();
            started_utc_.clear();
            restore();
        }
        emit changed();
    });
    restore();
}

WizardRun::~WizardRun() {
    if (job_)
        job_->cancel();
}

void WizardRun::setPhase(Phase phase) {
    phase_ = phase;
    emit changed();
}

QString WizardRun::setDistances(const QString& path) {
    auto known = readDistances(path);
    if (!known)
        return QString::fromStdString(known.error().text());
    known_ = std::move(*known);
    distances_path_ = path;
    emit changed();
    return {};
}

QString WizardRun::whyNotBegin() const {
    if (task_ == WizardTask::kSources && known_.distances.empty())
        return tr("Choose the file with the distances first.");
    if (task_ == WizardTask::kCheck && !base())
        return tr("There is no calibration to check. Calibrate the rest pose first.");
    if (isWaitingForSuit())
        return tr("No suit is connected. Connect one first, or use takes that were recorded before.");
    return {};
}

std::optional<Calibration> WizardRun::base() const {
    return studio_.calibrations().inForce();
}

void WizardRun::makeGuide() {
    suit_ = studio_.suit().suit();
    const auto hello = studio_.suit().status()->hello;
    const int rate_hz = hello ? hello->sample_rate_hz : 150000;
    const Calibration known = base().value_or(nominalCalibration(suit_));
    switch (task_) {
        case WizardTask::kSources:
            guide_ = std::make_unique<PlacementGuide>(suit_, known, rate_hz, known_);
            break;
        case WizardTask::kAccelerometers:
            guide_ = std::make_unique<SideGuide>(suit_, known, rate_hz);
            break;
        case WizardTask::kGyroscopes:
            guide_ = std::make_unique<TurnGuide>(suit_, known, rate_hz, 0);
            break;
        case WizardTask::kRestPose:
        case WizardTask::kCheck:
            guide_ = std::make_unique<StandGuide>(suit_, known, rate_hz);
            break;
    }
    for (const WizardEvidence& part : evidence_)
        for (const std::string& id : part.boards)
            if (const int board = suit_.findBoard(id); board >= 0 && part.step < guide_->stepCount())
                guide_->setDone(part.step, board);
}

void WizardRun::begin() {
    if (!whyNotBegin().isEmpty() || !studio_.makeSureOfSession())
        return;
    result_.reset();
    trouble_.clear();
    saved_ = false;
    makeGuide();
    since_begin_.start();
    if (started_utc_.isEmpty())
        started_utc_ = QString::fromStdString(studio_.parts().utc_now());
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
    const LiveSuit::Phase phase = studio_.suit().phase();
    const bool streams = phase == LiveSuit::Phase::kLooking || phase == LiveSuit::Phase::kSaving;
    const LinkState link = studio_.suit().status()->link;
    return !streams || link == LinkState::kLost || link == LinkState::kStalled;
}

void WizardRun::look() {
    const auto frame = studio_.suit().frame();
    if (phase_ != Phase::kGuiding || paused_ || !guide_ || !frame || isWaitingForSuit())
        return;
    if (studio_.suit().suit().boards.size() != suit_.boards.size())
        makeGuide();
    const auto hello = studio_.suit().status()->hello;
    const int64_t every = std::llround(kLookEvery_s * (hello ? hello->sample_rate_hz : 150000));
    if (frame->sample >= looked_at_ && frame->sample < looked_at_ + every)
        return;
    looked_at_ = frame->sample;
    const Guidance& now = guide_->look(healthOnRig(*frame));
    emit guided();
    if (now.isRight() && now.held_s >= holdOf(task_))
        keep();
}

void WizardRun::keep() {
    const Guidance& now = guide_->guidance();
    LiveSuit::EvidencePlan plan;
    plan.kind = takeKindOf(task_).toStdString();
    plan.base_name = QStringLiteral("%1_%2").arg(keyOf(task_)).arg(*now.step + 1);
    plan.length_s = holdOf(task_) + kMargin_s;
    if (const auto* jig = dynamic_cast<const PlacementGuide*>(guide_.get()))
        plan.placement = QString::fromStdString(jig->placements()[static_cast<size_t>(*now.step)]);
    trouble_ = studio_.suit().keepEvidence(plan);
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
    WizardEvidence part{path, *now.step, {}};
    for (size_t board = 0; board < suit_.boards.size(); ++board)
        if (now.boards[board] == GuidedBoard::kRight && !guide_->isSkipped(static_cast<int>(board)))
            part.boards.push_back(suit_.boards[board].id);
    evidence_.push_back(std::move(part));
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
    if (task_ == WizardTask::kAccelerometers)
        return step;
    const auto* turns = dynamic_cast<const TurnGuide*>(guide_.get());
    return turns && !turns->turnsCounterClockwise() ? oppositeSide(step) : step;
}

StepWords WizardRun::stepWords(int step) const {
    QString label;
    if (const auto* jig = dynamic_cast<const PlacementGuide*>(guide_.get()))
        label = QString::fromStdString(jig->placements()[static_cast<size_t>(step)]);
    const bool has_sides = task_ == WizardTask::kAccelerometers || task_ == WizardTask::kGyroscopes;
    return stepWordsOf(task_, step, has_sides ? sideOf(step) : 0, label);
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

/// Its takes go to the trash of the session: a solver must not see what the operator took back.
void WizardRun::dropEvidence(int step) {
    for (const WizardEvidence& part : evidence_)
        if (part.step == step && studio_.session().isOpen()) {
            const std::filesystem::path trash = studio_.session().session().trashFolder();
            std::error_code ignored;
            std::filesystem::create_directories(trash, ignored);
            const std::filesystem::path from = part.path.toStdString();
            if (const Status moved =
                    moveTakeFiles(from, nextTakePath(trash, takeBaseName(from.stem().string())));
                !moved)
                emit studio_.warned(QString::fromStdString(moved.error().text()));
        }
    std::erase_if(evidence_, [step](const WizardEvidence& part) { return part.step == step; });
}

void WizardRun::repeat(int step) {
    if (!guide_ || phase_ == Phase::kTaking || phase_ == Phase::kSolving)
        return;
    guide_->repeat(step);
    dropEvidence(step);
    store();
    setPhase(Phase::kGuiding);
}

void WizardRun::goBack() {
    if (canGoBack())
        repeat(evidence_.back().step);
}

void WizardRun::resume() {
    if (guide_ && phase_ == Phase::kResult)
        setPhase(Phase::kGuiding);
}

void WizardRun::setPaused(bool paused) {
    paused_ = paused;
    if (guide_ && !paused)
        guide_->restart();
}

void WizardRun::solveNow() {
    if (phase_ != Phase::kGuiding)
        return;
    std::vector<std::string> paths;
    for (const WizardEvidence& part : evidence_)
        paths.push_back(part.path.toStdString());
    from_evidence_ = true;
    if (!paths.empty())
        solve(paths);
}

void WizardRun::solveTakes(const QStringList& paths) {
    std::vector<std::string> files;
    for (const QString& path : paths)
        files.push_back(path.toStdString());
    from_evidence_ = false;
    if (!files.empty() && studio_.makeSureOfSession())
        solve(files);
}

void WizardRun::solve(const std::vector<std::string>& paths) {
    CalibrateRequest request;
    request.take_paths = paths;
    // A pose that is repeated counts as it was last.
    if (task_ == WizardTask::kRestPose || task_ == WizardTask::kCheck)
        request.take_paths = {paths.back()};
    request.base = base();
    if (from_evidence_ && studio_.suit().phase() != LiveSuit::Phase::kNone)
        request.actor = studio_.suit().actor();
    request.created_utc = studio_.parts().utc_now();
    saved_ = false;
    KnownDistances known = known_;
    std::erase_if(known.distances, [this](const KnownDistance& distance) {
        const int board = guide_ ? suit_.findBoard(distance.board) : -1;
        return board >= 0 && guide_->isSkipped(board);
    });
    job_ = studio_.jobs().start<CalibrationResult>(
        tr("Calibration: %1").arg(wordsOf(task_).title),
        [task = task_, request, known](const JobContext& job) {
            return solveTask(task, request, known, job);
        },
        [self = QPointer(this)](Result<CalibrationResult> result) -> QString {
            if (self)
                self->solved(std::move(result));
            return {};
        },
        Jobs::Loudness::kQuiet);
    setPhase(Phase::kSolving);
}

void WizardRun::solved(Result<CalibrationResult> result) {
    result_.reset();
    trouble_.clear();
    if (result) {
        result_ = std::move(*result);
        keepValuesOfSkipped(*result_);
        return setPhase(Phase::kResult);
    }
    if (result.error().kind != ErrorKind::kCancelled)
        trouble_ = QString::fromStdString(result.error().text());
    setPhase(guide_ ? Phase::kGuiding : Phase::kIntro);
}

/// A board that was skipped may have been heard all the same: its values stay what they were.
void WizardRun::keepValuesOfSkipped(CalibrationResult& result) const {
    if (!guide_ || !from_evidence_)
        return;
    Calibration before = base().value_or(nominalCalibration(suit_));
    for (int board = 0; board < static_cast<int>(suit_.boards.size()); ++board)
        if (guide_->isSkipped(board)) {
            const Board& skipped = suit_.boards[static_cast<size_t>(board)];
            entryOf(result.calibration, skipped) = entryOf(before, skipped);
        }
}

QString WizardRun::save() {
    if (!result_ || saved_)
        return {};
    if (const QString why = studio_.calibrations().save(*result_, keyOf(task_)); !why.isEmpty())
        return why;
    saved_ = true;
    if (from_evidence_)
        forget();
    emit changed();
    return {};
}

bool WizardRun::tones() const {
    return studio_.settings().value(kTones, true).toBool();
}

void WizardRun::setTones(bool tones) {
    if (tones == this->tones())
        return;
    studio_.settings().setValue(kTones, tones);
    emit changed();
}

QString WizardRun::statePath() const {
    if (!studio_.session().isOpen())
        return {};
    const QString folder = QString::fromStdString(studio_.session().session().calibrationFolder().string());
    return QDir(folder).filePath(keyOf(task_) + ".unfinished.json");
}

std::optional<WizardRun::Unfinished> WizardRun::unfinished() const {
    if (evidence_.empty())
        return std::nullopt;
    std::set<int> steps;
    for (const WizardEvidence& part : evidence_)
        steps.insert(part.step);
    return Unfinished{static_cast<int>(steps.size()), QDateTime::fromString(started_utc_, Qt::ISODate)};
}

/// Written at each step: whatever happens later, this much is there.
void WizardRun::store() const {
    const QString path = statePath();
    // Who stands there today stood otherwise yesterday.
    if (path.isEmpty() || task_ == WizardTask::kCheck || task_ == WizardTask::kRestPose)
        return;
    nlohmann::json json = {
        {"format", "noctule-unfinished-calibration"}, {"version", 1},
        {"task", keyOf(task_).toStdString()},         {"started_utc", started_utc_.toStdString()},
        {"distances", distances_path_.toStdString()}, {"evidence", nlohmann::json::array()}};
    for (const WizardEvidence& part : evidence_)
        json["evidence"].push_back({{"file", QFileInfo(part.path).fileName().toStdString()},
                                    {"step", part.step},
                                    {"boards", part.boards}});
    if (const Status written = writeFileAtomically(path.toStdString(), json.dump(2) + "\n", true); !written)
        emit studio_.warned(QString::fromStdString(written.error().text()));
}

void WizardRun::restore() {
    const QString path = statePath();
    if (path.isEmpty() || !QFile::exists(path))
        return;
    const auto text = readWholeFile(path.toStdString());
    const auto json = nlohmann::json::parse(text ? *text : std::string(), nullptr, false);
    if (!json.is_object() || !json.contains("evidence"))
        return;
    const QDir folder(QString::fromStdString(studio_.session().session().evidenceFolder().string()));
    try {
        started_utc_ = QString::fromStdString(json.value("started_utc", ""));
        for (const nlohmann::json& entry : json.at("evidence")) {
            const QString file =
                QFileInfo(QString::fromStdString(entry.at("file").get<std::string>())).fileName();
            const int step = entry.at("step").get<int>();
            if (step >= 0 && QFile::exists(folder.filePath(file)))
                evidence_.push_back(
                    {folder.filePath(file), step, entry.at("boards").get<std::vector<std::string>>()});
        }
        if (const auto distances = json.value("distances", std::string()); !distances.empty())
            setDistances(QString::fromStdString(distances));
    } catch (const nlohmann::json::exception&) {
        evidence_.clear();  // nothing is lost: the takes stay in their folder
    }
}

void WizardRun::forget() {
    evidence_.clear();
    started_utc_.clear();
    if (const QString path = statePath(); !path.isEmpty())
        QFile::remove(path);
}

}  // namespace noctule::ui
