// SPDX-License-Identifier: Apache-2.0
// The jig that measures the offsets of the sources: sources on bars to the left, boards in a frame to the
// right.

#include <cmath>

#include "ui/style/paint.h"
#include "ui/wizards/rig_canvas.h"

namespace noctule::ui {
namespace {

constexpr double kBars = -3.3, kFrame = 2.9, kFrameWide = 5.2, kFrameLow = 0.8, kFrameHigh = 3.7;
constexpr double kFloorThick = 0.2;

/// A foot, and a pole up to `top`.
void paintPole(RigCanvas& canvas, double x, double z, double top) {
    const Tokens& tokens = canvas.tokens();
    canvas.box({}, {x - 0.7, 0, z - 0.5}, {x + 0.7, 0.14, z + 0.5}, {tokens.figure, tokens.edge});
    canvas.box({}, {x - 0.09, 0.14, z - 0.09}, {x + 0.09, top, z + 0.09}, {tokens.figure, tokens.edge});
}

/// A loudspeaker as in the icon, that speaks to the right.
void paintSource(RigCanvas& canvas, const Vector3d& p) {
    const auto at = [&p](double x, double y) { return Vector3d(p + Vector3d(x, y, 0)); };
    const QColor color = canvas.tokens().t2;
    canvas.polygon(
        {at(-0.3, -0.15), at(-0.3, 0.15), at(-0.06, 0.15), at(0.24, 0.36), at(0.24, -0.36), at(-0.06, -0.15)},
        {canvas.tokens().raised, color, 2});
    std::vector<Vector3d> wave;
    for (int i = -8; i <= 8; ++i)
        wave.push_back(at(0.12 + 0.42 * std::cos(i * 0.09), 0.42 * std::sin(i * 0.09)));
    canvas.polygon(wave, {QColor(), canvas.tokens().acc, 2}, false);
}

void paintSources(RigCanvas& canvas) {
    const Tokens& tokens = canvas.tokens();
    paintPole(canvas, kBars, 0, 3.5);
    for (const double y : {3.4, 2.0})
        canvas.box({}, {kBars - 0.08, y - 0.08, -1.9}, {kBars + 0.08, y + 0.08, 1.9},
                   {tokens.figure, tokens.edge});
    for (const double y : {3.4, 2.0})
        for (const double z : {-1.65, -0.55, 0.55, 1.65})
            paintSource(canvas, {kBars + 0.1, y, z});
}

QVector<QPointF> paintFrame(RigCanvas& canvas, const RigPicture& picture) {
    const Tokens& tokens = canvas.tokens();
    for (const double z : {-1.7, 1.7})
        paintPole(canvas, kFrame + 0.15, z, kFrameLow);
    RigPlace face;  // it looks to the sources
    face.turn << Vector3d::UnitZ(), Vector3d::UnitY(), -Vector3d::UnitX();
    face.p = {kFrame, (kFrameLow + kFrameHigh) / 2, 0};
    const double half = kFrameWide / 2, up = (kFrameHigh - kFrameLow) / 2;
    canvas.box(face, {-half, -up, -0.25}, {half, up, 0},
               {mixed(tokens.figure, tokens.edge, Theme::get().isDark() ? 0.42 : 0.22), tokens.edge});
    canvas.keepFree({face * Vector3d(-half, -up, 0), face * Vector3d(half, -up, 0),
                     face * Vector3d(half, up, 0), face * Vector3d(-half, up, 0)});
    return paintBoards(canvas, face, RigGrid(picture.boards.size(), kFrameWide - 0.3, 2 * up - 0.3), picture);
}

void paintDistance(RigCanvas& canvas, double z) {
    const Tokens& tokens = canvas.tokens();
    for (const double x : {kBars, kFrame})
        canvas.polygon({{x, 0, 0.6}, {x, 0, z + 0.35}}, {QColor(), tokens.edge, 1.5, true}, false);
    const QPointF from = canvas.at({kBars, 0, z}), to = canvas.at({kFrame, 0, z});
    canvas.arrow(QVector<QPointF>{from, to}, tokens.acc, 3, true);
    const QString words = RigDrawing::tr("30 to 90 cm");
    // Below the sloping line with its whole length.
    const double wide = QFontMetricsF(canvas.font(TextRole::kPage)).horizontalAdvance(words);
    const double slope = (from.y() - to.y()) / std::max(1.0, to.x() - from.x());
    canvas.label(words, (from + to) / 2 + QPointF(0, canvas.px(20) + 0.6 * wide * slope), canvas.tokens().t1,
                 TextRole::kPage);
}

}  // namespace

void paintJig(RigCanvas& canvas, const RigPicture& picture) {
    const Vector3d low(kBars - 1.1, -kFloorThick, -2.9), high(kFrame + 1.2, 0, 3.4);
    std::vector<Vector3d> points = cornersOf(low, high);
    points.emplace_back(kFrame, kFrameHigh, -kFrameWide / 2);
    points.emplace_back(kBars, 3.8, -2);
    canvas.fit(RigCamera(46, 20), points);
    canvas.box({}, low, high,
               {canvas.tokens().view2, mixed(canvas.tokens().line, canvas.tokens().edge, 0.3)});
    paintDistance(canvas, 2.6);
    const QVector<QPointF> called_out = paintFrame(canvas, picture);
    paintSources(canvas);
    canvas.callOut(picture, called_out);
}

}  // namespace noctule::ui
