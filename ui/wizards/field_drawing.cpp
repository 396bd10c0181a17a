// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/field_drawing.h"

#include <QLinearGradient>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/style/paint.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/wizards/field_words.h"

namespace noctule::ui {
namespace {

constexpr double kLookUp_rad = radians(-14);  ///< from a little below, so that the lower pole is seen
constexpr double kManyReadings = 8;
constexpr int kHead = 34, kFieldFoot = 62, kEdgePoints = 8, kNarrow = 720;

/// In the drawing's axes: x right, y up, z towards the eye.
Vector3d asSeen(const Vector3d& direction, bool is_behind) {
    const double x = is_behind ? -direction.x() : direction.x(),
                 z = is_behind ? -direction.z() : direction.z();
    const double c = std::cos(kLookUp_rad), s = std::sin(kLookUp_rad);
    return {x, c * direction.y() - s * z, s * direction.y() + c * z};
}

Vector3d onSphere(double height, double azimuth_rad) {
    const double across = std::sqrt(std::max(0.0, 1 - height * height));
    return {across * std::sin(azimuth_rad), height, across * std::cos(azimuth_rad)};
}

std::vector<Vector3d> outlineOf(const FieldCell& cell) {
    std::vector<Vector3d> outline;
    const auto edge = [&outline](double y0, double a0, double y1, double a1) {
        for (int i = 0; i < kEdgePoints; ++i) {
            const double t = static_cast<double>(i) / kEdgePoints;
            outline.push_back(onSphere(y0 + t * (y1 - y0), a0 + t * (a1 - a0)));
        }
    };
    edge(cell.top, cell.from_rad, cell.top, cell.to_rad);
    edge(cell.top, cell.to_rad, cell.bottom, cell.to_rad);
    edge(cell.bottom, cell.to_rad, cell.bottom, cell.from_rad);
    edge(cell.bottom, cell.from_rad, cell.top, cell.from_rad);
    return outline;
}

QColor colorOfCount(int count) {
    const Tokens& tokens = Theme::get().tokens();
    const QColor few = mixed(tokens.warn, tokens.view, 0.35);
    return mixed(few, tokens.ok, std::min(1.0, (count - 1) / (kManyReadings - 1)));
}

}  // namespace

FieldDrawing::FieldDrawing(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&Theme::get(), &Theme::changed, this, [this] {
        updateGeometry();
        update();
    });
    setToolTip(
        tr("Each field is a direction the Earth’s field was seen from, by the sensor that has seen it "
           "least."));
    show(FieldSphere{}, std::nullopt);
}

void FieldDrawing::show(const FieldSphere& sphere, std::optional<FieldSide> empty) {
    sphere_ = sphere;
    empty_ = empty;
    const QString seen = tr("%1 of 100 directions seen").arg(sphere.seen());
    setAccessibleName(empty ? tr("%1, %2 still empty").arg(seen, sideName(*empty)) : seen);
    update();
}

QSize FieldDrawing::sizeHint() const {
    return QSize(Theme::get().px(720), Theme::get().px(230));
}

QSize FieldDrawing::minimumSizeHint() const {
    return QSize(Theme::get().px(320), Theme::get().px(140));
}

void FieldDrawing::paintCell(QPainter& painter, const Globe& globe, int cell) const {
    const FieldCell& at = FieldSphere::cells()[static_cast<size_t>(cell)];
    QPolygonF shape;
    bool in_front = false;
    for (const Vector3d& point : outlineOf(at)) {
        Vector3d seen = asSeen(point, globe.is_behind);
        in_front |= seen.z() > 0.02;
        // What lies behind the limb ends at it.
        if (const double across = std::hypot(seen.x(), seen.y()); seen.z() < 0 && across > 0)
            seen /= across;
        shape << globe.middle + globe.radius * QPointF(seen.x(), -seen.y());
    }
    if (!in_front)
        return;
    const Theme& theme = Theme::get();
    const int count = sphere_.count(cell);
    if (count > 0) {
        painter.setPen(QPen(theme.tokens().view, theme.px(1.5)));
        painter.setBrush(colorOfCount(count));
    } else {
        painter.setPen(QPen(theme.tokens().edge, theme.px(1), Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
    }
    painter.drawPolygon(shape);
}

void FieldDrawing::paintArrow(QPainter& painter, const Globe& globe) const {
    const Theme& theme = Theme::get();
    const QColor color = theme.tokens().acc;
    const double radius = globe.radius + theme.px(14);
    const QRectF around(globe.middle.x() - radius, globe.middle.y() - radius, 2 * radius, 2 * radius);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(color, theme.px(3.5), Qt::SolidLine, Qt::RoundCap));
    painter.drawArc(around, 25 * 16, -70 * 16);
    const double end_rad = radians(-47);
    const QPointF tip = globe.middle + radius * QPointF(std::cos(end_rad), -std::sin(end_rad));
    painter.save();
    painter.translate(tip);
    painter.rotate(137);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    const double size = theme.px(7);
    painter.drawPolygon(QPolygonF({{1.3 * size, 0}, {-size, size}, {-size, -size}}));
    painter.restore();
}

void FieldDrawing::paintGlobe(QPainter& painter, const Globe& globe) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    painter.setPen(QPen(tokens.edge, theme.px(1)));
    painter.setBrush(tokens.view);
    painter.drawEllipse(globe.middle, globe.radius, globe.radius);
    for (int cell = 0; cell < FieldSphere::kCells; ++cell)
        paintCell(painter, globe, cell);
    if (!empty_)
        return;
    paintArrow(painter, globe);
    const double below = globe.middle.y() + globe.radius;
    painter.setPen(QPen(tokens.warn, theme.px(1.5)));
    if (*empty_ == FieldSide::kLower)
        painter.drawLine(QPointF(globe.middle.x(), below - theme.px(26)),
                         QPointF(globe.middle.x(), below + theme.px(12)));
    painter.setFont(theme.font(TextRole::kSecondary, true));
    const QRectF words(globe.middle.x() - width() / 4.0, below + theme.px(12), width() / 2.0, theme.px(20));
    painter.drawText(words, Qt::AlignCenter, tr("still empty: %1").arg(sideName(*empty_)));
}

void FieldDrawing::paintScale(QPainter& painter, const QRect& row) const {
    const Theme& theme = Theme::get();
    painter.setFont(theme.font(TextRole::kCaption));
    painter.setPen(theme.tokens().t3);
    const QString few = tr("readings few"), many = tr("many");
    const QFontMetrics metrics = painter.fontMetrics();
    const int bar = theme.px(68), gap = theme.px(8);
    int right = row.right();
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, many);
    right -= metrics.horizontalAdvance(many) + gap;
    const QRectF box(right - bar, row.center().y() - theme.px(3), bar, theme.px(7));
    QLinearGradient ramp(box.topLeft(), box.topRight());
    ramp.setColorAt(0, theme.tokens().ctlh);
    ramp.setColorAt(0.35, colorOfCount(1));
    ramp.setColorAt(1, colorOfCount(static_cast<int>(kManyReadings)));
    painter.setPen(Qt::NoPen);
    painter.setBrush(ramp);
    painter.drawRoundedRect(box, theme.px(2), theme.px(2));
    painter.setPen(theme.tokens().t3);
    painter.drawText(QRectF(row.left(), row.top(), box.left() - gap - row.left(), row.height()),
                     Qt::AlignRight | Qt::AlignVCenter, few);
}

void FieldDrawing::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintBox(painter, rect(), theme.px(8), theme.tokens().panel);
    const int margin = theme.px(16), head = theme.px(kHead), foot = theme.px(kFieldFoot);
    const QRect row(margin, theme.px(8), width() - 2 * margin, head - theme.px(8));
    const double radius =
        std::max(10.0, std::min(width() / 4.0 - theme.px(34), (height() - head - foot) / 2.0));
    const double middle = head + (height() - head - foot) / 2.0;
    for (const bool is_behind : {false, true}) {
        const QPointF at(width() * (is_behind ? 0.75 : 0.25), middle);
        paintGlobe(painter, {at, radius, is_behind});
        painter.setFont(theme.font(TextRole::kSecondary, true));
        painter.setPen(theme.tokens().t1);
        painter.drawText(row.translated(is_behind ? width() / 2 - margin / 2 : 0, 0),
                         Qt::AlignLeft | Qt::AlignVCenter,
                         is_behind ? tr("Seen from behind") : tr("Seen from the front"));
    }
    const QRect last(margin, height() - theme.px(24), width() - 2 * margin, theme.px(18));
    // Where both heads leave no room for it, the scale stands below.
    const bool is_narrow = width() < theme.px(kNarrow);
    paintScale(painter, is_narrow ? last : row);
    if (is_narrow)
        return;
    painter.setFont(theme.font(TextRole::kCaption));
    painter.setPen(theme.tokens().t3);
    painter.drawText(last, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(toolTip(), Qt::ElideRight, last.width()));
}

}  // namespace noctule::ui
