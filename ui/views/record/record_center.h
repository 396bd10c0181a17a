// SPDX-License-Identifier: Apache-2.0
// Centre of Record: the live body with the take's clock on it, what stands in the way of a take, the record
// bar, and below it levels and pairs.
#pragma once

#include <QWidget>

#include "ui/models/studio.h"
#include "ui/views/record/record_run.h"

class QVBoxLayout;

namespace noctule::ui {

class LevelsPanel;
class ProblemCard;
class RecordBar;
class SceneView;
class TakeClock;
class ToolButton;

class RecordCenter : public QWidget {
    Q_OBJECT
public:
    RecordCenter(Studio& studio, RecordRun& run, QWidget* parent = nullptr);

    SceneView& scene() { return *scene_; }
    RecordBar& bar() { return *bar_; }
    TakeClock& clock() { return *clock_; }
    LevelsPanel& levels() { return *levels_; }
    ToolButton& placeResetButton() { return *reset_; }
    /// Null: nothing was refused.
    ProblemCard* refusal() { return refusal_; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    void wear();
    void followLinks();
    void showFrame();
    void showTake();
    void showTime();
    void showRefusal();
    void followObstacle();
    void closeRefusal();

    Studio& studio_;
    RecordRun& run_;
    SceneView* scene_;
    ToolButton* reset_;  ///< of heading and place
    TakeClock* clock_;
    RecordBar* bar_;
    LevelsPanel* levels_;
    QVBoxLayout* column_;
    ProblemCard* refusal_ = nullptr;
    QString refused_text_;  ///< that it tells
    bool offers_record_anyway_ = false;
    int silent_suits_ = 0;  ///< as drawn last
};

}  // namespace noctule::ui
