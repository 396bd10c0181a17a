// SPDX-License-Identifier: Apache-2.0
#include "ui/views/connect/room_plan.h"

#include <algorithm>
#include <cmath>

#include "ui/style/paint.h"
#include "ui/style/theme.h"

namespace noctule::ui {
namespace {

constexpr double kBesideAnchors_m = 0.5, kSmallestRoom_m = 2;

}  // namespace

RoomPlan::RoomPlan(const Suit& anchors) {
    Eigen::AlignedBox3d box;
    for (const Board& board : anchors.boards)
        box.extend(board.p_segment_board_m);
    for (const Source& source : anchors.sources)
        box.extend(source.p_segment_source_m);
    const Vector3d middle = box.isEmpty() ? Vector3d::Zero() : Vector3d(box.center());
    const Vector3d size = box.isEmpty() ? Vector3d::Zero() : Vector3d(box.sizes());
    const double width_m = std::max(kSmallestRoom_m, size.x() + 2 * kBesideAnchors_m);
    const double depth_m = std::max(kSmallestRoom_m, size.z() + 2 * kBesideAnchors_m);
    extent_m_ = QRectF(middle.x() - width_m / 2, middle.z() - depth_m / 2, width_m, depth_m);
}

QPointF RoomPlan::at(const Vector3d& p_world_m) const {
    return {p_world_m.x() - extent_m_.center().x(), extent_m_.bottom() - p_world_m.z()};
}

void RoomPlan::paint(QPainter& painter, const QRectF& frame) const {
    const Theme& theme = Theme::get();
    const double scale = frame.width() / extent_m_.width();
    painter.setPen(QPen(theme.tokens().grid, theme.px(1)));
    for (double x = std::ceil(extent_m_.left()); x <= extent_m_.right(); ++x) {
        const double here = frame.left() + scale * (x - extent_m_.left());
        painter.drawLine(QPointF(here, frame.top()), QPointF(here, frame.bottom()));
    }
    for (double z = std::ceil(extent_m_.top()); z <= extent_m_.bottom(); ++z) {
        const double here = frame.top() + scale * (z - extent_m_.top());
        painter.drawLine(QPointF(frame.left(), here), QPointF(frame.right(), here));
    }
    paintBox(painter, frame, theme.px(4), {}, theme.tokens().edge);
}

}  // namespace noctule::ui
