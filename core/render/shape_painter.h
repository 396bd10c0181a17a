// SPDX-License-Identifier: Apache-2.0
// Draws the background, patches on the ground, lines and markers into the framebuffer that is bound. Blending
// is on; nothing here writes depth.
#pragma once

#include <memory>
#include <vector>

#include "core/render/instance_batch.h"
#include "core/render/screen_shapes.h"

namespace noctule {

/// How shapes and the bodies before them meet.
enum class Hiding {
    kNone,  ///< in front of everything
    kPale,  ///< shines through the body, paler
};

class ShapePainter {
public:
    static Result<std::unique_ptr<ShapePainter>> create();

    void drawBackground(const SceneBackground& background);
    void drawDiscs(const std::vector<SceneDisc>& discs, const ScreenView& view);
    void drawLines(const std::vector<LineShape>& lines, const ScreenView& view, Hiding hiding);
    void drawMarkers(const std::vector<MarkerShape>& markers, const ScreenView& view, Hiding hiding);

private:
    ShapePainter();

    GlProgram background_, disc_, line_, marker_;
    GlVertexArray nothing_;
    InstanceBatch discs_, lines_, markers_;
};

}  // namespace noctule
