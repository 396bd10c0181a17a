// SPDX-License-Identifier: Apache-2.0
// Lanes one under the other, sharing the height, with the time cursor and the markers as lines through all of
// them. Dragging moves the cursor; the wheel and pinching zoom at the pointer; Shift or the middle button and
// dragging pan; a double click shows the whole take. Keys: + and -, Ctrl+0, Ctrl+Left and Ctrl+Right, Left
// and Right.
#pragma once

#include <QWidget>
#include <vector>

#include "ui/models/review_context.h"
#include "ui/plots/plot_lane.h"
#include "ui/plots/repaint_limit.h"
#include "ui/plots/time_window.h"

namespace noctule::ui {

class LaneStack : public QWidget {
    Q_OBJECT
public:
    LaneStack(ReviewContext& review, TimeWindow& window, QWidget* parent = nullptr);

    void setLanes(std::vector<LaneContent> lanes);
    const std::vector<PlotLane*>& lanes() const { return lanes_; }
    /// What a scroll bar takes of the right extent.
    void setScrollBarWidth(int width_px);

    /// Left and right edge of all canvases.
    std::pair<int, int> timeExtent() const;

    QSize minimumSizeHint() const override;
    QSize sizeHint() const override { return minimumSizeHint(); }

protected:
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    class Overlay;
    enum class Drag { kNone, kTime, kPan };
    int leastLaneHeight() const;
    void place();
    void redraw();
    void moveCursor();
    double timeAt(double x_px) const;
    double zoomCentre() const;

    ReviewContext& review_;
    TimeWindow& window_;
    std::vector<PlotLane*> lanes_;
    Overlay* overlay_;
    RepaintLimit redraw_, move_cursor_;
    Drag drag_ = Drag::kNone;
    double drag_x_px_ = 0;
    int scroll_bar_px_ = 0;
};

}  // namespace noctule::ui
