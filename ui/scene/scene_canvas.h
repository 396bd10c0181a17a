// SPDX-License-Identifier: Apache-2.0
// The picture of a 3D view. It asks for the scene at most 60 times a second, never while hidden and never
// before the last picture is there, and has it drawn in another thread. On a software renderer the edges of
// bodies are smoothed only while the picture stands still.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>

#include "ui/scene/render_thread.h"

namespace noctule::ui {

class SceneCanvas : public QWidget {
    Q_OBJECT
public:
    using Compose = std::function<const Scene&()>;

    SceneCanvas(Compose compose, std::function<Camera()> camera, QWidget* parent);

    /// What is missing, in words, before any canvas is made; empty when OpenGL can be used.
    static QString missing();

    /// Soon; `moving`: more will follow.
    void refresh(bool moving);
    /// The present scene at `scale` times its size on the screen, without what lies on top.
    QImage picture(double scale);
    /// In pixels of the surface.
    PictureSize surfaceSize() const;
    /// Pixels of the surface for one pixel of the style guide.
    double ratio() const;

signals:
    /// A new picture is there and about to be shown.
    void painted();
    /// It is on the screen.
    void shown();
    void unavailable(const QString& message);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    RenderThread::Wish wish(double scale, int samples);
    void ask();
    void take(quint64 number, const QImage& picture, const QString& trouble);

    Compose compose_;
    std::function<Camera()> camera_;
    std::shared_ptr<RenderThread> renderer_;
    QImage picture_;
    quint64 asked_for_ = 0;     ///< 0: nothing is being drawn
    bool wanted_ = false;       ///< another picture, once this one is there
    bool moving_ = false;       ///< since the last picture at rest
    bool to_be_shown_ = false;  ///< the picture has not been on the screen yet
    QTimer next_, rest_;
    QElapsedTimer since_asked_;
};

}  // namespace noctule::ui
