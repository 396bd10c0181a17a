// SPDX-License-Identifier: Apache-2.0
// A wizard: its pages in the middle, rail and board table at the sides, the keys, the tones. One for all
// tasks; nothing here knows what is calibrated.
#pragma once

#include <QStackedWidget>
#include <map>
#include <memory>

#include "ui/models/studio.h"
#include "ui/wizards/wizard_run.h"

namespace noctule::ui {

class FieldLive;
class FieldSensors;
class ProgressLine;
class ResultSide;
class WizardBoards;
class WizardIntro;
class WizardLive;
class WizardRail;
class WizardResult;

class WizardPage : public QStackedWidget {
    Q_OBJECT
public:
    explicit WizardPage(Studio& studio, QWidget* parent = nullptr);
    ~WizardPage() override;

    void open(WizardTask task);
    /// On the buttons that leave it: "Back to Record".
    void setWayBack(const QString& words);
    /// What has been taken stays.
    void close();
    /// Null: none is open.
    WizardRun* run() { return run_.get(); }

    QWidget* rail();
    QWidget* side() { return side_; }
    WizardIntro& intro() { return *intro_; }
    WizardLive& live() { return *live_; }
    FieldLive& field() { return *field_; }
    FieldSensors& fieldSensors() { return *field_sensors_; }
    WizardResult& resultPage() { return *result_; }
    ResultSide& resultSide() { return *result_side_; }
    WizardBoards& boards() { return *boards_; }

    bool handleKey(int key);

signals:
    void leaveRequested();

private:
    void refresh();
    void showResult();
    void followGuide();

    Studio& studio_;
    std::unique_ptr<WizardRun> run_;
    WizardIntro* intro_;
    WizardLive* live_;
    FieldLive* field_;
    QWidget* solving_;
    ProgressLine* progress_;
    WizardResult* result_;
    WizardRail* rail_;
    QStackedWidget* side_;
    QWidget* nothing_;
    WizardBoards* boards_;
    FieldSensors* field_sensors_;
    ResultSide* result_side_;
    bool was_right_ = false;
};

}  // namespace noctule::ui
