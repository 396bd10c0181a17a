// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/scene_canvas.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <algorithm>
#include <cmath>

#include "ui/style/theme.h"

namespace noctule::ui {

namespace {

constexpr int kFrame_ms = 16;
constexpr int kRest_ms = 180;
constexpr int kSamples = 4;

QSurfaceFormat neededFormat() {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setVersion(3, 3);
    return format;
}

bool isSoftware(const std::string& description) {
    const auto has = [&](const char* word) { return description.find(word) != std::string::npos; };
    return has("llvmpipe") || has("softpipe") || has("SWR") || has("Software");
}

}  // namespace

SceneCanvas::SceneCanvas(Compose compose, std::function<Camera()> camera, QWidget* parent)
    : QOpenGLWidget(parent), compose_(std::move(compose)), camera_(std::move(camera)) {
    setFormat(neededFormat());
    setMouseTracking(true);
    repaint_.setSingleShot(true);
    rest_.setSingleShot(true);
    rest_.setInterval(kRest_ms);
    connect(&repaint_, &QTimer::timeout, this, QOverload<>::of(&QWidget::update));
    connect(&rest_, &QTimer::timeout, this, [this] {
        moving_ = false;
        update();
    });
}

SceneCanvas::~SceneCanvas() {
    release();
}

QString SceneCanvas::missing() {
    QOpenGLContext context;
    context.setFormat(neededFormat());
    const bool made = context.create();
    const auto version = context.format().version();
    if (made && version >= qMakePair(3, 3))
        return {};
    const QString offered =
        made ? tr("This computer offers OpenGL %1.%2 only.").arg(version.first).arg(version.second)
             : tr("This computer offers no OpenGL.");
    return tr("The 3D view needs OpenGL 3.3. %1 Install the driver of the graphics card; plots, processing "
              "and "
              "export work without it.")
        .arg(offered);
}

void SceneCanvas::refresh(bool moving) {
    if (!isVisible())
        return;
    if (moving && slow_) {
        moving_ = true;
        rest_.start();
    }
    if (repaint_.isActive())
        return;
    const qint64 since = since_paint_.isValid() ? since_paint_.elapsed() : kFrame_ms;
    repaint_.start(static_cast<int>(std::clamp<qint64>(kFrame_ms - since, 0, kFrame_ms)));
}

PictureSize SceneCanvas::surfaceSize() const {
    const double dpr = devicePixelRatioF();
    return {std::max(1, static_cast<int>(std::lround(width() * dpr))),
            std::max(1, static_cast<int>(std::lround(height() * dpr)))};
}

double SceneCanvas::ratio() const {
    return devicePixelRatioF() * Theme::get().scale();
}

void SceneCanvas::initializeGL() {
    // A dock that floats gets a new window and with it a new context.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &SceneCanvas::release,
            Qt::UniqueConnection);
    auto renderer = Renderer::create();
    if (!renderer) {
        emit unavailable(QString::fromStdString(renderer.error().text()));
        return;
    }
    renderer_ = std::move(*renderer);
    slow_ = isSoftware(renderer_->description());
}

void SceneCanvas::paintGL() {
    if (!renderer_)
        return;
    since_paint_.start();
    const Scene& scene = compose_();
    renderer_->draw(scene, camera_(), surfaceSize(),
                    {moving_ ? 0 : kSamples, ratio(), defaultFramebufferObject()});
    emit painted();
}

QImage SceneCanvas::picture(double scale) {
    if (!renderer_)
        return {};
    const PictureSize shown = surfaceSize();
    const PictureSize size{static_cast<int>(std::lround(shown.width_px * scale)),
                           static_cast<int>(std::lround(shown.height_px * scale))};
    makeCurrent();
    QOpenGLFramebufferObject target(size.width_px, size.height_px);
    renderer_->draw(compose_(), camera_(), size, {kSamples, ratio() * scale, target.handle()});
    QImage image = target.toImage().convertToFormat(QImage::Format_RGB32);
    target.release();
    doneCurrent();
    return image;
}

void SceneCanvas::release() {
    if (!renderer_)
        return;
    makeCurrent();
    renderer_.reset();
    doneCurrent();
}

}  // namespace noctule::ui
