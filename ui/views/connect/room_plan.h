// SPDX-License-Identifier: Apache-2.0
// The room that anchors hang in, from above: x to the right, z down, a line for every metre.
#pragma once

#include <QPainter>
#include <QPointF>
#include <QRectF>

#include "core/suit/suit.h"

namespace noctule::ui {

class RoomPlan {
public:
    explicit RoomPlan(const Suit& anchors);

    /// Metres from the middle of the plan's lower edge, y up: as on the drawing of a body.
    QPointF at(const Vector3d& p_world_m) const;
    double height_m() const { return extent_m_.height(); }
    double half_width_m() const { return extent_m_.width() / 2; }
    /// Floor and metres.
    void paint(QPainter& painter, const QRectF& frame) const;

private:
    QRectF extent_m_;  ///< x and z of the room's frame
};

}  // namespace noctule::ui
