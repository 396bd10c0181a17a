// SPDX-License-Identifier: Apache-2.0
// The camera of one view and how mouse and keys move it. Navigation as in Blender (middle drag orbits, with
// Shift it pans) or as in Maya (Alt with the left, middle and right button), by the setting
// "view/navigation"; the wheel zooms in both.
#pragma once

#include <QObject>
#include <QPointF>
#include <QVariantAnimation>
#include <Qt>

#include "core/render/camera.h"

class QMouseEvent;
class QWheelEvent;

namespace noctule::ui {

enum class Navigation { kBlender, kMaya };

class CameraControl : public QObject {
    Q_OBJECT
public:
    explicit CameraControl(QObject* parent = nullptr);

    const Camera& camera() const { return camera_; }
    CameraView view() const { return view_; }
    void setNavigation(Navigation navigation) { navigation_ = navigation; }
    void setSize(const PictureSize& size) { size_ = size; }
    const PictureSize& size() const { return size_; }

    /// At once, ending any flight.
    void setCamera(const Camera& camera, CameraView view = CameraView::kFree);
    void setView(CameraView view);
    void frame(const Eigen::AlignedBox3d& box, bool at_once = false);
    /// Moves with what is followed.
    void shift(const Vector3d& by_m);

    /// True when the press begins a movement of the camera, which lasts until release().
    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool release(const QMouseEvent& event);
    void wheel(const QWheelEvent& event);
    bool isMoving() const { return drag_ != Drag::kNone || flight_.state() == QAbstractAnimation::Running; }

signals:
    void changed();
    void viewChanged();

private:
    enum class Drag { kNone, kOrbit, kPan, kZoom };
    Drag dragFor(const QMouseEvent& event) const;
    void dragBy(const QPointF& moved);
    void flyTo(const Camera& camera);
    void becomeFree();

    Camera camera_;
    CameraView view_ = CameraView::kFree;
    Navigation navigation_ = Navigation::kBlender;
    PictureSize size_;
    Drag drag_ = Drag::kNone;
    QPointF last_;
    Camera flight_from_, flight_to_;
    QVariantAnimation flight_;
};

}  // namespace noctule::ui
