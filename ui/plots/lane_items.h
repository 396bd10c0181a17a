// SPDX-License-Identifier: Apache-2.0
// What is drawn on the canvas of a lane: curves with their bands, points by gate decision, marks. All of it
// costs time by the pixel and not by the sample.
#pragma once

#include <qwt_plot_item.h>

#include <QPen>

#include "ui/plots/lane_content.h"

namespace noctule::ui {

QColor penColor(LanePen pen);
/// One pixel wide whatever the scale; the reference is dashed.
QPen penOf(LanePen pen);

/// The symbol of a gate decision: shape and colour.
void drawFate(QPainter& painter, const QPointF& centre, RangeFate fate);
/// Size of the symbols, pixels.
double fateSize();

/// What lies between in and out is drawn in full, the rest at 45 %.
struct LaneEmphasis {
    double in_s = 0, out_s = 0;
};

class CurveItem : public QwtPlotItem {
public:
    explicit CurveItem(LaneCurve curve);
    void setEmphasis(LaneEmphasis emphasis) { emphasis_ = emphasis; }
    int rtti() const override { return Rtti_PlotUserItem; }
    void draw(QPainter* painter, const QwtScaleMap& time, const QwtScaleMap& value,
              const QRectF& canvas) const override;

private:
    void drawPart(QPainter& painter, const QwtScaleMap& time, const QwtScaleMap& value,
                  const QRectF& part) const;

    LaneCurve curve_;
    LaneEmphasis emphasis_;
};

class PointsItem : public QwtPlotItem {
public:
    explicit PointsItem(LaneCurve curve);
    void setEmphasis(LaneEmphasis emphasis) { emphasis_ = emphasis; }
    int rtti() const override { return Rtti_PlotUserItem + 1; }
    void draw(QPainter* painter, const QwtScaleMap& time, const QwtScaleMap& value,
              const QRectF& canvas) const override;

private:
    LaneCurve curve_;
    LaneEmphasis emphasis_;
};

class MarksItem : public QwtPlotItem {
public:
    explicit MarksItem(LaneMarks marks);
    int rtti() const override { return Rtti_PlotUserItem + 2; }
    void draw(QPainter* painter, const QwtScaleMap& time, const QwtScaleMap& value,
              const QRectF& canvas) const override;

private:
    LaneMarks marks_;
};

}  // namespace noctule::ui
