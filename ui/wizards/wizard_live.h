// SPDX-License-Identifier: Apache-2.0
// The middle of a wizard while it runs: which step, what to do in words that are read from three metres, its
// drawing, one live sentence with the ring that fills while all is right, and up to three measures.
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "ui/wizards/exercise_figures.h"

class QBoxLayout;

namespace noctule::ui {

class Label;
class MeasureMeter;
class RigDrawing;
class CaptureContext;
class SentenceCard;
class WizardRun;

class WizardLive : public QWidget {
    Q_OBJECT
public:
    explicit WizardLive(CaptureContext& capture, QWidget* parent = nullptr);

    void setRun(WizardRun* run);
    QString instruction() const;
    QString sentence() const;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeMeasures();
    void refresh();
    void showPicture();
    void dress();
    std::optional<int> exerciseFrame() const;
    void showMeasures();
    void fit(bool anew);

    CaptureContext& capture_;
    WizardRun* run_ = nullptr;
    Label *step_, *so_far_, *instruction_;
    RigDrawing* drawing_;
    /// What the drawing shows: -1 the rest pose, else an exercise's frame; absent: nothing yet.
    std::optional<int> dressed_for_;
    ExerciseFigures exercises_;
    SentenceCard* card_;
    QBoxLayout* measures_row_ = nullptr;
    std::array<MeasureMeter*, 3> measures_{};
    int shown_step_ = -1;
};

}  // namespace noctule::ui
