// SPDX-License-Identifier: Apache-2.0
// Step Connect: left which devices there are and who wears the suit, in the middle the suit on the body as it
// is now and its pairs, right whether it is ready. Anchors hang in their room instead. Without a suit the
// drawing shows where boards and sources of the performer's suit sit.
#pragma once

#include "ui/models/capture_context.h"
#include "ui/views/page.h"

class QHBoxLayout;
class QVBoxLayout;

namespace noctule::ui {

class AssignPanel;
class BoardCard;
class BodyMap;
class Button;
class DevicesPanel;
class LivePairs;
class MapLegend;
class ReadinessPanel;

class ConnectPage : public Page {
    Q_OBJECT
public:
    explicit ConnectPage(CaptureContext& capture, QWidget* parent = nullptr);

    QString title() const override { return tr("Connect"); }
    QWidget* leftDock() override { return left_; }
    QWidget* rightDock() override;
    void enter() override;

    BodyMap& map() { return *map_; }
    DevicesPanel& devices() { return *devices_; }
    AssignPanel& assigning() { return *assigning_; }
    ReadinessPanel& readiness() { return *readiness_; }
    LivePairs& pairs() { return *pairs_; }
    BoardCard& card() { return *card_; }
    int chosenBoard() const { return board_; }

signals:
    void putSuitOnRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeLeft();
    QWidget* makeCentre();
    void addActions();
    void connectStudio();
    void showSuit();
    void showState();
    void showLayout();
    void choose(int board);
    void blink();
    void takeOff();

    CaptureContext& capture_;
    DevicesPanel* devices_;
    AssignPanel* assigning_;
    ReadinessPanel* readiness_;
    QWidget* left_;
    QWidget *drawing_, *beside_;
    QHBoxLayout* upper_;
    QVBoxLayout* beside_column_;
    BodyMap* map_ = nullptr;
    BoardCard* card_;
    MapLegend* legend_;
    LivePairs* pairs_;
    QAction *blink_, *take_off_;
    int board_ = -1;
};

}  // namespace noctule::ui
