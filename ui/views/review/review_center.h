// SPDX-License-Identifier: Apache-2.0
// Centre of Review: the body (or two side by side) and the confidence of its pairs above, plots, timeline and
// transport below. On small screens and with large type parts give way in this order: the left dock closes
// (SideDocks), body and pairs share one place behind two tabs, the body becomes as low as it can be, and the
// plots keep one whole lane. Only below that what is above the timeline scrolls: body and curves are seen at
// once at 1280 by 800 with text of 150 percent. Nothing becomes smaller than it can be read.
#pragma once

#include <QWidget>

#include "ui/models/review_context.h"

class QSplitter;

namespace noctule::ui {

class Button;
class HeatMap;
class PerformerSwitch;
class PlotPanel;
class SceneArea;
class Timeline;
class TransportBar;

class ReviewCenter : public QWidget {
    Q_OBJECT
public:
    explicit ReviewCenter(ReviewContext& review, QWidget* parent = nullptr);
    ~ReviewCenter() override;

    PerformerSwitch& performers() { return *performers_; }
    SceneArea& scenes() { return *scenes_; }
    HeatMap& heatMap() { return *heat_map_; }
    PlotPanel& plots() { return *plots_; }
    Timeline& timeline() { return *timeline_; }
    TransportBar& transport() { return *transport_; }
    /// Body and pairs share one place; tabs choose.
    bool isFolded() const { return !tabs_->isHidden(); }
    void showPairs(bool pairs);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeTabs();
    void fold();
    void restoreSplitters();
    void keepSplitters() const;

    ReviewContext& review_;
    PerformerSwitch* performers_;
    SceneArea* scenes_;
    HeatMap* heat_map_;
    PlotPanel* plots_;
    Timeline* timeline_;
    TransportBar* transport_;
    QSplitter *above_, *whole_;
    Button *body_tab_ = nullptr, *pairs_tab_ = nullptr;
    bool shows_pairs_ = false;
    QWidget* tabs_;
};

}  // namespace noctule::ui
