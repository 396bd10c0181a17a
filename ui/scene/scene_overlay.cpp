// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/scene_overlay.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>

#include "ui/style/paint.h"
#include "ui/style/performer_disc.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"

namespace noctule::ui {

namespace {

double px(double at_100_percent) {
    return Theme::get().px(at_100_percent);
}

constexpr double kNarrow = 400;  // pixels at 100 percent

QFont captionFont(bool medium = false) {
    return Theme::get().font(TextRole::kCaption, medium);
}

void paintAxes(QPainter& painter, const QRectF& area, const Matrix3d& camera_axes) {
    const Tokens& tokens = Theme::get().tokens();
    struct Axis {
        QString letter;
        QColor color;
        Vector3d direction;  ///< in camera axes
    };
    const Matrix3d R_camera_world = camera_axes.transpose();
    std::array<Axis, 3> axes{{{QStringLiteral("X"), tokens.x, R_camera_world.col(0)},
                              {QStringLiteral("Y"), tokens.y, R_camera_world.col(1)},
                              {QStringLiteral("Z"), tokens.z, R_camera_world.col(2)}}};
    std::sort(axes.begin(), axes.end(),
              [](const Axis& a, const Axis& b) { return a.direction.z() < b.direction.z(); });
    const QPointF origin = area.bottomLeft() + QPointF(px(40), -px(36));
    painter.setFont(captionFont(true));
    for (const Axis& axis : axes) {
        const QPointF along(axis.direction.x(), -axis.direction.y());
        painter.setPen(QPen(axis.color, px(1.5), Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(origin, origin + px(20) * along);
        const QPointF letter = origin + px(28) * along;
        painter.drawText(QRectF(letter - QPointF(px(8), px(8)), QSizeF(px(16), px(16))), Qt::AlignCenter,
                         axis.letter);
    }
}

void paintLegends(QPainter& painter, const QRectF& area, const std::vector<SceneLegend>& legends,
                  bool beside_axes) {
    const Tokens& tokens = Theme::get().tokens();
    painter.setFont(Theme::get().font(TextRole::kSecondary));
    const double row = px(20), left = area.left() + px(beside_axes ? 84 : 16);
    double y = area.bottom() - px(14) - row * static_cast<double>(legends.size());
    for (const SceneLegend& legend : legends) {
        const QRectF swatch(left, y + (row - px(10)) / 2, px(14), px(10));
        painter.setPen(QPen(legend.outline ? tokens.ref : QColor(Qt::transparent), px(1.3)));
        painter.setBrush(legend.outline ? QColor(Qt::transparent) : tokens.edge);
        painter.drawRoundedRect(swatch, px(3), px(3));
        painter.setPen(tokens.t2);
        painter.drawText(QRectF(left + px(22), y, area.width(), row), Qt::AlignVCenter | Qt::AlignLeft,
                         legend.text);
        y += row;
    }
}

QString rayWords() {
    return QCoreApplication::translate("SceneOverlay", "Ray confidence, source to board");
}

QRectF rayLegendBox(const QRectF& area) {
    const double width = std::max(px(180), QFontMetricsF(captionFont()).horizontalAdvance(rayWords()));
    return {area.bottomRight() - QPointF(width + px(16), px(58)), QSizeF(width, px(44))};
}

void paintRayLegend(QPainter& painter, const QRectF& area) {
    const Theme& theme = Theme::get();
    const QString words = rayWords();
    painter.setFont(captionFont());
    const double width = rayLegendBox(area).width(), bar = px(6);
    const QPointF corner = rayLegendBox(area).topLeft();
    painter.setPen(theme.tokens().t2);
    painter.drawText(QRectF(corner, QSizeF(width, px(16))), Qt::AlignLeft | Qt::AlignVCenter, words);
    QLinearGradient ramp(corner, corner + QPointF(width, 0));
    constexpr int kStops = 16;
    for (int i = 0; i <= kStops; ++i)
        ramp.setColorAt(i / double{kStops}, theme.confidence(i / double{kStops}));
    painter.setPen(Qt::NoPen);
    painter.setBrush(ramp);
    painter.drawRoundedRect(QRectF(corner + QPointF(0, px(20)), QSizeF(width, bar)), bar / 2, bar / 2);
    painter.setPen(theme.tokens().t2);
    const QRectF numbers(corner + QPointF(0, px(28)), QSizeF(width, px(16)));
    painter.drawText(numbers, Qt::AlignLeft | Qt::AlignVCenter, numberText(0, 0));
    painter.drawText(numbers, Qt::AlignHCenter | Qt::AlignVCenter, numberText(0.5, 1));
    painter.drawText(numbers, Qt::AlignRight | Qt::AlignVCenter, numberText(1, 0));
}

/// How far a body reaches to both sides of `at` where a box between these heights would stand on it.
std::pair<double, double> reachOf(const std::vector<QPointF>& bodies, const QPointF& at, double top,
                                  double bottom) {
    constexpr double kFlesh = 0.06;  // around bones, of the larger extent of the body
    QPolygonF all(QVector<QPointF>(bodies.begin(), bodies.end()));
    const QSizeF size = all.boundingRect().size();
    const double flesh = kFlesh * std::max(size.width(), size.height());
    std::pair<double, double> reach{at.x(), at.x()};
    for (const QPointF& p : bodies)
        if (p.y() > top - flesh && p.y() < bottom + flesh)
            reach = {std::min(reach.first, p.x() - flesh), std::max(reach.second, p.x() + flesh)};
    return reach;
}

/// In a view that is hardly wider than its body a box would stand on it: the words stand below the feet.
void paintCaption(QPainter& painter, const QRectF& area, const OverlayContent& content, size_t legends) {
    const Theme& theme = Theme::get();
    const double row = px(18), left = area.left() + px(16), width = area.width() - px(24);
    double y = area.bottom() - px(18) - px(20) * static_cast<double>(legends) - row;
    const auto line = [&](const QFont& font, const QColor& color, const QString& words) {
        painter.setFont(font);
        painter.setPen(color);
        painter.drawText(QRectF(left, y, width, row), Qt::AlignLeft | Qt::AlignVCenter,
                         QFontMetricsF(font).elidedText(words, Qt::ElideRight, width));
        y -= row;
    };
    // The number first: what is cut off is the names.
    if (content.distance)
        line(theme.font(TextRole::kCaption), theme.tokens().t2,
             QCoreApplication::translate("SceneOverlay", "%1, %2", "a distance and between which joints")
                 .arg(content.distance->text, content.distance->pair));
    if (!content.callout)
        return;
    if (!content.callout->detail.isEmpty())
        line(theme.font(TextRole::kCaption), theme.tokens().t2, content.callout->detail);
    line(theme.font(TextRole::kSecondary, true), theme.tokens().t1, content.callout->title);
}

void paintCallout(QPainter& painter, const QRectF& area, const SceneCallout& callout) {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const QFont title_font = theme.font(TextRole::kSecondary, true),
                detail_font = theme.font(TextRole::kCaption);
    const QRectF box = SceneOverlay::calloutBox(area, callout);
    const bool right = box.center().x() > callout.at.x();
    const QPointF knee(right ? box.left() : box.right(), box.center().y());
    const QPointF toward = knee - callout.at;
    const double length = std::max(1.0, std::hypot(toward.x(), toward.y()));
    painter.setPen(QPen(tokens.acc, px(1.2)));
    painter.drawLine(callout.at + toward * std::min(1.0, px(callout.clear_px) / length), knee);
    paintBox(painter, box, px(4), tokens.raised, tokens.acc);
    const QRectF inner = box.adjusted(px(10), px(6), -px(10), -px(6));
    painter.setFont(title_font);
    painter.setPen(tokens.t1);
    painter.drawText(inner, Qt::AlignLeft | Qt::AlignTop, callout.title);
    painter.setFont(detail_font);
    painter.setPen(tokens.t2);
    painter.drawText(inner, Qt::AlignLeft | Qt::AlignBottom, callout.detail);
}

bool hasRoom(const QRectF& area) {
    return area.height() >= px(180) && area.width() >= px(240);
}

bool isNarrowArea(const QRectF& area) {
    return area.width() < px(kNarrow);
}

bool hasRayLegend(const QRectF& area, const OverlayContent& content) {
    return content.has_rays && hasRoom(area) && area.width() >= px(520);
}

QRectF around(const QPointF& at, double radius) {
    return {at - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius)};
}

/// What a distance must not stand on.
std::vector<QRectF> occupiedAreas(const QRectF& area, const OverlayContent& content) {
    std::vector<QRectF> boxes{around(content.distance->from, px(12))};
    for (const SceneTag& tag : content.tags)
        boxes.push_back(around(tag.at, px(9)));
    if (content.callout)
        boxes.push_back(SceneOverlay::calloutBox(area, *content.callout));
    const double legends = px(14) + px(20) * static_cast<double>(content.legends.size());
    if (!content.legends.empty())
        boxes.emplace_back(area.left(), area.bottom() - legends, px(220), legends);
    if (content.has_axes)
        boxes.push_back(around(area.bottomLeft() + QPointF(px(40), -px(36)), px(36)));
    if (hasRayLegend(area, content))
        boxes.push_back(rayLegendBox(area));
    return boxes;
}

void paintDistance(QPainter& painter, const SceneDistance& distance, const QRectF& box) {
    const Theme& theme = Theme::get();
    const double radius = px(12);
    const bool below = box.top() > distance.from.y();
    painter.setPen(QPen(theme.tokens().acc, px(1.2)));
    painter.drawLine(distance.from + QPointF(0, below ? radius : -radius),
                     QPointF(box.center().x(), below ? box.top() : box.bottom()));
    paintBox(painter, box, px(4), theme.tokens().raised, theme.tokens().acc);
    const QRectF inner = box.adjusted(px(10), px(6), -px(10), -px(6));
    painter.setFont(theme.font(TextRole::kSecondary, true));
    painter.setPen(theme.tokens().t1);
    painter.drawText(inner, Qt::AlignHCenter | Qt::AlignTop, distance.text);
    painter.setFont(captionFont());
    painter.setPen(theme.tokens().t2);
    painter.drawText(inner, Qt::AlignHCenter | Qt::AlignBottom, distance.pair);
}

bool sameContent(const OverlayContent& a, const OverlayContent& b) {
    const auto sameLegend = [](const SceneLegend& x, const SceneLegend& y) {
        return x.text == y.text && x.outline == y.outline;
    };
    const auto sameCallout = [](const SceneCallout& x, const SceneCallout& y) {
        return x.at == y.at && x.title == y.title && x.detail == y.detail && x.clear_px == y.clear_px &&
               x.bodies == y.bodies;
    };
    const auto sameTag = [](const SceneTag& x, const SceneTag& y) {
        return x.performer == y.performer && x.at == y.at;
    };
    const auto sameDistance = [](const SceneDistance& x, const SceneDistance& y) {
        return x.from == y.from && x.floor == y.floor && x.text == y.text && x.pair == y.pair;
    };
    return a.distance.has_value() == b.distance.has_value() &&
           (!a.distance || sameDistance(*a.distance, *b.distance)) &&
           std::equal(a.tags.begin(), a.tags.end(), b.tags.begin(), b.tags.end(), sameTag) &&
           a.camera_axes == b.camera_axes && a.has_axes == b.has_axes && a.has_rays == b.has_rays &&
           std::equal(a.legends.begin(), a.legends.end(), b.legends.begin(), b.legends.end(), sameLegend) &&
           a.callout.has_value() == b.callout.has_value() &&
           (!a.callout || sameCallout(*a.callout, *b.callout));
}

}  // namespace

bool SceneOverlay::isNarrow(const QWidget& view) {
    return view.width() < px(kNarrow);
}

SceneOverlay::SceneOverlay(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    connect(&Theme::get(), &Theme::changed, this, QOverload<>::of(&QWidget::update));
}

void SceneOverlay::setContent(OverlayContent content) {
    const bool same = sameContent(content, content_);
    content_ = std::move(content);
    if (!same)
        update();
}

std::optional<QRectF> SceneOverlay::distanceBox(const QRectF& area, const OverlayContent& content) {
    if (!content.distance || !hasRoom(area) || isNarrowArea(area))
        return std::nullopt;
    const SceneDistance& distance = *content.distance;
    const QFontMetricsF text(Theme::get().font(TextRole::kSecondary, true)), pair(captionFont());
    QRectF box(QPointF(0, 0),
               QSizeF(std::max(text.horizontalAdvance(distance.text), pair.horizontalAdvance(distance.pair)) +
                          px(20),
                      text.height() + pair.height() + px(14)));
    box.moveCenter(distance.floor);
    const std::vector<QRectF> boxes = occupiedAreas(area, content);
    const QRectF inside = area.adjusted(px(8), px(52), -px(8), -px(8));
    for (const int steps : {0, -1, 1, -2, 2, -3, 3, -4, 4, -5, 5, -6, 6}) {
        const QRectF moved = box.translated(0, steps * box.height() / 2);
        if (inside.contains(moved) &&
            std::ranges::none_of(boxes, [&](const QRectF& other) { return other.intersects(moved); }))
            return moved;
    }
    return std::nullopt;
}

QRectF SceneOverlay::calloutBox(const QRectF& area, const SceneCallout& callout) {
    const Theme& theme = Theme::get();
    const QFontMetricsF title(theme.font(TextRole::kSecondary, true)), detail(theme.font(TextRole::kCaption));
    const double line = title.height() + (callout.detail.isEmpty() ? 0 : detail.height() + px(2));
    const double width =
        std::max(title.horizontalAdvance(callout.title), detail.horizontalAdvance(callout.detail));
    QRectF box(0, 0, width + px(20), line + px(12));
    const double away = px(callout.clear_px + 50), edge = px(8), highest = area.top() + px(52);
    box.moveTop(std::clamp(callout.at.y() - px(24) - box.height() / 2, highest,
                           std::max(highest, area.bottom() - box.height() - edge)));
    const auto [from, to] = reachOf(callout.bodies, callout.at, box.top(), box.bottom());
    const double right = std::max(callout.at.x() + away, to);
    const double left = std::min(callout.at.x() - away, from) - box.width();
    const double rightmost = area.right() - box.width() - edge, leftmost = area.left() + edge;
    // The right side first; without room on either, the side that has more of it.
    const bool goes_right = right < rightmost || (left <= leftmost && rightmost - right > left - leftmost);
    box.moveLeft(std::clamp(goes_right ? right : left, leftmost, std::max(leftmost, rightmost)));
    return box;
}

void SceneOverlay::paint(QPainter& painter, const QRectF& area, const OverlayContent& content) {
    painter.setRenderHint(QPainter::Antialiasing);
    const bool has_room = hasRoom(area), narrow = isNarrowArea(area);
    const bool has_axes = content.has_axes && has_room && !narrow;
    if (has_axes)
        paintAxes(painter, area, content.camera_axes);
    paintLegends(painter, area, content.legends, has_axes);
    if (hasRayLegend(area, content))
        paintRayLegend(painter, area);
    if (content.distance && has_room) {
        painter.setPen(QPen(Theme::get().tokens().acc, px(1.2)));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(content.distance->from, px(12), px(12));
    }
    if (const auto box = distanceBox(area, content))
        paintDistance(painter, *content.distance, *box);
    for (const SceneTag& tag : content.tags)
        paintPerformerDisc(painter, QRectF(tag.at - QPointF(px(9), px(9)), QSizeF(px(18), px(18))),
                           tag.performer);
    if (narrow)
        paintCaption(painter, area, content, content.legends.size());
    else if (content.callout)
        paintCallout(painter, area, *content.callout);
}

void SceneOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paint(painter, rect(), content_);
}

}  // namespace noctule::ui
