// SPDX-License-Identifier: Apache-2.0
// What the drawings of the rigs are made of: boxes, numbers lying in a face, letters in circles, arrows and
// the call-out. Keeps in mind where something important is, so that the call-out finds a free place.
#pragma once

#include <QPainter>
#include <QPolygonF>

#include "ui/style/theme.h"
#include "ui/wizards/rig_drawing.h"
#include "ui/wizards/rig_geometry.h"

namespace noctule::ui {

/// Where a thing stands in the drawing.
struct RigPlace {
    Matrix3d turn = Matrix3d::Identity();
    Vector3d p = Vector3d::Zero();

    Vector3d operator*(const Vector3d& v) const { return turn * v + p; }
};

/// How a face or a line looks; without an outline: invalid colour.
struct RigLook {
    QColor fill, outline;
    double width = 1;  ///< of the outline, as RigCanvas::px
    bool dashed = false;
};

class RigCanvas {
public:
    RigCanvas(QPainter& painter, const QSize& size);

    /// All points inside the widget, with room for letters and words around.
    void fit(const RigCamera& camera, const std::vector<Vector3d>& points);

    /// The faces that can be seen, each as bright as it is lit.
    void box(const RigPlace& place, const Vector3d& low, const Vector3d& high, const RigLook& look);
    void polygon(const std::vector<Vector3d>& corners, const RigLook& look, bool closed = true);
    /// Turns both by quarters until what stands on them reads upright.
    void makeUpright(Vector3d& right, Vector3d& up) const;
    /// Around `centre` in the plane of `right` and `up` (the longer, the larger: one unit is one em), turned
    /// by quarters until it reads upright.
    void text(const QString& words, const Vector3d& centre, const Vector3d& right, const Vector3d& up,
              const QColor& color);
    /// A check mark in the plane, within `right` and `up` of its centre.
    void check(const Vector3d& centre, const Vector3d& right, const Vector3d& up, const QColor& color);
    /// A letter in a circle beside `at_px`, outwards.
    void letter(char letter, const QPointF& at_px, const QPointF& outwards_px, bool filled);
    /// With a head at its end, or at both.
    void arrow(const QPolygonF& line_px, const QColor& color, double width, bool both_ends = false);
    /// In the middle of `centre_px`; its rectangle.
    QRectF label(const QString& words, const QPointF& centre_px, const QColor& color,
                 TextRole role = TextRole::kBody);
    /// At the lower left: where gravity points.
    void downArrow();
    /// Its leader ends at one of the targets: the way that is shortest and hides least.
    void callOut(const RigPicture& picture, const QVector<QPointF>& targets_px);

    /// Surfaces that the call-out keeps off, and those that it had better not touch.
    void keepFree(const std::vector<Vector3d>& corners) { surfaces_.push_back(seen(corners)); }
    void keepQuiet(const std::vector<Vector3d>& corners) { quiet_.push_back(seen(corners)); }
    void keepFree(const QRectF& rect_px) { taken_.push_back(rect_px); }
    /// Leaders go around it when they can.
    void keepReadable(const QPointF& centre_px, double radius_px) { read_.push_back({centre_px, radius_px}); }

    QPointF at(const Vector3d& p) const { return camera_.at(p); }
    const RigCamera& camera() const { return camera_; }
    const Tokens& tokens() const { return theme_.tokens(); }
    const Theme& theme() const { return theme_; }
    QPainter& painter() { return painter_; }
    double letterRadius_px() const;
    /// A length at 100 percent and the usual size of the drawing.
    double px(double at_100_percent) const;
    QFont font(TextRole role, bool medium = false) const;
    double width_px() const { return size_.width(); }
    double height_px() const { return size_.height(); }

private:
    struct Round {
        QPointF centre_px;
        double radius_px;
    };
    /// Where a call-out stands and what its leader points to.
    struct CallOutPlace {
        QRectF block_px;
        QPointF target_px;
        bool left = true;
        double cost = 1e9;
    };
    CallOutPlace placeForCallOut(const QSizeF& block_px, const QVector<QPointF>& targets_px) const;
    QPolygonF seen(const std::vector<Vector3d>& corners) const;
    bool isFree(const QRectF& rect_px) const;
    double crossed(const QPointF& from_px, const QPointF& to_px) const;
    double lengthOverSurfaces_px(const QPointF& from_px, const QPointF& to_px) const;
    QColor lit(const QColor& color, const Vector3d& normal) const;
    void use(const RigLook& look, const QColor& fill);
    QTransform plane(const Vector3d& centre, const Vector3d& right, const Vector3d& up) const;

    QPainter& painter_;
    const Theme& theme_;
    QSizeF size_;
    RigCamera camera_{0, 0};
    std::vector<QRectF> taken_;
    std::vector<QPolygonF> surfaces_, quiet_;
    std::vector<Round> read_;
};

/// How a board with this mark looks.
struct RigBoardLook {
    RigLook box;
    QColor number;
};
RigBoardLook boardLook(BoardMark mark);

/// Slots of the plate and of the jig's frame: 6 columns and 3 rows, more for more boards.
struct RigGrid {
    int columns = 6, rows = 3;
    double wide = 6, high = 3;  ///< of all slots
    explicit RigGrid(size_t boards, double wide, double high);
    /// From the middle of all slots, x to the right, y up.
    QPointF slot(int index) const;
    double board() const;  ///< how wide a board is
};

/// The boards (or free slots) on a face, in the face's frame: x right, y up, z out of it. Returns the
/// edges of the board that is called out.
QVector<QPointF> paintBoards(RigCanvas& canvas, const RigPlace& face, const RigGrid& grid,
                             const RigPicture& picture, bool seen_from_behind = false);

void paintPlate(RigCanvas& canvas, const RigPicture& picture);
void paintTurntable(RigCanvas& canvas, const RigPicture& picture);
void paintJig(RigCanvas& canvas, const RigPicture& picture);
/// `image`: the figure as it was painted last, empty when its colour has changed.
void paintStand(RigCanvas& canvas, const RigPicture& picture, const BodyFigure& figure, const Suit& suit,
                QImage& image);

}  // namespace noctule::ui
