// SPDX-License-Identifier: Apache-2.0
// Letters, arrows and words of the drawings of the rigs.
#include <QFontMetricsF>
#include <QLineF>
#include <algorithm>
#include <cmath>

#include "ui/wizards/rig_canvas.h"

namespace noctule::ui {

void RigCanvas::letter(char letter, const QPointF& at_px, const QPointF& outwards_px, bool filled) {
    const double radius = letterRadius_px(), length = std::hypot(outwards_px.x(), outwards_px.y());
    const QPointF centre = at_px + outwards_px * ((radius + px(5)) / std::max(length, 1e-6));
    painter_.setPen(QPen(filled ? tokens().acc : tokens().edge, px(1.5)));
    painter_.setBrush(filled ? tokens().acc : tokens().bg);
    painter_.drawEllipse(centre, radius, radius);
    QFont round = font(TextRole::kSection, true);
    round.setPixelSize(static_cast<int>(std::lround(radius * 1.1)));
    painter_.setFont(round);
    painter_.setPen(filled ? tokens().onacc : tokens().t1);
    const QRectF circle(centre - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius));
    painter_.drawText(circle, Qt::AlignCenter, QString(QChar(letter)));
    keepFree(circle);
    keepReadable(centre, radius + px(2));
}

void RigCanvas::arrow(const QPolygonF& line_px, const QColor& color, double width, bool both_ends) {
    if (line_px.size() < 2)
        return;
    const double pen = px(width), head = 3.2 * pen + px(4);
    const auto paintHead = [&](const QPointF& tip, const QPointF& before) {
        const QLineF back = QLineF::fromPolar(head, QLineF(tip, before).angle());
        const QPointF along = back.p2(), across = QPointF(-along.y(), along.x()) * 0.5;
        painter_.setPen(QPen(color, 1, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter_.setBrush(color);
        painter_.drawPolygon(QVector<QPointF>{tip, tip + along + across, tip + along - across});
        return tip + along * 0.8;
    };
    // The line ends inside its head; a head looks back along the part of the line that it covers.
    QPolygonF line = line_px;
    const auto shorten = [&](bool at_end) {
        const QPointF tip = at_end ? line.last() : line.first();
        while (line.size() > 2 && QLineF(tip, at_end ? line[line.size() - 2] : line[1]).length() < head)
            at_end ? line.removeLast() : line.removeFirst();
        const QPointF neck = paintHead(tip, at_end ? line[line.size() - (line.last() == tip ? 2 : 1)]
                                                   : line[line.first() == tip ? 1 : 0]);
        if (at_end)
            line.last() = neck;
        else
            line.first() = neck;
    };
    shorten(true);
    if (both_ends)
        shorten(false);
    painter_.setPen(QPen(color, pen, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawPolyline(line);
    for (const QPointF& point : line_px) {
        keepFree(QRectF(point - QPointF(head, head) / 2, QSizeF(head, head)));
        keepReadable(point, pen);
    }
}

QRectF RigCanvas::label(const QString& words, const QPointF& centre_px, const QColor& color, TextRole role) {
    painter_.setFont(font(role));
    painter_.setPen(color);
    const QSizeF size = QFontMetricsF(font(role)).size(Qt::TextSingleLine, words) + QSizeF(2, 0);
    QRectF rect(centre_px - QPointF(size.width(), size.height()) / 2, size);
    rect.moveLeft(std::clamp(rect.left(), 2.0, std::max(2.0, size_.width() - 2 - rect.width())));
    rect.moveTop(std::clamp(rect.top(), 0.0, std::max(0.0, size_.height() - rect.height())));
    painter_.drawText(rect, Qt::AlignCenter, words);
    keepFree(rect);
    return rect;
}

void RigCanvas::downArrow() {
    const QString words = RigDrawing::tr("down");
    const QRectF rect = label(words, QPointF(px(34), size_.height() - px(18)), tokens().t2, TextRole::kBody);
    const QPointF end(rect.center().x(), rect.top() - px(3));
    const double length = std::clamp(size_.height() * 0.11, px(36), px(64));
    const double wing = px(6);
    painter_.setPen(QPen(tokens().t2, px(2), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawLine(end, end - QPointF(0, length));
    painter_.drawPolyline(QVector<QPointF>{end + QPointF(-wing, -wing), end, end + QPointF(wing, -wing)});
    keepFree(QRectF(end - QPointF(wing, length), QSizeF(2 * wing, length)));
}

/// How many numbers and letters the line touches.
double RigCanvas::crossed(const QPointF& from_px, const QPointF& to_px) const {
    const QPointF way = to_px - from_px;
    const double square = std::max(1e-6, QPointF::dotProduct(way, way));
    return static_cast<double>(std::ranges::count_if(read_, [&](const Round& round) {
        const double part =
            std::clamp(QPointF::dotProduct(round.centre_px - from_px, way) / square, 0.0, 1.0);
        return QLineF(from_px + part * way, round.centre_px).length() < round.radius_px;
    }));
}

double RigCanvas::lengthOverSurfaces_px(const QPointF& from_px, const QPointF& to_px) const {
    constexpr int kSteps = 24;
    int inside = 0;
    for (int i = 0; i < kSteps; ++i) {
        const QPointF p = from_px + (to_px - from_px) * ((i + 0.5) / kSteps);
        inside += std::ranges::any_of(
            surfaces_, [&p](const QPolygonF& surface) { return surface.containsPoint(p, Qt::OddEvenFill); });
    }
    return QLineF(from_px, to_px).length() * inside / kSteps;
}

bool RigCanvas::isFree(const QRectF& rect_px) const {
    return std::ranges::none_of(taken_, [&](const QRectF& rect) { return rect.intersects(rect_px); }) &&
           std::ranges::none_of(surfaces_,
                                [&](const QPolygonF& surface) { return surface.intersects(rect_px); });
}

RigCanvas::CallOutPlace RigCanvas::placeForCallOut(const QSizeF& block_px,
                                                   const QVector<QPointF>& targets_px) const {
    constexpr double kPerNumber = 120, kOverSurface = 4, kBackwards = 300, kOnEdge = 80;
    const double margin = px(10), pad = px(8);
    CallOutPlace best;
    for (const bool left : {true, false})
        for (double top = margin; top + block_px.height() + margin < size_.height(); top += px(4)) {
            const QRectF block(QPointF(left ? margin : size_.width() - margin - block_px.width(), top),
                               block_px);
            if (!isFree(block.adjusted(-pad, -pad / 2, pad, pad / 2)))
                continue;
            const bool calm = std::ranges::none_of(
                quiet_, [&block](const QPolygonF& surface) { return surface.intersects(block); });
            const QPointF from = left ? block.bottomRight() : block.bottomLeft();
            for (const QPointF& target : targets_px) {
                const bool backwards = left ? target.x() < from.x() + pad : target.x() > from.x() - pad;
                const double cost =
                    QLineF(from, target).length() + kOverSurface * lengthOverSurfaces_px(from, target) +
                    kPerNumber * crossed(from, target) + (backwards ? kBackwards : 0) + (calm ? 0 : kOnEdge);
                if (cost < best.cost)
                    best = {block, target, left, cost};
            }
        }
    if (best.block_px.isNull())  // nothing is free: over the drawing, at the top
        best = {QRectF(QPointF(margin, margin), block_px), targets_px.first()};
    return best;
}

void RigCanvas::callOut(const RigPicture& picture, const QVector<QPointF>& targets_px) {
    if (picture.wrong_board < 0 || targets_px.isEmpty())
        return;
    const bool roomy = size_.width() >= theme_.px(700);
    const QFont title = font(roomy ? TextRole::kPage : TextRole::kSection, true);
    const QFont text = font(roomy ? TextRole::kBody : TextRole::kSecondary);
    const QFontMetricsF title_metrics(title);
    const double most = std::max(0.2 * size_.width(), px(96));
    const QRectF words = QFontMetricsF(text).boundingRect(QRectF(0, 0, most, size_.height()),
                                                          Qt::TextWordWrap, picture.call_out_text);
    const double wide = std::max(words.width(), title_metrics.horizontalAdvance(picture.call_out_title)) + 2;
    const CallOutPlace place =
        placeForCallOut({wide, title_metrics.height() + words.height() + px(6)}, targets_px);
    const QRectF& block = place.block_px;

    painter_.setFont(title);
    painter_.setPen(tokens().warn);
    painter_.drawText(block, Qt::AlignLeft | Qt::AlignTop, picture.call_out_title);
    painter_.setFont(text);
    painter_.setPen(tokens().t2);
    painter_.drawText(block.adjusted(0, title_metrics.height(), 1, 0), Qt::AlignLeft | Qt::TextWordWrap,
                      picture.call_out_text);
    painter_.setPen(QPen(tokens().warn, px(2), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter_.setBrush(Qt::NoBrush);
    const QPointF near = place.left ? block.bottomRight() : block.bottomLeft();
    painter_.drawPolyline(
        QVector<QPointF>{place.left ? block.bottomLeft() : block.bottomRight(), near, place.target_px});
}

}  // namespace noctule::ui
