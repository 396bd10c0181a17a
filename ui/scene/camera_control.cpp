// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/camera_control.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "ui/style/theme.h"

namespace noctule::ui {

namespace {

constexpr double kOrbit_rad_per_px = 0.008;
constexpr double kZoomPerPx = 1.006;
constexpr double kZoomPerNotch = 1.15;
constexpr int kFlight_ms = 200;

}  // namespace

CameraControl::CameraControl(QObject* parent) : QObject(parent) {
    flight_.setStartValue(0.0);
    flight_.setEndValue(1.0);
    flight_.setEasingCurve(QEasingCurve::OutCubic);
    connect(&flight_, &QVariantAnimation::valueChanged, this, [this](const QVariant& fraction) {
        camera_ = Camera::between(flight_from_, flight_to_, fraction.toDouble());
        emit changed();
    });
    connect(&flight_, &QVariantAnimation::finished, this, &CameraControl::changed);
}

void CameraControl::setCamera(const Camera& camera, CameraView view) {
    flight_.stop();
    camera_ = camera;
    const bool other = view != view_;
    view_ = view;
    emit changed();
    if (other)
        emit viewChanged();
}

void CameraControl::setView(CameraView view) {
    Camera camera = camera_;
    camera.setView(view);
    if (view != view_) {
        view_ = view;
        emit viewChanged();
    }
    flyTo(camera);
}

void CameraControl::frame(const Eigen::AlignedBox3d& box, bool at_once) {
    Camera camera = flight_.state() == QAbstractAnimation::Running ? flight_to_ : camera_;
    camera.frame(box, size_, 0.03);
    if (at_once)
        setCamera(camera, view_);
    else
        flyTo(camera);
}

void CameraControl::shift(const Vector3d& by_m) {
    camera_.target_m += by_m;
    flight_from_.target_m += by_m;
    flight_to_.target_m += by_m;
}

void CameraControl::flyTo(const Camera& camera) {
    flight_.stop();
    const int ms = Theme::get().motion_ms(kFlight_ms);
    if (ms == 0) {
        camera_ = camera;
        emit changed();
        return;
    }
    flight_from_ = camera_;
    flight_to_ = camera;
    flight_.setDuration(ms);
    flight_.start();
}

CameraControl::Drag CameraControl::dragFor(const QMouseEvent& event) const {
    const bool shift = event.modifiers() & Qt::ShiftModifier;
    if (navigation_ == Navigation::kMaya) {
        if (!(event.modifiers() & Qt::AltModifier))
            return Drag::kNone;
        switch (event.button()) {
            case Qt::LeftButton:
                return Drag::kOrbit;
            case Qt::MiddleButton:
                return Drag::kPan;
            case Qt::RightButton:
                return Drag::kZoom;
            default:
                return Drag::kNone;
        }
    }
    // A trackpad has no middle button: Alt with the left one stands for it.
    const bool middle = event.button() == Qt::MiddleButton ||
                        (event.button() == Qt::LeftButton && event.modifiers() & Qt::AltModifier);
    if (!middle)
        return Drag::kNone;
    if (event.modifiers() & Qt::ControlModifier)
        return Drag::kZoom;
    return shift ? Drag::kPan : Drag::kOrbit;
}

bool CameraControl::press(const QMouseEvent& event) {
    if (drag_ != Drag::kNone)
        return true;
    drag_ = dragFor(event);
    last_ = event.localPos();
    if (drag_ != Drag::kNone)
        flight_.stop();
    return drag_ != Drag::kNone;
}

bool CameraControl::move(const QMouseEvent& event) {
    if (drag_ == Drag::kNone)
        return false;
    const QPointF moved = event.localPos() - last_;
    last_ = event.localPos();
    dragBy(moved);
    return true;
}

bool CameraControl::release(const QMouseEvent& event) {
    if (drag_ == Drag::kNone || event.buttons() != Qt::NoButton)
        return drag_ != Drag::kNone;
    drag_ = Drag::kNone;
    emit changed();
    return true;
}

void CameraControl::dragBy(const QPointF& moved) {
    switch (drag_) {
        case Drag::kOrbit:
            camera_.orbit(-kOrbit_rad_per_px * moved.x(), kOrbit_rad_per_px * moved.y());
            becomeFree();
            break;
        case Drag::kPan:
            camera_.pan(moved.x(), moved.y(), size_);
            break;
        case Drag::kZoom:
            camera_.zoom(std::pow(kZoomPerPx, moved.x() - moved.y()));
            break;
        case Drag::kNone:
            return;
    }
    emit changed();
}

void CameraControl::wheel(const QWheelEvent& event) {
    flight_.stop();
    camera_.zoom(std::pow(kZoomPerNotch, event.angleDelta().y() / 120.0));
    emit changed();
}

void CameraControl::becomeFree() {
    if (view_ == CameraView::kFree)
        return;
    view_ = CameraView::kFree;
    emit viewChanged();
}

}  // namespace noctule::ui
