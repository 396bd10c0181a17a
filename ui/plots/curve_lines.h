// SPDX-License-Identifier: Apache-2.0
// A curve as the lines to draw: from its samples while they are few, else from the lowest and highest value
// of every column of device pixels, which covers the same pixels as all samples would.
#pragma once

#include <qwt_scale_map.h>

#include <QPolygonF>
#include <vector>

#include "core/review/series.h"

namespace noctule::ui {

/// Where times and values stand on a canvas.
struct CurveFrame {
    QwtScaleMap time, value;
    double ratio = 1;  ///< device pixels per pixel
};

/// Unbroken lines between two positions, and one column beyond on both sides so that a clip there cuts clean.
std::vector<QPolygonF> curveLines(const SeriesPyramid& curve, const CurveFrame& frame, double left_px,
                                  double right_px);

/// Closed polygons between two curves of the same times.
std::vector<QPolygonF> bandPolygons(const SeriesPyramid& low, const SeriesPyramid& high,
                                    const CurveFrame& frame, double left_px, double right_px);

}  // namespace noctule::ui
