// SPDX-License-Identifier: Apache-2.0
#include "ui/wizards/room_drawing.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/math/linear_solvers.h"
#include "ui/style/lengths.h"
#include "ui/style/paint.h"
#include "ui/style/performer_disc.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"

namespace noctule::ui {
namespace {

using room_survey::RoomSurvey;
using room_survey::SurveyedAnchor;

/// How much larger than it is uncertainty is drawn: the largest of these that keeps it below `kSeen_m`.
constexpr double kLarger[] = {50, 20, 10, 5, 2, 1};
constexpr double kSeen_m = 0.8;
constexpr double kAround_m = 0.5, kLeast_m = 2, kPerson_m = 1.75;
constexpr double kNearlyGood_m = 1.5 * room_survey::kGoodAnchor_m;
constexpr double kFaded = 0.4;  ///< opacity of an anchor that is left out
constexpr int kPlanHead = 36, kPlanFoot = 32, kAnchor = 20;
constexpr int kGrid_ft = 3;  ///< a line each, else each metre

}  // namespace

AnchorState stateOf(const SurveyedAnchor& anchor) {
    if (anchor.left_out)
        return {Tone::kNeutral, RoomDrawing::tr("left out")};
    if (anchor.moved)
        return {Tone::kError, RoomDrawing::tr("was moved")};
    if (!anchor.placed)
        return {Tone::kError, RoomDrawing::tr("not placed")};
    if (anchor.mirrored)
        return {Tone::kError, RoomDrawing::tr("two places fit")};
    if (anchor.sigma_m > room_survey::kGoodAnchor_m)
        return {Tone::kWarn, RoomDrawing::tr("weak")};
    return {Tone::kOk, RoomDrawing::tr("good")};
}

AnchorState stateSoFar(const SurveyedAnchor& anchor) {
    AnchorState state = stateOf(anchor);
    if (state.tone == Tone::kWarn && anchor.sigma_m <= kNearlyGood_m)
        state.words = RoomDrawing::tr("nearly");
    return state;
}

RoomDrawing::RoomDrawing(From from, QWidget* parent) : QWidget(parent), from_(from) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&Theme::get(), &Theme::changed, this, [this] {
        updateGeometry();
        update();
    });
    show(nullptr);
}

void RoomDrawing::show(const RoomSurvey* survey, int performer) {
    performer_ = performer;
    survey_ = survey ? std::optional(*survey) : std::nullopt;
    double widest_m = 0;
    if (survey_)
        for (const SurveyedAnchor& anchor : survey_->anchors)
            widest_m = std::max(widest_m, anchor.isUsed() ? anchor.sigma_m : 0);
    const auto* fits =
        std::ranges::find_if(kLarger, [&](double larger) { return larger * widest_m <= kSeen_m; });
    larger_ = fits == std::end(kLarger) ? 1 : *fits;
    const QString name =
        from_ == From::kAbove ? tr("Plan of the room, from above") : tr("The room from the front");
    QStringList places;
    for (size_t i = 0; survey_ && i < survey_->anchors.size(); ++i)
        if (const SurveyedAnchor& anchor = survey_->anchors[i]; anchor.placed)
            places << (anchor.left_out ? tr("anchor %1, left out, at %2, %3, height %4")
                                       : tr("anchor %1 at %2, %3, height %4"))
                          .arg(QString::number(i + 1), lengthText(anchor.place_m.x()),
                               lengthText(anchor.place_m.z()), lengthText(anchor.place_m.y()));
    setAccessibleName(places.isEmpty() ? name : QStringLiteral("%1: %2").arg(name, places.join("; ")));
    update();
}

QSize RoomDrawing::sizeHint() const {
    return QSize(Theme::get().px(from_ == From::kAbove ? 420 : 280), Theme::get().px(380));
}

QSize RoomDrawing::minimumSizeHint() const {
    return QSize(Theme::get().px(from_ == From::kAbove ? 240 : 160), Theme::get().px(220));
}

/// Right and down of the picture: from above x and z, from the front x and -y.
QPointF RoomDrawing::flat(const Vector3d& place_m) const {
    return {place_m.x(), from_ == From::kAbove ? place_m.z() : -place_m.y()};
}

Eigen::Matrix2d RoomDrawing::flatCovariance(const Matrix3d& cov_m2) const {
    Eigen::Matrix<double, 2, 3> seen;
    if (from_ == From::kAbove)
        seen << 1, 0, 0, 0, 0, 1;
    else
        seen << 1, 0, 0, 0, -1, 0;
    return seen * cov_m2 * seen.transpose();
}

QRectF RoomDrawing::extent() const {
    double left = 0, right = 0, top = 0, bottom = 0;
    const auto add = [&](const Vector3d& place_m) {
        const QPointF p = flat(place_m);
        left = std::min(left, p.x()), right = std::max(right, p.x());
        top = std::min(top, p.y()), bottom = std::max(bottom, p.y());
    };
    for (const SurveyedAnchor& anchor : survey_->anchors)
        if (anchor.placed)
            add(anchor.place_m);
    for (const Vector3d& walked_m : survey_->walked_m)
        add({walked_m.x(), 0, walked_m.z()});
    if (from_ == From::kFront)
        top = std::min(top, -kPerson_m), bottom = 0;
    QRectF all(QPointF(left - kAround_m, top - kAround_m),
               QPointF(right + kAround_m, bottom + (from_ == From::kAbove ? kAround_m : 0)));
    if (all.width() < kLeast_m)
        all.adjust((all.width() - kLeast_m) / 2, 0, (kLeast_m - all.width()) / 2, 0);
    return all;
}

QPointF RoomDrawing::at(const Scale& scale, const QPointF& place) const {
    return scale.middle + scale.pixels_per_m * (place - scale.middle_m);
}

void RoomDrawing::paintGrid(QPainter& painter, const Scale& scale, const QRectF& field,
                            const QRectF& extent_m) const {
    const Theme& theme = Theme::get();
    painter.setFont(theme.font(TextRole::kCaption));
    const auto line = [&](const QPointF& from, const QPointF& to) {
        painter.setPen(QPen(theme.tokens().grid, theme.px(1)));
        painter.drawLine(from, to);
        painter.setPen(theme.tokens().t3);
    };
    const bool in_feet = chosenUnits() == Units::kImperial;
    const int step = in_feet ? kGrid_ft : 1;
    const double step_m = in_feet ? step * kMetresPerFoot : 1;
    for (int x = static_cast<int>(std::ceil(extent_m.left() / step_m)); x * step_m <= extent_m.right(); ++x) {
        const double here = at(scale, {x * step_m, 0}).x();
        const QString number = numberText(x * step, 0);
        const bool is_last = (x + 1) * step_m > extent_m.right();
        line({here, field.top()}, {here, field.bottom()});
        painter.drawText(QRectF(here - 40, field.bottom() + theme.px(2), 80, theme.px(16)), Qt::AlignCenter,
                         !is_last  ? number
                         : in_feet ? tr("%1 ft").arg(number)
                                   : tr("%1 m").arg(number));
    }
    for (int y = static_cast<int>(std::ceil(extent_m.top() / step_m)); y * step_m <= extent_m.bottom(); ++y) {
        const double here = at(scale, {0, y * step_m}).y();
        line({field.left(), here}, {field.right(), here});
        painter.drawText(QRectF(field.left() - theme.px(26), here - 10, theme.px(22), 20),
                         Qt::AlignRight | Qt::AlignVCenter,
                         numberText(step * (from_ == From::kAbove ? y : -y), 0));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme.tokens().edge, theme.px(1)));
    painter.drawRect(field);
}

void RoomDrawing::paintWalk(QPainter& painter, const Scale& scale) const {
    if (from_ == From::kFront)
        return;
    QPolygonF way;
    for (const Vector3d& walked_m : survey_->walked_m)
        way << at(scale, flat(walked_m));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(
        QPen(Theme::get().tokens().acc, Theme::get().px(2), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(way);
}

void RoomDrawing::paintHearing(QPainter& painter, const Scale& scale) const {
    for (const room_survey::SurveyedDistance& one : survey_->distances) {
        if (!one.measured_m)
            continue;
        QColor color = Theme::get().tokens().ok;
        color.setAlphaF(0.5);
        painter.setPen(QPen(color, Theme::get().px(1.5)));
        painter.drawLine(at(scale, flat(survey_->anchors[static_cast<size_t>(one.a)].place_m)),
                         at(scale, flat(survey_->anchors[static_cast<size_t>(one.b)].place_m)));
    }
}

void RoomDrawing::paintUncertainty(QPainter& painter, const Scale& scale, size_t index) const {
    const SurveyedAnchor& anchor = survey_->anchors[index];
    if (!anchor.isUsed())
        return;
    const Eigensystem axes = eigensystemOf(flatCovariance(anchor.cov_m2));
    const Eigen::Vector2d radii = larger_ * scale.pixels_per_m * axes.values.cwiseMax(0).cwiseSqrt();
    const QColor color = colorOf(stateOf(anchor).tone);
    QColor fill = color;
    fill.setAlphaF(0.18);
    painter.save();
    painter.translate(at(scale, flat(anchor.place_m)));
    painter.rotate(degrees(std::atan2(axes.vectors(1, 1), axes.vectors(0, 1))));
    painter.setPen(QPen(color, Theme::get().px(1.5)));
    painter.setBrush(fill);
    painter.drawEllipse(QPointF(), radii[1], radii[0]);
    painter.restore();
}

void RoomDrawing::paintAnchor(QPainter& painter, const Scale& scale, size_t index,
                              std::vector<QRectF>& taken) const {
    const SurveyedAnchor& anchor = survey_->anchors[index];
    if (!anchor.placed)
        return;
    const Theme& theme = Theme::get();
    const Tone tone = stateOf(anchor).tone;
    const QColor color = colorOf(tone);
    const QPointF middle = at(scale, flat(anchor.place_m));
    painter.setOpacity(anchor.left_out ? kFaded : 1);
    if (from_ == From::kFront) {
        painter.setPen(QPen(theme.tokens().edge, theme.px(1.5)));
        painter.drawLine(middle, at(scale, {anchor.place_m.x(), 0}));
    }
    const double side = theme.px(kAnchor);
    const QRectF box(middle.x() - side / 2, middle.y() - side / 2, side, side);
    paintBox(painter, box, theme.px(4), theme.tokens().panel, color);
    painter.setFont(theme.font(TextRole::kCaption, true));
    painter.setPen(color);
    painter.drawText(box, Qt::AlignCenter, QString::number(index + 1));
    if (anchor.left_out && from_ == From::kFront) {  // the plan says so; here its words would cover heights
        painter.setOpacity(1);
        return;
    }
    const QString words = anchor.left_out ? stateOf(anchor).words
                          : from_ == From::kAbove
                              ? QStringLiteral("±%1").arg(millimetresText(anchor.sigma_m, 0))
                              : lengthText(anchor.place_m.y());
    painter.setFont(theme.font(TextRole::kCaption));
    painter.setPen(tone == Tone::kOk ? theme.tokens().t2 : color);
    // Anchors one behind the other have their words one over the other.
    const double sigma_down_m = std::sqrt(std::max(0.0, flatCovariance(anchor.cov_m2)(1, 1)));
    const double above = std::max(side / 2, larger_ * scale.pixels_per_m * sigma_down_m);
    QRectF place(middle.x() - theme.px(30), middle.y() - above - theme.px(18), theme.px(60), theme.px(16));
    const auto leave = [&](double step) {
        while (std::ranges::any_of(taken, [&](const QRectF& other) { return other.intersects(place); }))
            place.translate(0, step);
    };
    leave(-place.height());
    if (place.top() < theme.px(kPlanHead)) {  // the title stands there
        place.moveTop(middle.y() + above + theme.px(2));
        leave(place.height());
    }
    taken.push_back(place);
    painter.drawText(place, Qt::AlignCenter | Qt::TextDontClip, words);
    painter.setOpacity(1);
}

void RoomDrawing::paintPerformer(QPainter& painter, const Scale& scale) const {
    if (!survey_->frame.of_performer)
        return;
    const Theme& theme = Theme::get();
    const QColor color = theme.tokens().figure;
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    const double m = scale.pixels_per_m;
    const QPointF stood = at(scale, {0, 0});
    if (from_ == From::kFront) {
        // Head, trunk and legs of somebody 1.75 m tall.
        painter.drawEllipse(stood - QPointF(0, 1.64 * m), 0.10 * m, 0.12 * m);
        painter.drawRoundedRect(QRectF(stood.x() - 0.2 * m, stood.y() - 1.48 * m, 0.4 * m, 0.62 * m),
                                0.12 * m, 0.12 * m);
        for (const double side : {-1.0, 1.0}) {
            painter.drawRoundedRect(
                QRectF(stood.x() + side * 0.1 * m - 0.075 * m, stood.y() - 0.9 * m, 0.15 * m, 0.9 * m),
                0.06 * m, 0.06 * m);
            painter.drawRoundedRect(
                QRectF(stood.x() + side * 0.27 * m - 0.05 * m, stood.y() - 1.44 * m, 0.1 * m, 0.68 * m),
                0.05 * m, 0.05 * m);
        }
        return;
    }
    painter.drawEllipse(stood, std::max(0.24 * m, 12.0), std::max(0.14 * m, 7.0));
    const double radius = theme.px(9);
    painter.setBrush(performerColor(performer_));
    painter.drawPolygon(QPolygonF({stood + QPointF(-0.5 * radius, radius),
                                   stood + QPointF(0.5 * radius, radius), stood + QPointF(0, 2.2 * radius)}));
    paintPerformerDisc(painter, QRectF(stood.x() - radius, stood.y() - radius, 2 * radius, 2 * radius),
                       performer_);
}

QString RoomDrawing::legend() const {
    if (from_ == From::kFront)
        return tr("Heights above the floor.");
    return larger_ > 1
               ? tr("Ellipse: uncertainty, drawn %1 times larger. Line: walked.").arg(numberText(larger_, 0))
               : tr("Ellipse: uncertainty. Line: walked.");
}

void RoomDrawing::paintEvent(QPaintEvent*) {
    const Theme& theme = Theme::get();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintBox(painter, rect(), theme.px(8), theme.tokens().panel);
    const int margin = theme.px(16);
    const QRectF head(margin, theme.px(8), width() - 2 * margin, theme.px(kPlanHead - 12));
    painter.setFont(theme.font(TextRole::kSecondary, true));
    painter.setPen(theme.tokens().t1);
    painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter,
                     from_ == From::kAbove ? tr("Plan, from above") : tr("From the front"));
    constexpr int kWrapped = Qt::AlignLeft | Qt::AlignBottom | Qt::TextWordWrap;
    const QFont caption = theme.font(TextRole::kCaption);
    const QRect row(margin, 0, width() - 2 * margin, height() - theme.px(10));
    const int legend_height = QFontMetrics(caption, this).boundingRect(row, kWrapped, legend()).height();
    const QRectF field(margin + theme.px(22), theme.px(kPlanHead), width() - 2 * margin - theme.px(22),
                       std::max(1, height() - theme.px(kPlanHead + kPlanFoot) - legend_height));
    if (!survey_) {
        painter.setPen(QPen(theme.tokens().edge, theme.px(1), Qt::DashLine));
        painter.drawRect(field);
        return;
    }
    const QRectF extent_m = extent();
    Scale scale;
    scale.pixels_per_m = std::min(field.width() / extent_m.width(), field.height() / extent_m.height());
    scale.middle_m = extent_m.center();
    scale.middle = field.center();
    const QSizeF size = extent_m.size() * scale.pixels_per_m;
    const QRectF drawn(scale.middle - QPointF(size.width() / 2, size.height() / 2), size);
    paintGrid(painter, scale, drawn, extent_m);
    paintHearing(painter, scale);
    paintWalk(painter, scale);
    paintPerformer(painter, scale);
    painter.setClipRect(field);
    for (size_t i = 0; i < survey_->anchors.size(); ++i)
        paintUncertainty(painter, scale, i);
    painter.setClipping(false);
    std::vector<QRectF> taken;
    for (size_t i = 0; i < survey_->anchors.size(); ++i)
        paintAnchor(painter, scale, i, taken);
    painter.setFont(caption);
    painter.setPen(theme.tokens().t3);
    painter.drawText(row, kWrapped, legend());
}

}  // namespace noctule::ui
