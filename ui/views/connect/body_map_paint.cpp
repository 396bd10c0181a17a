// SPDX-License-Identifier: Apache-2.0
// How the body map looks.
#include <QPainter>
#include <QTimer>
#include <algorithm>

#include "ui/models/part_names.h"
#include "ui/style/theme.h"
#include "ui/views/connect/body_map.h"
#include "ui/views/connect/map_marker.h"

namespace noctule::ui {
void BodyMap::renewFigure() {
    const Theme& theme = Theme::get();
    const int drawing = drawingHeight();
    if (drawing < 50)
        return;
    std::map<std::string, QColor> marked;
    for (const Place& place : places_)
        if (place.is_board && (place.marker->tone() == Tone::kWarn || place.marker->tone() == Tone::kError))
            marked[suit_.boards[static_cast<size_t>(place.index)].segment] =
                backgroundOf(place.marker->tone());
    const double ratio = devicePixelRatioF();
    const QImage image = figure_->paint(static_cast<int>(drawing * ratio), theme.tokens().figure, marked);
    picture_ = QPixmap::fromImage(image);
    picture_.setDevicePixelRatio(ratio);
}

void BodyMap::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintGround(painter);
    painter.setFont(theme.font(TextRole::kSecondary));
    painter.setPen(tokens.t3);
    const QRect head(0, 0, width(), theme.px(kTop - 8));
    if (room_) {
        painter.drawText(head, Qt::AlignCenter, tr("The room and its anchors, from above"));
    } else {
        painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter, tr("Performer’s right"));
        painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter, tr("Performer’s left"));
    }
    for (const Place& place : places_)
        if (place.is_board)
            paintLabel(painter, place);
    if (dragged_ >= 0)
        paintDragged(painter);
}

/// The body or the room.
void BodyMap::paintGround(QPainter& painter) {
    if (room_) {
        const double pixels_per_m = scale(drawingHeight());
        const QSizeF size(2 * pixels_per_m * half_width_m(), drawingHeight());
        room_->paint(painter, QRectF(QPointF((width() - size.width()) / 2, floor() - size.height()), size));
        return;
    }
    if (picture_.isNull() && painted_)
        renewFigure();
    else if (picture_.isNull())  // a new page is there first, its figure the moment after
        QTimer::singleShot(0, this, [this] { update(); });
    painted_ = true;
    const QSizeF size = QSizeF(picture_.size()) / picture_.devicePixelRatio();
    painter.drawPixmap(QPointF((width() - size.width()) / 2, floor() - size.height()), picture_);
}

/// What is carried, and where it would go.
void BodyMap::paintDragged(QPainter& painter) const {
    const Theme& theme = Theme::get();
    const QPointF from = places_[static_cast<size_t>(dragged_)].at_px;
    painter.setPen(QPen(theme.tokens().acc, theme.px(2), Qt::DashLine));
    painter.drawLine(from, dragged_to_);
    const int onto = boardNear(dragged_to_);
    if (onto >= 0 && onto != dragged_) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(theme.tokens().acc, theme.px(2)));
        painter.drawEllipse(places_[static_cast<size_t>(onto)].at_px, theme.px(18), theme.px(18));
    }
}

void BodyMap::paintLabel(QPainter& painter, const Place& place) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const int edge = labelEdge(place.left_column);
    const int direction = place.left_column ? -1 : 1;

    const Tone tone = place.marker->tone();
    const bool quiet = tone == Tone::kNeutral || tone == Tone::kOk;
    painter.setPen(QPen(quiet ? tokens.line : colorOf(tone), 1));
    const QLineF line = leader(place);
    painter.drawPolyline(
        QVector<QPointF>{line.p1(), line.p2(), QPointF(edge - direction * theme.px(6), place.label_y)});

    const QFont name = theme.font(TextRole::kBody, true), detail = theme.font(TextRole::kSecondary);
    const int name_height = QFontMetrics(name).height(), detail_height = QFontMetrics(detail).height();
    const QString words = details_[static_cast<size_t>(place.index)];
    const int block = name_height + (words.isEmpty() ? 0 : detail_height);
    const int left = place.left_column ? 0 : edge, label_width = place.left_column ? edge : width() - edge;
    const auto alignment =
        static_cast<int>(Qt::AlignVCenter | (place.left_column ? Qt::AlignRight : Qt::AlignLeft));
    const int top = static_cast<int>(place.label_y) - block / 2;
    painter.setFont(name);
    painter.setPen(quiet ? tokens.t1 : colorOf(tone));
    painter.drawText(QRect(left, top, label_width, name_height), alignment,
                     boardName(suit_.boards[static_cast<size_t>(place.index)]));
    painter.setFont(detail);
    painter.setPen(quiet ? tokens.t3 : colorOf(tone));
    painter.drawText(QRect(left, top + name_height, label_width, detail_height), alignment, words);
}

}  // namespace noctule::ui
