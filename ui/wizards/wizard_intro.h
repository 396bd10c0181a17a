// SPDX-License-Identifier: Apache-2.0
// The first page of a wizard: what is needed, how long it takes, how things stand and where box and wires go,
// with a drawing of the set-up; then it begins, goes on with what was taken before, or works on takes that
// were recorded elsewhere.
#pragma once

#include <QWidget>

namespace noctule::ui {

class Button;
class Label;
class ProblemCard;
class FieldDrawing;
class RigDrawing;
class CaptureContext;
class WizardRun;
struct UnfinishedCalibration;

class WizardIntro : public QWidget {
    Q_OBJECT
public:
    explicit WizardIntro(CaptureContext& capture, QWidget* parent = nullptr);

    void setRun(WizardRun* run);
    /// "Begin", or "Go on" with what was taken before.
    Button* beginButton() { return begin_; }
    Button* anewButton() { return anew_; }
    Button* distancesButton() { return distances_; }
    Button* takesButton() { return takes_; }
    /// As if it had been chosen in the dialog.
    void useDistances(const QString& path);
    QString problem() const;
    /// The title of the calibration that should be done before this one; empty: none.
    QString prerequisite() const;
    /// For the dock beside it.
    QWidget* words() { return words_; }
    /// "3 steps were taken on 5 March 2026 and are kept."; empty: none was.
    static QString keptWords(const UnfinishedCalibration& unfinished);

private:
    void makeWords();
    void refresh();
    void showProblem();
    void chooseDistances();
    void chooseTakes();

    CaptureContext& capture_;
    WizardRun* run_ = nullptr;
    Label *what_, *needs_, *set_up_, *distances_words_, *kept_words_;
    QWidget* words_;
    RigDrawing* drawing_;
    FieldDrawing* sphere_;
    ProblemCard *problem_, *prerequisite_;
    QString no_distances_;  ///< why the file that was chosen last could not be read
    Button *begin_, *anew_, *distances_, *takes_;
};

}  // namespace noctule::ui
