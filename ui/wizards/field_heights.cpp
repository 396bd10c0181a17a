// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/field_heights.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/style/paint.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/wizards/field_words.h"

namespace noctule::ui {
namespace {

constexpr double kScaleEnd_percent = 20;
constexpr int kHeightsHead = 48, kHeightsFoot = 56, kRoom = 190;

}  // namespace

FieldHeights::FieldHeights(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&Theme::get(), &Theme::changed, this, [this] {
        updateGeometry();
        update();
    });
    show({}, false, std::nullopt);
}

void FieldHeights::show(const SpotField& spot, bool is_at_floor, std::optional<double> now_percent) {
    spot_ = spot;
    is_at_floor_ = is_at_floor;
    now_percent_ = now_percent;
    setAccessibleName(
        tr("At the height of the chest: %1. Near the floor: %2.").arg(wordsOf(false), wordsOf(true)));
    update();
}

QSize FieldHeights::sizeHint() const {
    // More where there is room; the page scrolls where there is less.
    return QSize(Theme::get().px(720), Theme::get().px(230));
}

QSize FieldHeights::minimumSizeHint() const {
    return QSize(Theme::get().px(320), Theme::get().px(230));
}

double FieldHeights::Scale::at(double percent) const {
    const double share =
        std::clamp(percent, -kScaleEnd_percent, kScaleEnd_percent) / (2 * kScaleEnd_percent) + 0.5;
    return left + share * (right - left);
}

QString FieldHeights::wordsOf(bool of_floor) const {
    if (!of_floor)
        return spot_.moments == 0 ? tr("not looked at yet")
               : spot_.isEven()   ? tr("even within %1").arg(percentText(spot_.uneven_percent / 100, 1))
                                  : tr("bent by %1").arg(percentText(spot_.uneven_percent / 100, 1));
    if (!spot_.floor_percent)
        return tr("not looked at yet");
    return spot_.isBentAtFloor() ? tr("%1: bent").arg(strongerText(*spot_.floor_percent))
                                 : tr("%1: even").arg(strongerText(*spot_.floor_percent));
}

double FieldHeights::heightOf(bool of_floor) const {
    const Theme& theme = Theme::get();
    const double top = theme.px(kHeightsHead), bottom = height() - theme.px(kHeightsFoot);
    return of_floor ? bottom - theme.px(22) : top + 0.3 * (bottom - top);
}

/// Somebody who holds the bag, from the side, and the floor.
void FieldHeights::paintRoom(QPainter& painter, const QRectF& area) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const double floor = area.bottom(), middle = area.left() + 0.3 * area.width();
    const double shoulder = heightOf(false) - theme.px(14), hip = floor - 0.45 * (floor - shoulder);
    painter.setPen(QPen(spot_.isBentAtFloor() ? tokens.warn : tokens.edge, theme.px(2)));
    painter.drawLine(QPointF(area.left(), floor), QPointF(width() - theme.px(16), floor));
    painter.setPen(QPen(tokens.edge, theme.px(3), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(QPointF(middle, shoulder - theme.px(20)), theme.px(13), theme.px(15));
    painter.drawPolyline(QPolygonF({{middle, shoulder}, {middle, hip}, {middle - theme.px(9), floor}}));
    painter.drawLine(QPointF(middle, hip), QPointF(middle + theme.px(9), floor));
    const double hands = area.left() + 0.62 * area.width();
    painter.drawLine(QPointF(middle, shoulder + theme.px(4)), QPointF(hands, heightOf(false)));
    for (const bool of_floor : {false, true}) {
        const bool is_now = of_floor == is_at_floor_;
        const double y = heightOf(of_floor);
        painter.setPen(
            QPen(is_now ? tokens.acc : tokens.edge, theme.px(2), is_now ? Qt::SolidLine : Qt::DashLine));
        painter.setBrush(is_now ? QBrush(tokens.sel) : QBrush(tokens.panel));
        painter.drawRoundedRect(QRectF(hands, y - theme.px(14), theme.px(38), theme.px(30)), theme.px(10),
                                theme.px(12));
    }
}

void FieldHeights::paintScale(QPainter& painter, const Scale& scale, double top, double bottom) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const double limit = SpotField::kMostUneven_percent;
    painter.fillRect(QRectF(scale.at(-limit), top, scale.at(limit) - scale.at(-limit), bottom - top),
                     tokens.okbg);
    painter.setFont(theme.font(TextRole::kCaption));
    const QFontMetrics metrics = painter.fontMetrics();
    const double beside = scale.at(10) - scale.at(0),
                 needed = metrics.horizontalAdvance(tr("as usual here")) / 2.0 +
                          metrics.horizontalAdvance("−10 %") / 2.0 + theme.px(4);
    for (const double tick : {-20.0, -10.0, 0.0, 10.0, 20.0}) {
        painter.setPen(QPen(tick == 0 ? tokens.edge : tokens.line, theme.px(1)));
        painter.drawLine(QPointF(scale.at(tick), top), QPointF(scale.at(tick), bottom));
        if (std::abs(tick) == 10 && beside < needed)
            continue;
        painter.setPen(tokens.t3);
        const QString words = tick == 0
                                  ? tr("as usual here")
                                  : QStringLiteral("%1%2").arg(tick > 0 ? "+" : "", percentText(tick / 100));
        painter.drawText(
            QRectF(scale.at(tick) - theme.px(60), top - theme.px(20), theme.px(120), theme.px(18)),
            Qt::AlignCenter, words);
    }
}

void FieldHeights::paintMark(QPainter& painter, const Scale& scale, double y, bool of_floor) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    const bool known = of_floor ? spot_.floor_percent.has_value() : spot_.moments > 0;
    const bool bent = known && (of_floor ? spot_.isBentAtFloor() : !spot_.isEven());
    const QColor color = !known ? tokens.t3 : bent ? tokens.warn : tokens.ok;
    const double middle = of_floor ? spot_.floor_percent.value_or(0) : 0;
    if (known) {
        const double spread = of_floor ? 0 : spot_.uneven_percent;
        painter.setPen(QPen(color, theme.px(6), Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(QPointF(scale.at(std::min(0.0, middle) - spread), y),
                         QPointF(scale.at(std::max(0.0, middle) + spread), y));
    }
    if (of_floor == is_at_floor_ && now_percent_) {
        painter.setPen(QPen(tokens.t1, theme.px(2)));
        painter.setBrush(tokens.acc);
        painter.drawEllipse(QPointF(scale.at(*now_percent_), y), theme.px(6), theme.px(6));
    }
    painter.setFont(theme.font(TextRole::kSecondary, true));
    painter.setPen(tokens.t1);
    const QRectF row(scale.left, y - theme.px(36), scale.right - scale.left, theme.px(22));
    const QString name = of_floor ? tr("Near the floor") : tr("At the height of the chest");
    const QFontMetrics metrics = painter.fontMetrics();
    // Where there is no room for both, the drawing beside says which height it is.
    if (metrics.horizontalAdvance(name) + metrics.horizontalAdvance(wordsOf(of_floor)) + theme.px(32) <=
        row.width())
        painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, name);
    painter.setPen(color);
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, wordsOf(of_floor));
    if (known) {
        const double words = painter.fontMetrics().horizontalAdvance(wordsOf(of_floor));
        paintIcon(painter, QRectF(row.right() - words - theme.px(24), row.top(), theme.px(20), row.height()),
                  bent ? "warn" : "check", theme.px(14), color);
    }
}

void FieldHeights::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintBox(painter, rect(), theme.px(8), theme.tokens().panel);
    const double top = theme.px(kHeightsHead), bottom = height() - theme.px(kHeightsFoot);
    const double room = std::min(theme.px(kRoom), width() / 4);
    paintRoom(painter, QRectF(theme.px(16), top, room, bottom - top));
    const Scale scale{theme.px(16) + room + theme.px(40), static_cast<double>(width() - theme.px(48))};
    paintScale(painter, scale, top, bottom);
    paintMark(painter, scale, heightOf(false), false);
    paintMark(painter, scale, heightOf(true), true);
    painter.setFont(theme.font(TextRole::kCaption));
    painter.setPen(theme.tokens().t3);
    const QRect last(theme.px(16), height() - theme.px(40), width() - theme.px(32), theme.px(34));
    painter.drawText(last, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap,
                     tr("How strong the Earth’s field is, compared with what is usual where you stand. Steel "
                        "bends it: beyond 5 % a heading is wrong by several degrees."));
}

}  // namespace noctule::ui
