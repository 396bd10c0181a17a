// SPDX-License-Identifier: Apache-2.0
// The middle of a wizard while it runs: which step, what to do in words that are read from three metres, its
// drawing, one live sentence with the ring that fills while all is right, and up to three measures.
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "ui/wizards/exercise_figures.h"

namespace noctule::ui {

class HoldRing;
class Label;
class MeasureMeter;
class RigDrawing;
class CaptureContext;
class ToneCard;
class WizardRun;

class WizardLive : public QWidget {
    Q_OBJECT
public:
    explicit WizardLive(CaptureContext& capture, QWidget* parent = nullptr);

    void setRun(WizardRun* run);
    QString instruction() const;
    QString sentence() const;

private:
    QWidget* makeCard();
    QWidget* makeMeasures();
    void refresh();
    void showPicture();
    void dress();
    std::optional<int> exerciseFrame() const;
    void showMeasures();

    CaptureContext& capture_;
    WizardRun* run_ = nullptr;
    Label *step_, *so_far_, *instruction_;
    RigDrawing* drawing_;
    /// What the drawing shows: -1 the rest pose, else an exercise's frame; absent: nothing yet.
    std::optional<int> dressed_for_;
    ExerciseFigures exercises_;
    ToneCard* card_ = nullptr;
    HoldRing* ring_;
    Label *sentence_, *detail_;
    std::array<MeasureMeter*, 3> measures_{};
};

}  // namespace noctule::ui
