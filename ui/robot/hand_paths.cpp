// SPDX-License-Identifier: Apache-2.0
#include "ui/robot/hand_paths.h"

#include <QPainter>

#include "ui/style/paint.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/widgets/accessible.h"

namespace noctule::ui {
namespace {

constexpr double kDivision_m = 0.1, kLeastSpan_m = 0.3;
constexpr int kBetween = 8;

}  // namespace

/// Two axes of the chest; the first points right on the screen, reversed: left.
struct HandPathsView::View {
    QString name;
    int across, up;
    bool reversed;
    QString across_name, up_name;
};

HandPathsView::HandPathsView(QWidget* parent) : QWidget(parent) {
    describe(*this, {QAccessible::Chart});
    setAccessibleName(tr("Hand of the robot, commanded against achieved"));
    connect(&Theme::get(), &Theme::changed, this, [this] { updateGeometry(), update(); });
}

void HandPathsView::show(RobotDrive::HandPaths paths) {
    paths_ = std::move(paths);
    setAccessibleDescription(paths_.tracking ? tr("The hand is %1 late. Without the delay it is off by %2.")
                                                   .arg(secondsText(paths_.tracking->delay_s, 2),
                                                        millimetresText(paths_.tracking->rest_rms_m))
                                             : tr("The hand does not move"));
    update();
}

QSize HandPathsView::sizeHint() const {
    return {Theme::get().px(480), Theme::get().px(150)};
}

QSize HandPathsView::minimumSizeHint() const {
    return {Theme::get().px(270), Theme::get().px(90)};
}

void HandPathsView::paintEvent(QPaintEvent*) {
    const View views[] = {{tr("Front"), 0, 1, false, "X", "Y"},
                          {tr("Side"), 2, 1, false, "Z", "Y"},
                          {tr("Top"), 0, 2, true, "X", "Z"}};
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const int gap = Theme::get().px(kBetween), each = (width() - 2 * gap) / 3;
    for (int i = 0; i < 3; ++i)
        paintView(painter, views[i], QRect(i * (each + gap), 0, each, height()));
}

void HandPathsView::paintView(QPainter& painter, const View& view, const QRect& frame) const {
    const Theme& theme = Theme::get();
    const Tokens& tokens = theme.tokens();
    paintBox(painter, frame, 4, tokens.view, tokens.line);
    Eigen::AlignedBox2d box;
    const auto inView = [&](const Vector3d& p) {
        return Eigen::Vector2d(view.reversed ? -p[view.across] : p[view.across], p[view.up]);
    };
    for (const auto* path : {&paths_.commanded, &paths_.achieved})
        for (const robot::PathPoint& point : *path)
            box.extend(inView(point.p_m));
    painter.save();
    painter.setClipRect(frame.adjusted(1, 1, -1, -1));
    if (!box.isEmpty()) {
        const double span = std::max({box.sizes().maxCoeff() * 1.2, kLeastSpan_m});
        const double scale = std::min(frame.width(), frame.height() - theme.px(24)) / span;
        const Eigen::Vector2d middle = box.center();
        const QPointF centre(frame.center().x(), frame.center().y() + theme.px(8));
        const auto onScreen = [&](const Eigen::Vector2d& p) {
            return QPointF(centre.x() + (p.x() - middle.x()) * scale,
                           centre.y() - (p.y() - middle.y()) * scale);
        };
        painter.setPen(QPen(tokens.grid, 1));
        for (int i = -20; i <= 20; ++i) {
            const double at = i * kDivision_m;
            const QPointF line = onScreen({(std::floor(middle.x() / kDivision_m)) * kDivision_m + at,
                                           (std::floor(middle.y() / kDivision_m)) * kDivision_m + at});
            painter.drawLine(QPointF(line.x(), frame.top()), QPointF(line.x(), frame.bottom()));
            painter.drawLine(QPointF(frame.left(), line.y()), QPointF(frame.right(), line.y()));
        }
        const auto draw = [&](const std::vector<robot::PathPoint>& path, const QPen& pen) {
            QPolygonF line;
            for (size_t i = 0; i < path.size(); i += 2)
                line << onScreen(inView(path[i].p_m));
            painter.setPen(pen);
            painter.drawPolyline(line);
            if (!line.isEmpty())
                painter.drawEllipse(line.last(), theme.px(3), theme.px(3));
        };
        painter.setBrush(Qt::NoBrush);
        draw(paths_.commanded, QPen(tokens.ref, 1, Qt::DashLine));
        draw(paths_.achieved, QPen(tokens.acc, 1));
    }
    painter.restore();
    const QRect inside = frame.adjusted(theme.px(8), theme.px(6), -theme.px(8), -theme.px(4));
    painter.setFont(theme.font(TextRole::kSecondary, true));
    painter.setPen(tokens.t1);
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignTop, view.name);
    const auto colorOfAxis = [&](const QString& name) {
        return name == "X" ? tokens.x : name == "Y" ? tokens.y : tokens.z;
    };
    painter.setPen(colorOfAxis(view.up_name));
    painter.drawText(inside, Qt::AlignRight | Qt::AlignTop, view.up_name);
    painter.setPen(colorOfAxis(view.across_name));
    painter.drawText(inside, Qt::AlignRight | Qt::AlignBottom, view.across_name);
}

}  // namespace noctule::ui
