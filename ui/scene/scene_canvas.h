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
    /// Nothing is being drawn, wanted or about to be shown.
    bool isUpToDate() const {
        return asked_for_ == 0 && !next_.isActive() && !rest_.isActive() && !to_be_shown_;
    }
    /// The number of the picture that was asked for last.
    quint64 lastAsked() const { return last_asked_; }

signals:
    /// The scene has been composed and is being drawn.
    void asked(quint64 number);
    /// The picture is there and about to be shown.
    void arrived(quint64 number);
    /// It is on the screen.
    void shown(quint64 number);
    void unavailable(const QString& message);

protected:
    void paintEvent(QPaintEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    RenderThread::Wish wish(double scale, int samples);
    void ask();
    void take(quint64 number, const QImage& picture, const QString& trouble);

    Compose compose_;
    std::function<Camera()> camera_;
    std::shared_ptr<RenderThread> renderer_;
    QImage picture_;
    quint64 asked_for_ = 0;  ///< 0: nothing is being drawn
    quint64 last_asked_ = 0;
    bool wanted_ = false;      ///< another picture, once this one is there
    bool moving_ = false;      ///< since the last picture at rest
    quint64 to_be_shown_ = 0;  ///< the picture, if it has not been on the screen yet
    QTimer next_, rest_;
    QElapsedTimer since_asked_;
};

}  // namespace noctule::ui
