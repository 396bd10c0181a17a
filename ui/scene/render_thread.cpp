// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/render_thread.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>

#include "ui/language/core_words.h"
#include "ui/scene/gl_format.h"

namespace noctule::ui {

namespace {

bool isSoftware(const std::string& description) {
    const auto has = [&](const char* word) { return description.find(word) != std::string::npos; };
    return has("llvmpipe") || has("softpipe") || has("SWR") || has("Software");
}

}  // namespace

/// Context, renderer and target; made, used and destroyed in the thread.
class RenderThread::Drawing {
public:
    explicit Drawing(QOffscreenSurface& surface) : surface_(surface) {
        context_.setFormat(neededGlFormat());
        if (!context_.create() || !context_.makeCurrent(&surface_)) {
            trouble_ = RenderThread::tr("The 3D view cannot be drawn: no OpenGL context could be made.");
            return;
        }
        auto renderer = Renderer::create();
        if (renderer)
            renderer_ = std::move(*renderer);
        else
            trouble_ = coreWords(renderer.error());
    }
    ~Drawing() {
        context_.makeCurrent(&surface_);
        target_.reset();
        renderer_.reset();
        context_.doneCurrent();
    }

    const QString& trouble() const { return trouble_; }
    /// The driver has started anew; another drawing may do.
    bool isLost() const { return renderer_ && !context_.isValid(); }
    bool isSlow() const { return renderer_ && isSoftware(renderer_->description()); }

    QImage draw(const Wish& wish) {
        if (!renderer_ || !context_.makeCurrent(&surface_))
            return {};
        const QSize size(wish.size.width_px, wish.size.height_px);
        if (!target_ || target_->size() != size)
            target_ = std::make_unique<QOpenGLFramebufferObject>(size);
        renderer_->draw(wish.scene, wish.camera, wish.size,
                        {wish.samples, wish.pixel_ratio, target_->handle()});
        QImage picture = target_->toImage();
        picture.reinterpretAsFormat(QImage::Format_RGB32);
        return picture;
    }

private:
    QOffscreenSurface& surface_;
    QOpenGLContext context_;
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<QOpenGLFramebufferObject> target_;
    QString trouble_;
};

std::shared_ptr<RenderThread> RenderThread::get() {
    static std::weak_ptr<RenderThread> the_one;
    std::shared_ptr<RenderThread> held = the_one.lock();
    if (!held)
        the_one = held = std::shared_ptr<RenderThread>(new RenderThread);
    return held;
}

RenderThread::RenderThread() : surface_(std::make_unique<QOffscreenSurface>()) {
    surface_->setFormat(neededGlFormat());
    surface_->create();
    if (QOpenGLContext::supportsThreadedOpenGL())  // some old drivers do not: then in the interface's own
        inside_.moveToThread(&thread_);
    thread_.setObjectName(QStringLiteral("render"));
    thread_.start();
}

template <class Work>
void RenderThread::callInside(Work work) {
    if (QThread::currentThread() == inside_.thread())
        work();
    else
        QMetaObject::invokeMethod(&inside_, work, Qt::BlockingQueuedConnection);
}

RenderThread::~RenderThread() {
    callInside([this] { drawing_.reset(); });
    thread_.quit();
    thread_.wait();
}

RenderThread::Drawing& RenderThread::drawing() {
    if (!drawing_ || drawing_->isLost()) {
        drawing_ = std::make_unique<Drawing>(*surface_);
        slow_ = drawing_->isSlow();
    }
    return *drawing_;
}

quint64 RenderThread::draw(Wish wish) {
    const quint64 number = ++last_number_;
    QMetaObject::invokeMethod(
        &inside_,
        [this, number, wish = std::move(wish)] {
            const QImage picture = drawing().draw(wish);
            emit drawn(number, picture, drawing().trouble());
        },
        Qt::QueuedConnection);
    return number;
}

QImage RenderThread::drawNow(Wish wish) {
    QImage picture;
    callInside([&] { picture = drawing().draw(wish); });
    return picture;
}

}  // namespace noctule::ui
