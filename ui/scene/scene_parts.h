// SPDX-License-Identifier: Apache-2.0
// What a SceneView is made of; for its own source files only.
#pragma once

#include <QElapsedTimer>
#include <QPointer>
#include <map>
#include <optional>

#include "ui/scene/camera_control.h"
#include "ui/scene/figure_scene.h"
#include "ui/scene/live_scene.h"
#include "ui/scene/scene_canvas.h"
#include "ui/scene/scene_overlay.h"
#include "ui/scene/scene_tools.h"
#include "ui/scene/scene_view.h"
#include "ui/scene/take_scene.h"
#include "ui/widgets/empty_state.h"

namespace noctule::ui {

struct SceneView::Parts {
    Parts(ReviewContext& review, Step of_step)
        : step(of_step), layers(loadLayers(review.shared().settings(), of_step)), take(review) {}

    Step step;
    SceneLayers layers;
    SceneCanvas* canvas = nullptr;  ///< null: no OpenGL
    SceneOverlay* overlay = nullptr;
    SceneTools* tools = nullptr;
    bool beside_other = false;
    int beside_tools_px = 0;  ///< not theirs, at the right end
    EmptyState* message = nullptr;
    CameraControl* control = nullptr;

    TakeScene take;
    std::optional<FigureScene> figure;
    std::optional<LiveScene> live;
    int company = 0;            ///< other performers that are shown live
    QElapsedTimer since_frame;  ///< the live frame came
    struct Asked {
        std::shared_ptr<const LiveFrame> frame;  ///< null: none
        QElapsedTimer since_frame;
        Camera camera;
    };
    std::map<quint64, Asked> asked;              ///< pictures that are not on the screen yet, by number
    std::shared_ptr<const LiveFrame> on_screen;  ///< the live frame shown last
    QString trouble;                             ///< why nothing can be drawn
    LatencyHistogram frame_delays;
    ComposedScene composed;  ///< last

    QString framed;         ///< what the camera has been put in front of: a take's path or the figure
    bool untouched = true;  ///< the operator has not moved the camera since
    std::optional<Vector3d> followed_m;
    std::optional<QPointF> pressed_at;

    ScreenView screen() const { return {control->camera(), control->size(), canvas ? canvas->ratio() : 1.0}; }
    /// Pixels of the surface from those of the widget.
    Eigen::Vector2d onSurface(const QPointF& at) const {
        const double dpr = canvas->devicePixelRatioF();
        return {at.x() * dpr, at.y() * dpr};
    }
};

}  // namespace noctule::ui
