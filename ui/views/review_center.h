// SPDX-License-Identifier: Apache-2.0
// Centre of Review: the body (or two side by side) and the confidence of its pairs above, plots, timeline and
// transport below.
#pragma once

#include <QWidget>

#include "ui/models/studio.h"

class QSplitter;

namespace noctule::ui {

class HeatMap;
class PlotPanel;
class SceneArea;
class Timeline;
class TransportBar;

class ReviewCenter : public QWidget {
    Q_OBJECT
public:
    explicit ReviewCenter(Studio& studio, QWidget* parent = nullptr);
    ~ReviewCenter() override;

    SceneArea& scenes() { return *scenes_; }
    HeatMap& heatMap() { return *heat_map_; }
    PlotPanel& plots() { return *plots_; }
    Timeline& timeline() { return *timeline_; }
    TransportBar& transport() { return *transport_; }

private:
    void restoreSplitters();
    void keepSplitters() const;

    Studio& studio_;
    SceneArea* scenes_;
    HeatMap* heat_map_;
    PlotPanel* plots_;
    Timeline* timeline_;
    TransportBar* transport_;
    QSplitter *above_, *whole_;
};

}  // namespace noctule::ui
