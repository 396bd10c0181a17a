// SPDX-License-Identifier: Apache-2.0
// The plate on a level table, and the plate on the turntable.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/style/paint.h"
#include "ui/wizards/rig_canvas.h"

namespace noctule::ui {
namespace {

constexpr double kPlateWide = 6.6, kPlateHigh = 4, kPlateThick = 0.28, kUnderBoards = 0.18, kTable = 0.22;
constexpr double kBlockWide = 2.2, kBlockDeep = 0.9, kBlockOut = 0.45;
constexpr double kPlatter = 4.1, kPlatterThick = 0.3, kBaseHigh = 1, kBase = 3.3;

/// Steeper on what lies, so that its numbers can be read.
RigCamera plateCamera(int side, double lying_pitch_deg) {
    return plateStands(side) ? RigCamera(30, 20) : RigCamera(20, lying_pitch_deg);
}

/// A plate whose lowest point is at the height 0; a standing one has its face at z = 0.
struct PlaceOfPlate {
    explicit PlaceOfPlate(int side) {
        face.turn = plateTurn(side);
        const Vector3d half = (face.turn * Vector3d(kPlateWide / 2, kPlateHigh / 2, 0)).cwiseAbs();
        wide = 2 * half.x();
        high = 2 * half.y();
        const bool face_down = side == 5;
        face.p = {0, plateStands(side) ? half.y() : face_down ? kUnderBoards : kPlateThick, 0};
    }
    RigPlace face;
    double wide, high;  ///< in the drawing, the height of a standing one
    Vector3d low{-kPlateWide / 2, -kPlateHigh / 2, -kPlateThick}, up{kPlateWide / 2, kPlateHigh / 2, 0};
};

RigLook surface(const QColor& fill, const QColor& outline) {
    return {fill, outline, 1};
}

QColor plateColor(const Tokens& tokens) {
    return mixed(tokens.figure, tokens.edge, Theme::get().isDark() ? 0.42 : 0.22);
}

std::vector<Vector3d> allOf(const RigPlace& place, const Vector3d& low, const Vector3d& high) {
    std::vector<Vector3d> corners = cornersOf(low, high);
    for (Vector3d& corner : corners)
        corner = place * corner;
    return corners;
}

void append(std::vector<Vector3d>& points, const std::vector<Vector3d>& more) {
    points.insert(points.end(), more.begin(), more.end());
}

/// Plate, boards and letters; returns the edges of the board that is called out.
QVector<QPointF> paintPlateItself(RigCanvas& canvas, const PlaceOfPlate& plate, const RigPicture& picture) {
    const Tokens& tokens = canvas.tokens();
    const RigLook look = surface(plateColor(tokens), tokens.edge);
    const RigGrid grid(picture.boards.size(), kPlateWide - 0.3, kPlateHigh - 0.26);
    const bool from_behind = canvas.camera().nearness(plate.face.turn.col(2)) < 0;
    if (from_behind) {
        RigPicture plain = picture;  // their sides below the plate
        plain.boards.assign(picture.boards.size(), BoardMark::kWaiting);
        plain.wrong_board = -1;
        paintBoards(canvas, plate.face, grid, plain);
    }
    canvas.box(plate.face, plate.low, plate.up, look);
    RigPlace seen = plate.face;
    if (from_behind)
        seen.p += plate.face.turn * Vector3d(0, 0, -kPlateThick);
    const QVector<QPointF> called_out = paintBoards(canvas, seen, grid, picture, from_behind);

    const char down = edgeDown(picture.side);
    for (const char edge : {'A', 'B', 'C', 'D'}) {
        const Vector3d out = edgeDirection(edge), reach(kPlateWide / 2, kPlateHigh / 2, 0);
        const Vector3d middle = out.cwiseProduct(reach);
        if (edge == down) {
            const Vector3d along = Vector3d(out.y(), out.x(), 0).cwiseProduct(reach);
            canvas.polygon({plate.face * (middle - along), plate.face * (middle + along)},
                           {QColor(), tokens.acc, 3}, false);
        }
        canvas.letter(edge, canvas.at(plate.face * middle), canvas.camera().along(plate.face.turn * out),
                      edge == down);
    }
    std::vector<Vector3d> hull;
    for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
        hull.push_back(plate.face * Vector3d(x * kPlateWide / 2, y * kPlateHigh / 2, 0));
    canvas.keepFree(hull);
    return called_out;
}

/// About the x axis at the right of the plate; 0 lies in front, 90 stands.
QPolygonF tippingLine(const RigCanvas& canvas, double x, double radius, double from_deg, double to_deg) {
    constexpr int kSteps = 40;
    QPolygonF line;
    for (int i = 0; i <= kSteps; ++i) {
        const double angle = radians(from_deg + (to_deg - from_deg) * i / kSteps);
        line << canvas.at({x, radius * std::sin(angle), radius * std::cos(angle)});
    }
    return line;
}

void paintBlock(RigCanvas& canvas, const PlaceOfPlate& plate) {
    const double right = plate.wide / 2 + kBlockOut;
    canvas.box({}, {right - kBlockWide, 0, -kPlateThick - kBlockDeep},
               {right, std::min(2.4, 0.6 * plate.high), -kPlateThick},
               surface(canvas.tokens().figure, canvas.tokens().line));
}

std::vector<Vector3d> circle(double radius, double y, double from_deg = 0, double to_deg = 360) {
    constexpr int kSteps = 96;
    std::vector<Vector3d> points;
    for (int i = 0; i <= kSteps; ++i) {
        const double angle = radians(from_deg + (to_deg - from_deg) * i / kSteps);
        points.emplace_back(radius * std::cos(angle), y, -radius * std::sin(angle));
    }
    return points;
}

/// An upright cylinder around the middle.
void paintDrum(RigCanvas& canvas, double radius, double low, double high, const QColor& top,
               const QColor& side) {
    const RigLook wall = surface(side, canvas.tokens().edge);
    // From where its left and right end are seen; yaw turns them.
    double yaw_deg = 0;
    const QPointF x = canvas.camera().along(Vector3d::UnitX()), z = canvas.camera().along(Vector3d::UnitZ());
    yaw_deg = std::atan2(z.x(), x.x()) * 180 / std::numbers::pi;
    std::vector<Vector3d> points = circle(radius, high, 180 - yaw_deg, 360 - yaw_deg);
    const std::vector<Vector3d> lower = circle(radius, low, 360 - yaw_deg, 180 - yaw_deg);
    append(points, lower);
    canvas.polygon(points, wall);
    canvas.polygon(circle(radius, high), surface(top, canvas.tokens().edge));
}

/// The driver box rides along; so do its wires, coiled.
void paintRider(RigCanvas& canvas, const Vector3d& corner) {
    const Tokens& tokens = canvas.tokens();
    const Vector3d size(1.4, 0.65, 0.75);
    const QPointF coil = canvas.at(corner + Vector3d(-0.75, 0, 0.4));
    const double wide = 0.5 * canvas.camera().scale_px();
    const double flat = -canvas.camera().along(Vector3d::UnitZ()).y() / canvas.camera().scale_px();
    canvas.painter().setBrush(Qt::NoBrush);
    canvas.painter().setPen(QPen(tokens.t3, canvas.px(1.5)));
    for (const double part : {1.0, 0.8, 0.6})
        canvas.painter().drawEllipse(coil, part * wide, part * wide * std::max(0.3, std::abs(flat)));
    canvas.polygon({corner + Vector3d(-0.4, 0, 0.2), corner + Vector3d(0, 0.15, 0.3)},
                   {QColor(), tokens.t3, 1.5}, false);
    canvas.box({}, corner, corner + size, surface(tokens.ctlh, tokens.edge));
    canvas.text(RigDrawing::tr("box"), corner + Vector3d(size.x() / 2, size.y() / 2, size.z()),
                Vector3d(0.42, 0, 0), Vector3d(0, 0.42, 0), tokens.t1);
}

}  // namespace

void paintPlate(RigCanvas& canvas, const RigPicture& picture) {
    const bool stands = plateStands(picture.side);
    const PlaceOfPlate plate(picture.side);
    const Tokens& tokens = canvas.tokens();
    const double back = stands ? -kPlateThick - kBlockDeep - 0.5 : -kPlateHigh / 2 - 0.9;
    const double front = stands ? plate.high * 0.86 : kPlateHigh / 2 + 0.9;
    const Vector3d low(-plate.wide / 2 - 0.8, -kTable, back), high(plate.wide / 2 + 1.2, 0, front);
    std::vector<Vector3d> points = cornersOf(low, high);
    append(points, allOf(plate.face, plate.low, plate.up));
    canvas.fit(plateCamera(picture.side, 42), points);

    canvas.keepQuiet({{low.x(), low.y(), high.z()},
                      {high.x(), low.y(), high.z()},
                      {high.x(), 0, low.z()},
                      {low.x(), 0, low.z()}});
    canvas.box({}, low, high, surface(tokens.view2, mixed(tokens.line, tokens.edge, 0.3)));
    if (stands) {
        const double half = plate.wide / 2, far = plate.high * 0.74;
        canvas.polygon({{-half, 0, 0}, {half, 0, 0}, {half, 0, far}, {-half, 0, far}},
                       {QColor(), tokens.edge, 1, true});
        paintBlock(canvas, plate);
    }
    const QVector<QPointF> called_out = paintPlateItself(canvas, plate, picture);
    const double beside = plate.wide / 2 + 0.8;
    if (stands)
        canvas.arrow(tippingLine(canvas, beside, 0.88 * plate.high, 6, 76), tokens.acc, 3);
    else if (picture.side == 5)
        canvas.arrow(tippingLine(canvas, beside, 1.5, -20, 200), tokens.acc, 3);
    if (picture.side >= 0)
        canvas.downArrow();
    canvas.callOut(picture, called_out);
}

void paintTurntable(RigCanvas& canvas, const RigPicture& picture) {
    const Tokens& tokens = canvas.tokens();
    const bool stands = plateStands(picture.side);
    PlaceOfPlate plate(picture.side);
    const double arrow_radius = kPlatter + 0.75;
    std::vector<Vector3d> points = circle(arrow_radius, -kPlatterThick);
    append(points, circle(kBase, -kPlatterThick - kBaseHigh));
    append(points, allOf(plate.face, plate.low, plate.up));
    canvas.fit(plateCamera(picture.side, 37), points);

    canvas.keepQuiet(circle(kPlatter, 0));
    paintDrum(canvas, kBase, -kPlatterThick - kBaseHigh, -kPlatterThick, tokens.ctl, tokens.ctl);
    paintDrum(canvas, kPlatter, -kPlatterThick, 0, tokens.view2, tokens.ctl);
    if (stands)
        paintBlock(canvas, plate);
    const QVector<QPointF> called_out = paintPlateItself(canvas, plate, picture);
    paintRider(canvas, stands ? Vector3d(0.7, 0, 1.7) : Vector3d(0.35, 0, 2.9));
    QPolygonF line;
    for (const Vector3d& p : circle(arrow_radius, -kPlatterThick, 215, 310))
        line << canvas.at(p);
    canvas.arrow(line, picture.turns ? tokens.acc : tokens.edge, picture.turns ? 4 : 2);
    if (picture.side >= 0)
        canvas.downArrow();
    canvas.callOut(picture, called_out);
}

}  // namespace noctule::ui
