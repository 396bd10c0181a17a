// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/scene_canvas.h"

#include <QOpenGLContext>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/scene/gl_format.h"
#include "ui/style/theme.h"

namespace noctule::ui {

namespace {

constexpr int kFrame_ms = 16;
constexpr int kRest_ms = 180;
constexpr int kSamples = 4;

/// Whether a context can be had, and which version it is.
struct OfferedGl {
    bool made;
    QPair<int, int> version;

    static OfferedGl find() {
        QOpenGLContext context;
        context.setFormat(neededGlFormat());
        const bool made = context.create();
        return {made, context.format().version()};
    }
};

}  // namespace

SceneCanvas::SceneCanvas(Compose compose, std::function<Camera()> camera, QWidget* parent)
    : QWidget(parent),
      compose_(std::move(compose)),
      camera_(std::move(camera)),
      renderer_(RenderThread::get()) {
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    next_.setSingleShot(true);
    rest_.setSingleShot(true);
    rest_.setInterval(kRest_ms);
    connect(&next_, &QTimer::timeout, this, &SceneCanvas::ask);
    connect(&rest_, &QTimer::timeout, this, [this] {
        moving_ = false;
        ask();
    });
    connect(renderer_.get(), &RenderThread::drawn, this, &SceneCanvas::take);
}

QString SceneCanvas::missing() {
    static const OfferedGl offered = OfferedGl::find();
    if (offered.made && offered.version >= qMakePair(3, 3))
        return {};
    const QString found = offered.made ? tr("This computer offers OpenGL %1.%2 only.")
                                             .arg(offered.version.first)
                                             .arg(offered.version.second)
                                       : tr("This computer offers no OpenGL.");
    return tr("The 3D view needs OpenGL 3.3. %1 Install the driver of the graphics card; plots, processing "
              "and export work without it.")
        .arg(found);
}

void SceneCanvas::refresh(bool moving) {
    if (!isVisible())
        return;
    if (moving && renderer_->isSlow()) {
        moving_ = true;
        rest_.start();
    }
    if (next_.isActive())
        return;
    const qint64 since = since_asked_.isValid() ? since_asked_.elapsed() : kFrame_ms;
    next_.start(static_cast<int>(std::clamp<qint64>(kFrame_ms - since, 0, kFrame_ms)));
}

RenderThread::Wish SceneCanvas::wish(double scale, int samples) {
    const PictureSize shown = surfaceSize();
    const PictureSize size{static_cast<int>(std::lround(shown.width_px * scale)),
                           static_cast<int>(std::lround(shown.height_px * scale))};
    const Scene& scene = compose_();  // which may move the camera
    return {scene, camera_(), size, samples, ratio() * scale};
}

void SceneCanvas::ask() {
    wanted_ = asked_for_ != 0;
    if (wanted_ || !isVisible())
        return;
    since_asked_.start();
    last_asked_ = asked_for_ = renderer_->draw(wish(1, moving_ ? 0 : kSamples));
    emit asked(asked_for_);
}

void SceneCanvas::take(quint64 number, const QImage& picture, const QString& trouble) {
    if (number != asked_for_)
        return;
    asked_for_ = 0;
    if (!picture.isNull()) {
        picture_ = picture;
        to_be_shown_ = number;
        emit arrived(number);
        repaint();  // update() would wait for up to 5 ms more
    } else if (!trouble.isEmpty()) {
        emit unavailable(trouble);
    }
    if (wanted_)
        ask();
}

void SceneCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (picture_.isNull())
        painter.fillRect(rect(), Theme::get().tokens().view);
    else
        painter.drawImage(rect(), picture_);
    if (const quint64 number = std::exchange(to_be_shown_, 0))
        QMetaObject::invokeMethod(
            this, [this, number] { emit shown(number); }, Qt::QueuedConnection);
}

/// What is shown again may show something else by then.
void SceneCanvas::hideEvent(QHideEvent*) {
    picture_ = {};
    to_be_shown_ = asked_for_ = 0;
    wanted_ = false;
}

PictureSize SceneCanvas::surfaceSize() const {
    const double dpr = devicePixelRatioF();
    return {std::max(1, static_cast<int>(std::lround(width() * dpr))),
            std::max(1, static_cast<int>(std::lround(height() * dpr)))};
}

double SceneCanvas::ratio() const {
    return devicePixelRatioF() * Theme::get().scale();
}

QImage SceneCanvas::picture(double scale) {
    return renderer_->drawNow(wish(scale, kSamples));
}

}  // namespace noctule::ui
