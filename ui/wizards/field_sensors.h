// SPDX-License-Identifier: Apache-2.0
// Right of the magnetometers' wizard: the sensors, what is to be looked at (iron beside one of them), the
// field of the spot, and the ways on.
#pragma once

#include <QWidget>

#include "core/guide/field_guide.h"

namespace noctule::ui {

class Button;
class FieldTable;
class Label;
class ProblemCard;
class WizardRun;

class FieldSensors : public QWidget {
    Q_OBJECT
public:
    explicit FieldSensors(QWidget* parent = nullptr);

    void setRun(WizardRun* run);
    /// "Use the 9 that are done"
    Button* enoughButton() { return enough_; }
    Button* anewButton() { return anew_; }
    Button* sensorAnewButton() { return sensor_anew_; }
    Button* skipButton() { return skip_; }
    Button* withoutFloorButton() { return without_floor_; }
    void skipSensor();

private:
    QWidget* makeSpot();
    QWidget* makeFoot();
    void refresh();
    void showTrouble(int board);
    void showSpot(const SpotField& spot);
    void showWaysOn(const FieldGuide& guide, int done);
    void unskipAll();
    int troubledBoard() const;

    WizardRun* run_ = nullptr;
    Label* count_;
    FieldTable* table_;
    ProblemCard* card_;
    Button *sensor_anew_, *skip_;
    Label *strength_, *dip_, *floor_, *words_;
    Button *anew_, *enough_, *back_, *without_floor_, *unskip_;
};

}  // namespace noctule::ui
