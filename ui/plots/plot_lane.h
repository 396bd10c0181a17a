// SPDX-License-Identifier: Apache-2.0
// One lane of the plots: a title row with legend and the values at the cursor, tick labels at the left, and a
// canvas of Qwt. The lane draws; the LaneStack around it handles mouse and keys.
#pragma once

#include <qwt_plot.h>
#include <qwt_scale_div.h>

#include <QWidget>

#include "ui/plots/lane_content.h"
#include "ui/plots/lane_items.h"

namespace noctule::ui {

class PlotLane : public QWidget {
    Q_OBJECT
public:
    explicit PlotLane(QWidget* parent = nullptr);

    void setContent(LaneContent content);
    const LaneContent& content() const { return content_; }

    /// Draws anew, with a fitting axis of values.
    void draw(double from_s, double to_s, const LaneEmphasis& emphasis);
    /// Only the numbers in the title row change.
    void setCursor(double t_s);
    void setRightExtent(int right_px);

    QRect canvas() const;  ///< in the lane
    /// The values at the cursor.
    QString readout() const;
    /// As beside a tick of the axis.
    QString tickText(double value) const;
    std::pair<double, double> valueRange() const { return {value_low_, value_high_}; }

    struct Dot {
        QPointF position;  ///< in the lane
        QColor color;
    };
    /// Where the cursor crosses the curves.
    std::vector<Dot> dotsAt(double t_s) const;

    QSize minimumSizeHint() const override;

    static constexpr int kLeastHeight = 72, kTitleRow = 20;  ///< pixels at 100 percent

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Part {
        QString text;
        LanePen pen;
        bool operator==(const Part&) const = default;
    };
    void placeCanvas();
    void style();
    void fitValues();
    std::pair<double, double> seenValues() const;
    void paintTicks(QPainter& painter) const;
    int paintReadout(QPainter& painter, QRect row) const;
    std::optional<QString> readoutOf(const LaneCurve& curve, double t_s) const;

    LaneContent content_;
    QwtPlot* plot_;
    QwtScaleDiv ticks_;
    LaneEmphasis emphasis_;
    std::vector<CurveItem*> curves_;   ///< owned by the plot
    std::vector<PointsItem*> points_;  ///< owned by the plot
    std::vector<Part> readout_;
    double from_s_ = 0, to_s_ = 1, value_low_ = 0, value_high_ = 1, cursor_s_ = 0;
    int right_px_ = 0;
};

}  // namespace noctule::ui
