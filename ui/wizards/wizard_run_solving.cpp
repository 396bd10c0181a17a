// SPDX-License-Identifier: Apache-2.0
// From the takes of a run to its result, and to the calibration in force.
#include <utility>

#include "ui/language/core_words.h"
#include "ui/wizards/wizard_run.h"

namespace noctule::ui {

void WizardRun::solveNow() {
    if (phase_ != Phase::kGuiding)
        return;
    // What is skipped must not be calibrated from the take, whoever does it.
    if (guide_->keepsReadings() && !keepReadings(Whose::kNotSkipped))
        return emit changed();
    std::vector<std::string> paths;
    for (const WizardEvidence& part : unfinished_.evidence)
        if (const std::string path = part.path.toStdString(); paths.empty() || paths.back() != path)
            paths.push_back(path);
    from_evidence_ = true;
    if (!paths.empty())
        solve(paths);
}

void WizardRun::solveTakes(const QStringList& paths) {
    std::vector<std::string> files;
    for (const QString& path : paths)
        files.push_back(path.toStdString());
    from_evidence_ = false;
    if (!files.empty() && capture_.shared().session().makeSure())
        solve(files);
}

void WizardRun::solve(const std::vector<std::string>& paths) {
    CalibrateRequest request;
    request.take_paths = paths;
    // A pose that is repeated counts as it was last.
    if (task_ == WizardTask::kRestPose || task_ == WizardTask::kCheck)
        request.take_paths = {paths.back()};
    request.base = base();
    if (from_evidence_ && capture_.suit().phase() != LiveSuit::Phase::kNone)
        request.actor = capture_.suit().actor();
    request.created_utc = capture_.shared().parts().utc_now();
    for (int board = 0; guide_ && from_evidence_ && board < static_cast<int>(suit_.boards.size()); ++board)
        if (guide_->isSkipped(board))
            request.left_out.push_back(suit_.boards[static_cast<size_t>(board)].id);
    saved_file_.clear();
    KnownDistances known = known_;
    std::erase_if(known.distances, [this](const KnownDistance& distance) {
        const int board = guide_ && from_evidence_ ? suit_.findBoard(distance.board) : -1;
        return board >= 0 && guide_->isSkipped(board);
    });
    job_ = capture_.shared().jobs().start<CalibrationResult>(
        tr("Calibration: %1").arg(wordsOf(task_).title),
        [task = task_, request, known](const JobContext& job) {
            return solveTask(task, request, known, job);
        },
        [self = QPointer(this), solving = ++solving_](Result<CalibrationResult> result) -> QString {
            // Of a suit that was left meanwhile nothing is shown.
            if (self && self->solving_ == solving)
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
        const bool is_judged = result_->grade() != Grade::kUnknown;
        if (task_ == WizardTask::kCheck && from_evidence_ && guide_ && is_judged)
            capture_.setChecked(CheckedSuit{QDateTime::currentDateTime(), result_->grade() == Grade::kGood});
        return setPhase(Phase::kResult);
    }
    if (result.error().kind != ErrorKind::kCancelled)
        trouble_ = coreWords(result.error());
    setPhase(guide_ ? Phase::kGuiding : Phase::kIntro);
}

QString WizardRun::save() {
    if (!result_ || isSaved())
        return {};
    if (const QString why = capture_.calibrations().save(*result_, keyOf(task_)); !why.isEmpty())
        return why;
    saved_file_ = capture_.calibrations().fileInForce();
    if (from_evidence_)
        forget();
    emit changed();
    return {};
}

}  // namespace noctule::ui
