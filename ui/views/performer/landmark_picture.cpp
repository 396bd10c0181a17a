// SPDX-License-Identifier: Apache-2.0
#include "ui/views/performer/landmark_picture.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "core/render/picking.h"
#include "ui/models/part_names.h"
#include "ui/style/theme.h"
#include "ui/style/words.h"
#include "ui/widgets/accessible.h"

namespace noctule::ui {
namespace {

constexpr int kWidth = 560, kHeight = 360, kBetween_px = 1;
constexpr double kLeastFront = 0.5, kMostFront = 0.72;  ///< of the width
constexpr double kFrameMargin = 0.07, kReach_px = 12, kDragStart_px = 3;
constexpr double kNudge_m = 0.001, kBigNudge_m = 0.01, kZoomPerTurn = 1.2;

QString toText(const std::string& landmark) {
    return QString::fromStdString(landmark);
}

}  // namespace

QString landmarkName(const std::string& landmark) {
    const std::string end = "End";
    if (landmark.ends_with(end) && landmark != end)
        return LandmarkPicture::tr("%1, tip").arg(
            segmentName(landmark.substr(0, landmark.size() - end.size())));
    return jointName(landmark);
}

LandmarkPicture::LandmarkPicture(QWidget* parent) : QWidget(parent) {
    AccessibleParts parts;
    parts.role = QAccessible::Graphic;
    parts.value_text = [this] {
        const auto place = places_.find(chosen_);
        return place == places_.end()
                   ? QString()
                   : tr("%1: %2 to its left, %3 up, %4 forward")
                         .arg(landmarkName(chosen_), millimetresText(place->second.x()),
                              millimetresText(place->second.y()), millimetresText(place->second.z()));
    };
    parts.value = [this] {
        return static_cast<double>(std::distance(places_.begin(), places_.find(chosen_)));
    };
    parts.maximum = static_cast<double>(landmarkNames().size());
    describe(*this, parts);
    setAccessibleName(tr("Where the joints are in the mesh"));
    setAccessibleDescription(
        tr("Arrow keys move the chosen joint, with Shift by a centimetre; Page Up and Page Down move it "
           "backward and forward; comma and full stop choose another."));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    panes_[kFront].camera.setView(CameraView::kFront);
    panes_[kLeftSide].camera.setView(CameraView::kSide);
    connect(&Theme::get(), &Theme::changed, this, [this] {
        updateGeometry();
        drawAgain();
    });
}

QSize LandmarkPicture::sizeHint() const {
    return {Theme::get().px(kWidth), Theme::get().px(kHeight)};
}

void LandmarkPicture::setSurface(std::shared_ptr<const SkinnedMesh> surface) {
    surface_ = std::move(surface);
    frame();
}

void LandmarkPicture::setLandmarks(const Landmarks& places) {
    const bool is_first = places_.empty();
    places_ = places;
    if (is_first)
        frame();
    update();
}

void LandmarkPicture::choose(const std::string& landmark, const std::string& twin) {
    chosen_ = landmark;
    twin_ = twin;
    tellValueChanged(*this, 0);
    update();
}

/// All of the mesh and the points in both views at one scale, so that heights can be compared.
void LandmarkPicture::frame() {
    Eigen::AlignedBox3d box;
    for (const auto& [name, p_m] : places_)
        box.extend(p_m);
    if (surface_)
        for (const SkinnedVertex& vertex : surface_->vertices)
            box.extend(vertex.p_m.cast<double>());
    share(box);
    double distance_m = 0;
    for (Pane& pane : panes_) {
        pane.camera.frame(box, pane.size(), kFrameMargin);
        distance_m = std::max(distance_m, pane.camera.distance_m);
    }
    for (Pane& pane : panes_)
        pane.camera.distance_m = distance_m;
    drawAgain();
}

void LandmarkPicture::drawAgain() {
    for (Pane& pane : panes_)
        pane.drawn = {};
    update();
}

/// Stretched arms take more room than feet do.
void LandmarkPicture::share(const Eigen::AlignedBox3d& box) {
    const double wide_m = box.isEmpty() ? 1 : box.sizes().x(), deep_m = box.isEmpty() ? 1 : box.sizes().z();
    const double front_share = std::clamp(wide_m / std::max(1e-9, wide_m + deep_m), kLeastFront, kMostFront);
    const int front = static_cast<int>(std::lround(front_share * width()));
    panes_[kFront].rect = {0, 0, std::max(1, front), std::max(1, height())};
    panes_[kLeftSide].rect = {front + kBetween_px, 0, std::max(1, width() - front - kBetween_px),
                              std::max(1, height())};
}

void LandmarkPicture::resizeEvent(QResizeEvent*) {
    frame();
}

double LandmarkPicture::pixelsPerMetre() const {
    return panes_[kFront].camera.pixelsPerMetre(Vector3d::Zero(), panes_[kFront].size());
}

QPointF LandmarkPicture::onScreen(const Pane& pane, const Vector3d& p_m) const {
    const Vector3d p = pane.camera.project(p_m, pane.size()).value();
    return QPointF(pane.rect.topLeft()) + QPointF(p.x(), p.y());
}

QPointF LandmarkPicture::pointOf(View view, const std::string& landmark) const {
    return onScreen(panes_[view], places_.at(landmark));
}

size_t LandmarkPicture::paneAt(const QPointF& at) const {
    return at.x() < panes_[kLeftSide].rect.left() ? kFront : kLeftSide;
}

/// The chosen one wins where others are as near: it was chosen for a reason.
std::string LandmarkPicture::landmarkAt(const QPointF& at) const {
    const Pane& pane = panes_[paneAt(at)];
    const auto isNear = [&](const std::string& landmark) {
        const QPointF apart = onScreen(pane, places_.at(landmark)) - at;
        return std::hypot(apart.x(), apart.y()) <= kReach_px / 2;
    };
    if (places_.contains(chosen_) && isNear(chosen_))
        return chosen_;
    std::vector<std::string> names;
    std::vector<Vector3d> points_m;
    for (const auto& [name, p_m] : places_) {
        names.push_back(name);
        points_m.push_back(p_m);
    }
    const QPointF in_pane = at - QPointF(pane.rect.topLeft());
    const auto found = pointUnderPixel(points_m, {pane.camera, pane.size(), 1},
                                       Eigen::Vector2d(in_pane.x(), in_pane.y()), kReach_px);
    return found ? names[found->index] : std::string();
}

void LandmarkPicture::hover(const std::string& landmark) {
    if (landmark == hovered_)
        return;
    hovered_ = landmark;
    setCursor(landmark.empty() ? Qt::ArrowCursor : Qt::PointingHandCursor);
    update();
}

void LandmarkPicture::pick(const std::string& landmark) {
    if (landmark != chosen_)
        emit landmarkChosen(toText(landmark));
}

void LandmarkPicture::move(const Vector3d& p_m) {
    emit moved(toText(chosen_), p_m.x(), p_m.y(), p_m.z());
    tellValueChanged(*this, 0);
}

void LandmarkPicture::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::MiddleButton)
        pan_from_px_ = event->localPos();
    if (event->button() != Qt::LeftButton)
        return;
    const std::string landmark = landmarkAt(event->localPos());
    if (landmark.empty())
        return;
    pick(landmark);
    drag_ = Drag{paneAt(event->localPos()), places_.at(landmark), event->localPos()};
}

void LandmarkPicture::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->localPos();
    last_pane_ = drag_ ? drag_->pane : paneAt(at);
    Pane& pane = panes_[last_pane_];
    if (pan_from_px_) {
        pane.camera.pan(at.x() - pan_from_px_->x(), at.y() - pan_from_px_->y(), pane.size());
        pan_from_px_ = at;
        return drawAgain();
    }
    if (!drag_)
        return hover(landmarkAt(at));
    const QPointF way_px = at - drag_->from_px;
    if (!drag_->has_moved && std::hypot(way_px.x(), way_px.y()) < kDragStart_px)
        return;
    if (!drag_->has_moved)
        emit moveBegins();
    drag_->has_moved = true;
    const Matrix3d axes = pane.camera.axes();
    const double px_per_m = pane.camera.pixelsPerMetre(drag_->from_m, pane.size());
    move(drag_->from_m + (way_px.x() * axes.col(0) - way_px.y() * axes.col(1)) / px_per_m);
}

void LandmarkPicture::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::MiddleButton)
        pan_from_px_.reset();
    if (event->button() == Qt::LeftButton)
        drag_.reset();
    hover(landmarkAt(event->localPos()));
}

void LandmarkPicture::leaveEvent(QEvent*) {
    hover({});
}

/// What is under the mouse stays there.
void LandmarkPicture::wheelEvent(QWheelEvent* event) {
    Pane& pane = panes_[paneAt(event->position())];
    const QPointF at = event->position() - QPointF(pane.rect.topLeft());
    const Vector3d before_m = pane.camera.sightLine(at.x(), at.y(), pane.size()).origin_m;
    pane.camera.zoom(std::pow(kZoomPerTurn, event->angleDelta().y() / 120.0));
    const Vector3d after_m = pane.camera.sightLine(at.x(), at.y(), pane.size()).origin_m;
    const Vector3d depth = pane.camera.axes().col(2);
    const Vector3d apart_m = before_m - after_m;
    pane.camera.target_m += apart_m - apart_m.dot(depth) * depth;
    drawAgain();
    event->accept();
}

void LandmarkPicture::step(int by) {
    const std::vector<std::string> names = landmarkNames();
    const int count = static_cast<int>(names.size());
    const auto found = std::find(names.begin(), names.end(), chosen_);
    const int now = found == names.end() ? (by > 0 ? -1 : 0) : static_cast<int>(found - names.begin());
    pick(names[static_cast<size_t>((now + by + count) % count)]);
}

bool LandmarkPicture::nudge(const QKeyEvent& event) {
    Vector3d way = Vector3d::Zero();
    switch (event.key()) {
        case Qt::Key_Left:
        case Qt::Key_Right:
            way.x() = event.key() == Qt::Key_Left ? -1 : 1;
            break;
        case Qt::Key_Down:
        case Qt::Key_Up:
            way.y() = event.key() == Qt::Key_Down ? -1 : 1;
            break;
        case Qt::Key_PageUp:
        case Qt::Key_PageDown:
            way.z() = event.key() == Qt::Key_PageUp ? -1 : 1;
            break;
        default:
            return false;
    }
    if (!places_.contains(chosen_))
        return true;
    emit moveBegins();
    move(places_.at(chosen_) + way * (event.modifiers() & Qt::ShiftModifier ? kBigNudge_m : kNudge_m));
    return true;
}

void LandmarkPicture::keyPressEvent(QKeyEvent* event) {
    if (nudge(*event))
        return;
    if (event->key() == Qt::Key_Comma || event->key() == Qt::Key_Period)
        return step(event->key() == Qt::Key_Comma ? -1 : 1);
    if (event->key() == Qt::Key_F)
        return frame();
    QWidget::keyPressEvent(event);
}

/// Esc belongs to the drag while there is one, else to the dialog.
bool LandmarkPicture::event(QEvent* event) {
    const bool is_key = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    if (!is_key || !drag_ || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
        return QWidget::event(event);
    event->accept();
    if (event->type() == QEvent::KeyPress) {
        const bool has_moved = drag_->has_moved;
        drag_.reset();
        if (has_moved)
            emit moveCancelled();
    }
    return true;
}

}  // namespace noctule::ui
