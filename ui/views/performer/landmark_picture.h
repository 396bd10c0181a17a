// SPDX-License-Identifier: Apache-2.0
// A mesh seen from the front and from its left at one scale, with its landmarks as points that are dragged.
// Arrow keys move the chosen one by 1 mm (Shift: 1 cm), Page Up and Down backward and forward, comma and full
// stop choose another; the wheel comes nearer, the middle button shifts the picture, F frames it again.
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "core/mesh/rig/body_landmarks.h"
#include "ui/scene/surface_picture.h"

namespace noctule::ui {

/// "Left wrist", "Head, tip"
QString landmarkName(const std::string& landmark);

class LandmarkPicture : public QWidget {
    Q_OBJECT
public:
    explicit LandmarkPicture(QWidget* parent = nullptr);

    /// `surface` as of standingSurface(); null: points alone.
    void setSurface(std::shared_ptr<const SkinnedMesh> surface);
    void setLandmarks(const Landmarks& places);
    /// Marked together with the chosen one; empty: none.
    void choose(const std::string& landmark, const std::string& twin);
    const std::string& chosen() const { return chosen_; }

    enum View { kFront, kLeftSide };
    /// Where a landmark is drawn, pixels of this widget.
    QPointF pointOf(View view, const std::string& landmark) const;
    double pixelsPerMetre() const;
    /// The one under the mouse; empty: none.
    const std::string& hovered() const { return hovered_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return 2 * sizeHint() / 3; }

signals:
    void landmarkChosen(const QString& landmark);
    /// Before the first movement of a drag, and before each key.
    void moveBegins();
    void moved(const QString& landmark, double x_m, double y_m, double z_m);
    /// Esc while a point is dragged.
    void moveCancelled();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Pane {
        Camera camera;
        QRect rect;
        QImage drawn;  ///< the surface; null: to be drawn
        PictureSize size() const { return {rect.width(), rect.height()}; }
    };
    /// One that the mouse has hold of.
    struct Drag {
        size_t pane;
        Vector3d from_m;  ///< of the landmark
        QPointF from_px;
        bool has_moved = false;
    };
    void frame();
    void share(const Eigen::AlignedBox3d& box);
    size_t paneAt(const QPointF& at) const;
    QPointF onScreen(const Pane& pane, const Vector3d& p_m) const;
    std::string landmarkAt(const QPointF& at) const;
    void hover(const std::string& landmark);
    void pick(const std::string& landmark);
    void step(int by);
    bool nudge(const QKeyEvent& event);
    void move(const Vector3d& p_m);
    void drawAgain();
    void paintPane(QPainter& painter, Pane& pane);
    void paintPoint(QPainter& painter, const Pane& pane, const std::string& landmark, const Vector3d& p_m);
    void paintName(QPainter& painter, const Pane& pane, const std::string& landmark);

    std::array<Pane, 2> panes_;
    SurfacePicture painter_;
    std::shared_ptr<const SkinnedMesh> surface_;
    Landmarks places_;
    std::string chosen_, twin_, hovered_;
    std::optional<Drag> drag_;
    std::optional<QPointF> pan_from_px_;
    size_t last_pane_ = 0;  ///< the mouse was there
};

}  // namespace noctule::ui
