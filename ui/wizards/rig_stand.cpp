// SPDX-License-Identifier: Apache-2.0
// The performer in the rest pose, boards as dots.
#include <algorithm>
#include <cmath>

#include "ui/wizards/rig_canvas.h"

namespace noctule::ui {
namespace {

struct Dot {
    QPointF at_px, number_px;
    int index;
};

QFont numberFont(const RigCanvas& canvas) {
    QFont number = canvas.font(TextRole::kSection, true);
    number.setPixelSize(
        static_cast<int>(std::lround(std::clamp(canvas.height_px() * 0.036, canvas.px(15), canvas.px(24)))));
    return number;
}

/// Numbers beside their dots, outwards, all as far from them, with one digit or two; each is pushed down
/// until it is clear of those above.
std::vector<Dot> dotsOf(const BodyFigure& figure, const Suit& suit, size_t count, const QPointF& feet_px,
                        double scale, double clear_px, const QFont& number) {
    const QFontMetricsF metrics(number);
    const double high_px = metrics.capHeight() * 1.5;
    const auto wide = [&](int index) { return metrics.horizontalAdvance(QString::number(index + 1)); };
    std::vector<Dot> dots;
    for (size_t i = 0; i < std::min(count, suit.boards.size()); ++i) {
        if (suit.boards[i].segment.empty())
            continue;
        const QPointF p = figure.board(suit.boards[i]) * scale;
        const QPointF at(feet_px.x() + p.x(), feet_px.y() - p.y());
        const int index = static_cast<int>(i);
        const double beside_px = clear_px + wide(index) / 2;
        dots.push_back({at, at + QPointF(p.x() < -1 ? -beside_px : beside_px, 0), index});
    }
    std::ranges::sort(dots, {}, [](const Dot& dot) { return dot.at_px.y(); });
    for (size_t i = 0; i < dots.size(); ++i)
        for (size_t before = 0; before < i; ++before) {
            const QPointF apart = dots[i].number_px - dots[before].number_px;
            const double both_px = (wide(dots[i].index) + wide(dots[before].index)) / 2;
            if (std::abs(apart.x()) < both_px && apart.y() < high_px)
                dots[i].number_px.ry() = dots[before].number_px.y() + high_px;
        }
    return dots;
}

/// The sign within a dot, so that no state shows by its colour alone.
void paintSign(QPainter& painter, const QPointF& at, double radius, BoardMark mark) {
    const Tokens& tokens = Theme::get().tokens();
    const bool filled = mark == BoardMark::kDone || mark == BoardMark::kWrong;
    painter.setPen(QPen(filled ? tokens.bg : boardLook(mark).number, std::max(1.5, radius * 0.28),
                        Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const auto p = [&](double x, double y) { return at + radius * QPointF(x, y); };
    switch (mark) {
        case BoardMark::kRight:
            painter.setPen(Qt::NoPen);
            painter.setBrush(tokens.acc);
            painter.drawEllipse(at, radius * 0.45, radius * 0.45);
            break;
        case BoardMark::kDone:
            painter.setBrush(Qt::NoBrush);
            painter.drawPolyline(QVector<QPointF>{p(-0.45, 0.05), p(-0.1, 0.4), p(0.5, -0.35)});
            break;
        case BoardMark::kWrong:
            painter.drawLine(p(0, -0.5), p(0, 0.05));
            painter.drawPoint(p(0, 0.5));
            break;
        case BoardMark::kSkipped:
            painter.drawLine(p(-0.4, 0), p(0.4, 0));
            break;
        case BoardMark::kWaiting:
        case BoardMark::kAbsent:
            break;
    }
}

void paintDot(RigCanvas& canvas, const Dot& dot, BoardMark mark, double radius) {
    const Tokens& tokens = canvas.tokens();
    const RigBoardLook look = boardLook(mark);
    QPainter& painter = canvas.painter();
    QPen pen(look.box.outline, canvas.px(2));
    if (look.box.dashed)
        pen.setDashPattern({1.5, 1.5});
    painter.setPen(pen);
    painter.setBrush(mark == BoardMark::kDone    ? tokens.ok
                     : mark == BoardMark::kWrong ? tokens.warn
                                                 : tokens.raised);
    painter.drawEllipse(dot.at_px, radius, radius);
    paintSign(painter, dot.at_px, radius, mark);

    painter.setFont(numberFont(canvas));
    painter.setPen(look.number);
    const QPointF reach(canvas.px(30), canvas.px(15));
    painter.drawText(QRectF(dot.number_px - reach, dot.number_px + reach), Qt::AlignCenter,
                     QString::number(dot.index + 1));
}

/// A flat arrow on the floor, to the viewer.
void paintForward(RigCanvas& canvas, const QPointF& from, double length) {
    const Tokens& tokens = canvas.tokens();
    const double near = length * 0.5, far = length * 0.34, wing = length * 1.05, neck = length * 0.48;
    canvas.painter().setPen(Qt::NoPen);
    canvas.painter().setBrush(tokens.acc);
    canvas.painter().drawPolygon(QVector<QPointF>{from + QPointF(-far, 0), from + QPointF(far, 0),
                                                  from + QPointF(near, neck), from + QPointF(wing, neck),
                                                  from + QPointF(0, length), from + QPointF(-wing, neck),
                                                  from + QPointF(-near, neck)});
    const QFontMetricsF metrics(canvas.font(TextRole::kSection));
    const QString words = RigDrawing::tr("forward");
    canvas.label(words,
                 from + QPointF(wing + canvas.px(12) + metrics.horizontalAdvance(words) / 2, length * 0.55),
                 tokens.t2, TextRole::kSection);
}

void paintFloor(RigCanvas& canvas, const QPointF& feet_px, double reach, double deep) {
    QPainter& painter = canvas.painter();
    painter.setPen(QPen(canvas.tokens().line, canvas.px(1.5)));
    painter.setBrush(canvas.tokens().view2);
    painter.drawEllipse(feet_px + QPointF(0, 0.1 * deep), reach, 0.5 * deep);
    painter.setPen(QPen(canvas.tokens().edge, canvas.px(2), Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(feet_px - QPointF(0.55 * reach, 0), feet_px + QPointF(0.55 * reach, 0));
}

}  // namespace

void paintStand(RigCanvas& canvas, const RigPicture& picture, const BodyFigure& figure, const Suit& suit,
                QImage& image) {
    QPainter& painter = canvas.painter();
    const double deep = std::clamp(canvas.height_px() * 0.2, canvas.px(64), canvas.px(130));
    const double floor = canvas.height_px() - 0.78 * deep;
    const double slender = figure.height_m() / (2 * figure.half_width_m());
    const double high =
        std::max(40.0, std::min(floor - canvas.px(8), (canvas.width_px() - canvas.px(48)) * slender));
    const double scale = high / figure.height_m();
    const QPointF feet(canvas.width_px() / 2, floor + 0.02 * scale);  // below the soles is a margin
    paintFloor(canvas, feet, std::min(0.46 * canvas.width_px(), 1.05 * high / slender), deep);

    const double ratio = painter.device()->devicePixelRatioF();
    if (image.height() != static_cast<int>(high * ratio))
        image = figure.paint(static_cast<int>(high * ratio), canvas.tokens().figure);
    image.setDevicePixelRatio(ratio);
    const QSizeF size = QSizeF(image.size()) / ratio;
    painter.drawImage(QPointF(feet.x() - size.width() / 2, feet.y() - size.height()), image);
    paintForward(canvas, feet + QPointF(0, 0.16 * deep), 0.42 * deep);

    const double radius = std::clamp(high * 0.016, canvas.px(6), canvas.px(11)), around = canvas.px(10);
    QVector<QPointF> called_out;
    for (const Dot& dot : dotsOf(figure, suit, picture.boards.size(), feet, scale, radius + canvas.px(6),
                                 numberFont(canvas))) {
        paintDot(canvas, dot, picture.boards[static_cast<size_t>(dot.index)], radius);
        canvas.keepReadable(dot.number_px, canvas.px(12));
        canvas.keepReadable(dot.at_px, radius);
        canvas.keepFree(
            QRectF(dot.at_px, dot.number_px).normalized().adjusted(-around, -around, around, around));
        if (dot.index == picture.wrong_board)
            called_out << dot.at_px + (dot.number_px - dot.at_px) * 1.9;
    }
    canvas.keepFree(QRectF(feet.x() - 0.12 * high, floor - high, 0.24 * high, high));
    canvas.callOut(picture, called_out);
}

}  // namespace noctule::ui
