// SPDX-License-Identifier: Apache-2.0
// The colours of a scene in the present theme.
#pragma once

#include "core/render/scene.h"
#include "ui/style/theme.h"

namespace noctule::ui {

Rgba rgba(const QColor& color, float alpha = 1);

struct SceneColors {
    SceneBackground background;
    Rgba grid, axis_x, axis_y, axis_z;
    Rgba body, ghost, bone, joint, shadow, contact, trail;
    Rgba board_fill, board_edge, source_fill, source_edge, chosen;
    float body_opacity = 1;

    static SceneColors of(const Theme& theme);
    /// Of a body that is no longer followed.
    SceneColors faded() const;
};

}  // namespace noctule::ui
