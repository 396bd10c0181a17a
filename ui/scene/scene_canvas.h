// SPDX-License-Identifier: Apache-2.0
// The OpenGL surface of a 3D view. It asks for the scene when it paints, at most 60 times a second, and never
// while hidden. On a software renderer the edges of bodies are smoothed only while the picture stands still.
#pragma once

#include <QElapsedTimer>
#include <QOpenGLWidget>
#include <QTimer>
#include <functional>
#include <memory>

#include "core/render/renderer.h"

namespace noctule::ui {

class SceneCanvas : public QOpenGLWidget {
    Q_OBJECT
public:
    using Compose = std::function<const Scene&()>;

    SceneCanvas(Compose compose, std::function<Camera()> camera, QWidget* parent);
    ~SceneCanvas() override;

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
    void painted();
    void unavailable(const QString& message);

protected:
    void initializeGL() override;
    void paintGL() override;

private:
    void release();

    Compose compose_;
    std::function<Camera()> camera_;
    std::unique_ptr<Renderer> renderer_;
    bool slow_ = false;    ///< drawn by the processor
    bool moving_ = false;  ///< since the last picture at rest
    QTimer repaint_, rest_;
    QElapsedTimer since_paint_;
};

}  // namespace noctule::ui
