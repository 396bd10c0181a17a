// SPDX-License-Identifier: Apache-2.0
// Draws scenes in a thread of its own, with one OpenGL context for all views: a driver that compiles shaders,
// uploads a mesh or is a program on the processor holds no interface up. Pictures come back as images.
#pragma once

#include <QImage>
#include <QObject>
#include <QThread>
#include <atomic>
#include <memory>

#include "core/render/renderer.h"

class QOffscreenSurface;

namespace noctule::ui {

class RenderThread : public QObject {
    Q_OBJECT
public:
    struct Wish {
        Scene scene;
        Camera camera;
        PictureSize size;
        int samples = 4;         ///< as RenderOptions
        double pixel_ratio = 1;  ///< likewise
    };

    /// The one of all views, as long as somebody holds it.
    static std::shared_ptr<RenderThread> get();
    ~RenderThread() override;

    /// drawn() follows with the number that this gives.
    quint64 draw(Wish wish);
    /// Waits. Null when OpenGL cannot be used.
    QImage drawNow(Wish wish);
    /// Drawn by the processor; known with the first picture.
    bool isSlow() const { return slow_; }

signals:
    /// `trouble`: why there is no picture, in words.
    void drawn(quint64 number, const QImage& picture, const QString& trouble);

private:
    class Drawing;
    RenderThread();
    Drawing& drawing();
    /// And waits.
    template <class Work>
    void callInside(Work work);

    QThread thread_;
    QObject inside_;  ///< lives in the thread
    std::unique_ptr<QOffscreenSurface> surface_;
    std::unique_ptr<Drawing> drawing_;  ///< of the thread
    std::atomic<bool> slow_ = false;
    quint64 last_number_ = 0;
};

}  // namespace noctule::ui
