// SPDX-License-Identifier: Apache-2.0
// Of the magnetometers' wizard: readings that are kept while it runs, and what only this task can do.
#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <mutex>

#include "core/session/take_folder.h"
#include "ui/language/core_words.h"
#include "ui/wizards/wizard_run.h"

namespace noctule::ui {
namespace {

constexpr int kKeepEvery_ms = 10'000;

}  // namespace

/// Writes the take, from whichever thread; never an older state over a newer one.
struct WizardRun::FieldKeeper {
    std::mutex mutex;
    int64_t asked = 0, written = 0;  ///< `asked` on the interface's thread alone

    Status write(int64_t version, const FieldTakePlan& plan, const Suit& suit, const FieldRecord& record) {
        const std::lock_guard lock(mutex);
        if (version <= written)
            return Done{};
        const Status done = writeFieldTake(plan, suit, record);
        if (done)
            written = version;
        return done;
    }
};

const FieldGuide* WizardRun::fieldGuide() const {
    return dynamic_cast<const FieldGuide*>(guide_.get());
}

FieldRecord WizardRun::fieldRecord(const FieldGuide& guide, Whose whose) const {
    FieldRecord record;
    for (int board = 0; board < static_cast<int>(suit_.boards.size()); ++board)
        record.readings.push_back(whose == Whose::kNotSkipped && guide.isSkipped(board)
                                      ? std::vector<FieldReading>()
                                      : guide.readingsOf(board));
    if (guide.isDone(FieldGuide::kSpot))
        record.spot = guide.spot();
    return record;
}

bool WizardRun::hasReadings() const {
    const FieldGuide* guide = fieldGuide();
    if (!guide)
        return false;
    for (int board = 0; board < static_cast<int>(suit_.boards.size()); ++board)
        if (!guide->readingsOf(board).empty())
            return true;
    return guide->isDone(FieldGuide::kFloor);
}

/// Of the run before, or as they were kept.
void WizardRun::restoreReadings(const FieldGuide* before, const Suit& suit_before) {
    auto* guide = dynamic_cast<FieldGuide*>(guide_.get());
    if (!guide)
        return;
    if (before) {
        for (int board = 0; board < static_cast<int>(suit_.boards.size()); ++board)
            if (const int old = suit_before.findBoard(suit_.boards[static_cast<size_t>(board)].id); old >= 0)
                guide->give(board, before->readingsOf(old));
        return guide->give(before->spot());
    }
    if (unfinished_.evidence.empty())
        return;
    const auto record = readFieldTake(unfinished_.evidence.front().path.toStdString(), suit_);
    if (!record) {
        unfinished_.evidence.clear();
        return emit capture_.shared().warned(coreWords(record.error()), About::kSuit);
    }
    for (int board = 0; board < static_cast<int>(suit_.boards.size()); ++board)
        guide->give(board, record->readings[static_cast<size_t>(board)]);
    if (record->spot)
        guide->give(*record->spot);
}

QString WizardRun::fieldPath() {
    if (!field_path_.isEmpty())
        return field_path_;
    if (!unfinished_.evidence.empty())
        return field_path_ = unfinished_.evidence.front().path;
    const std::filesystem::path folder = capture_.shared().session().session().evidenceFolder();
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    return field_path_ = QString::fromStdString(nextTakePath(folder, keyOf(task_).toStdString()).string());
}

FieldTakePlan WizardRun::fieldPlan() {
    FieldTakePlan plan;
    plan.path = fieldPath().toStdString();
    plan.name = QFileInfo(QString::fromStdString(plan.path)).completeBaseName().toStdString();
    plan.created_utc = capture_.shared().parts().utc_now();
    plan.software = capture_.shared().parts().software;
    plan.sample_rate_hz = sampleRate_hz();
    plan.calibration = base();
    return plan;
}

/// Before it goes on: at the end of a step, when the wizard is left.
bool WizardRun::keepReadings(Whose whose) {
    const FieldGuide* guide = fieldGuide();
    if (!guide || !capture_.shared().session().isOpen())
        return false;
    if (!keeper_)
        keeper_ = std::make_shared<FieldKeeper>();
    const FieldTakePlan plan = fieldPlan();
    const Status kept = keeper_->write(++keeper_->asked, plan, suit_, fieldRecord(*guide, whose));
    since_kept_.start();
    trouble_ = kept ? QString() : coreWords(kept.error());
    if (!kept)
        return false;
    unfinished_.evidence = {{QString::fromStdString(plan.path), FieldGuide::kSpot, {}, {}}};
    noteReadings();
    return true;
}

/// Meanwhile, so that a crash costs seconds only.
void WizardRun::keepReadingsBesides() {
    const FieldGuide* guide = fieldGuide();
    if (!guide || !capture_.shared().session().isOpen() || !hasReadings() ||
        (since_kept_.isValid() && since_kept_.elapsed() < kKeepEvery_ms))
        return;
    since_kept_.start();
    if (!keeper_)
        keeper_ = std::make_shared<FieldKeeper>();
    const FieldTakePlan plan = fieldPlan();
    capture_.shared().jobs().start<Done>(
        tr("Keeping %1").arg(wordsOf(task_).title),
        [keeper = keeper_, version = ++keeper_->asked, plan, suit = suit_,
         record = fieldRecord(*guide, Whose::kAll)](const JobContext&) -> Result<Done> {
            const Status kept = keeper->write(version, plan, suit, record);
            return kept ? Result<Done>(Done{}) : Result<Done>(kept.error());
        },
        [self = QPointer(this), path = QString::fromStdString(plan.path)](Result<Done> kept) -> QString {
            if (kept && self && self->phase_ == Phase::kGuiding && self->field_path_ == path) {
                if (self->unfinished_.evidence.empty())
                    self->unfinished_.evidence = {{path, FieldGuide::kSpot, {}, {}}};
                self->noteReadings();
            }
            return {};
        },
        Jobs::Loudness::kQuiet);
}

/// In the record of what is unfinished: one take, which shows all steps.
void WizardRun::noteReadings() {
    const FieldGuide& guide = *fieldGuide();
    const QString path = unfinished_.evidence.front().path;
    unfinished_.evidence.clear();
    for (int step = 0; step < guide.stepCount(); ++step) {
        // The spot without the floor is too little to go on from.
        if (step == FieldGuide::kSpot && !guide.isDone(FieldGuide::kFloor))
            continue;
        WizardEvidence part{path, step, {}, {}};
        for (int board = 0; board < static_cast<int>(suit_.boards.size()); ++board)
            if (!guide.isSkipped(board) && guide.isDone(step, board))
                part.boards.push_back(suit_.boards[static_cast<size_t>(board)].id);
        if (guide.isDone(step))
            unfinished_.evidence.push_back(std::move(part));
    }
    unfinished_.share = guide.isDone(FieldGuide::kTurn) ? 0 : guide.leastShare();
    if (unfinished_.evidence.empty())
        unfinished_.evidence.push_back({path, FieldGuide::kTurn, {}, {}});
    store();
}

/// The take goes to the trash: the operator took it back.
void WizardRun::dropReadings() {
    if (!unfinished_.evidence.empty())
        dropEvidence(unfinished_.evidence.front().step);
    unfinished_.evidence.clear();
    unfinished_.share = 0;
    field_path_.clear();
    if (hasReadings())
        keepReadings();
}

void WizardRun::startAnew(int board) {
    if (auto* guide = dynamic_cast<FieldGuide*>(guide_.get())) {
        guide->startAnew(board);
        emit changed();
    }
}

void WizardRun::leaveOutFloor() {
    auto* guide = dynamic_cast<FieldGuide*>(guide_.get());
    if (!guide || phase_ != Phase::kGuiding || !guide->isDone(FieldGuide::kSpot))
        return;
    guide->leaveOutFloor();
    guide->restart();
    keepReadings();
    emit changed();
}

void WizardRun::lookAtSpotAgain() {
    if (phase_ != Phase::kGuiding || !fieldGuide())
        return;
    guide_->repeat(FieldGuide::kFloor);
    guide_->repeat(FieldGuide::kSpot);
    guide_->restart();
    emit changed();
}

void WizardRun::useThoseDone() {
    const FieldGuide* guide = fieldGuide();
    if (!guide || phase_ != Phase::kGuiding || guide->enoughBoards() == 0)
        return;
    for (int board = 0; board < static_cast<int>(suit_.boards.size()); ++board)
        if (!guide->isSkipped(board) && guide->turnOf(board).state() != FieldTurnState::kDone) {
            guide_->skip(board, true);
            left_out_.insert(board);
        }
    solveNow();
}

}  // namespace noctule::ui
