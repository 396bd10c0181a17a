// SPDX-License-Identifier: Apache-2.0
// One calibration from its first page to its result: what the suit shows is given to a guide (core/guide);
// when a step has been right for long enough the last seconds are kept as a short take; when nothing is
// missing the takes go to the solver, the same one that `noctule --batch calibrate` runs. What has been kept
// survives leaving, a crash and another day.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <memory>
#include <optional>
#include <set>

#include "core/guide/field_guide.h"
#include "core/processing/field_take.h"
#include "ui/models/capture_context.h"
#include "ui/models/transitions.h"
#include "ui/wizards/task_work.h"
#include "ui/wizards/unfinished_calibration.h"
#include "ui/wizards/wizard_task.h"

namespace noctule::ui {

class WizardRun : public QObject {
    Q_OBJECT
public:
    enum class Phase {
        kIntro,
        kGuiding,
        kTaking,  ///< a step is being kept
        kSolving,
        kResult,
    };
    static std::span<const PhaseTransition<Phase>> transitions();

    WizardRun(CaptureContext& capture, WizardTask task, QObject* parent = nullptr);
    ~WizardRun() override;

    WizardTask task() const { return task_; }
    Phase phase() const { return phase_; }

    // Before it begins.
    /// The file with the jig's distances; in words what is wrong with it, else empty.
    QString setDistances(const QString& path);
    const QString& distancesPath() const { return unfinished_.distances_path; }
    int distanceCount() const { return static_cast<int>(known_.distances.size()); }
    /// Why it cannot begin; empty: it can.
    QString whyNotBegin() const;
    /// Something was kept before, and begin() goes on with it.
    bool isUnfinished() const { return !unfinished_.evidence.empty(); }
    const UnfinishedCalibration& unfinished() const { return unfinished_; }
    void begin();
    void beginAnew();
    /// Nothing is measured: the takes are what there is.
    void solveTakes(const QStringList& paths);

    // While it runs.
    /// Null before it begins, or as long as no suit is connected.
    const Guide* guide() const { return guide_.get(); }
    const Suit& suit() const { return suit_; }
    /// The suit has gone, or its link is broken.
    bool isWaitingForSuit() const;
    /// The one that is shown, or the next that is missing.
    int step() const;
    int stepCount() const { return guide_ ? guide_->stepCount() : 0; }
    StepWords stepWords(int step) const;
    /// Which of the six sides is up in a step.
    int sideOf(int step) const;
    double heldShare() const;
    double secondsSoFar() const;
    /// Of the magnetometers; null for other tasks.
    const FieldGuide* fieldGuide() const;
    /// What one magnetometer has read, from the beginning.
    void startAnew(int board);
    /// Magnetometers: with the sensors that have enough; the others are skipped.
    void useThoseDone();
    /// Magnetometers: the field near the floor is not looked at.
    void leaveOutFloor();
    /// Magnetometers: the field of the spot once more; what was turned stays.
    void lookAtSpotAgain();
    void skip(int board, bool skipped);
    void repeat(int step);
    /// The step that was kept last, once more.
    void goBack();
    /// From the result back to the steps, as they are.
    void resume();
    /// Somebody looks at another page: nothing is taken meanwhile.
    void setPaused(bool paused);
    bool canGoBack() const { return isUnfinished(); }
    /// With what there is; the solver says what is missing.
    void solveNow();

    // The result.
    const std::optional<CalibrationResult>& result() const { return result_; }
    QString trouble() const { return trouble_; }
    Job* job() const { return job_; }
    /// Writes and uses it; in words why not, else empty.
    QString save();
    bool isSaved() const { return !saved_file_.isEmpty(); }
    /// Saved, and neither undone nor replaced since.
    bool isInUse() const { return isSaved() && capture_.calibrations().fileInForce() == saved_file_; }

    bool tones() const;
    void setTones(bool tones);

signals:
    void changed();
    /// Ten times a second while it guides.
    void guided();
    void stepKept(int step);

private:
    void setPhase(Phase phase);
    void watch();
    std::optional<int> stepShownBy(const WizardEvidence& part) const;
    void followWearing();
    void followBox();
    void followLink();
    void leaveSuit();
    int sampleRate_hz() const;
    void look();
    void keep();
    void kept(const QString& path, const QString& trouble);
    void dropEvidence(int step);
    void solve(const std::vector<std::string>& paths);
    // Of a guide that keeps readings (magnetometers): they are a take that is written again and again.
    enum class Whose { kAll, kNotSkipped };
    struct FieldKeeper;
    void restoreReadings(const FieldGuide* before, const Suit& suit_before);
    FieldRecord fieldRecord(const FieldGuide& guide, Whose whose) const;
    bool hasReadings() const;
    QString fieldPath();
    FieldTakePlan fieldPlan();
    bool keepReadings(Whose whose = Whose::kAll);
    void keepReadingsBesides();
    void noteReadings();
    void dropReadings();
    void solved(Result<CalibrationResult> result);
    void store() const;
    void restore();
    void forget();
    QString statePath() const;
    std::optional<Calibration> base() const;

    CaptureContext& capture_;
    const WizardTask task_;
    Phase phase_ = Phase::kIntro;
    KnownDistances known_;
    std::unique_ptr<Guide> guide_;
    Suit suit_;
    int64_t looked_at_ = -1;
    std::shared_ptr<FieldKeeper> keeper_;
    QString field_path_;
    QElapsedTimer since_kept_;
    std::set<int> left_out_;  ///< by useThoseDone()
    UnfinishedCalibration unfinished_;
    QElapsedTimer since_begin_;
    std::optional<CalibrationResult> result_;
    QString trouble_;
    QString of_suit_;  ///< serial number of the box whose steps are kept; empty before one is connected
    QPointer<Job> job_;
    int solving_ = 0;  ///< what jobs of an earlier one bring is void
    QString saved_file_;
    bool paused_ = false;
    bool is_gone_ = false;        ///< the suit, while a step was to be shown
    bool from_evidence_ = false;  ///< the result, or else from takes that were recorded elsewhere
};

}  // namespace noctule::ui
