// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/scene_colors.h"

namespace noctule::ui {

namespace {

Rgba mixed(const QColor& a, const QColor& b, float fraction) {
    const Rgba x = rgba(a), y = rgba(b);
    return {x.r + fraction * (y.r - x.r), x.g + fraction * (y.g - x.g), x.b + fraction * (y.b - x.b), 1};
}

}  // namespace

Rgba rgba(const QColor& color, float alpha) {
    return {static_cast<float>(color.redF()), static_cast<float>(color.greenF()),
            static_cast<float>(color.blueF()), static_cast<float>(color.alphaF()) * alpha};
}

SceneColors SceneColors::of(const Theme& theme) {
    const Tokens& tokens = theme.tokens();
    const bool dark = theme.isDark();
    SceneColors colors;
    colors.background = {rgba(tokens.view),
                         dark ? mixed(tokens.view, tokens.view2, 0.5F) : rgba(tokens.view2)};
    colors.grid = rgba(tokens.grid, dark ? 0.9F : 0.8F);
    colors.axis_x = rgba(tokens.x, 0.45F);
    colors.axis_y = rgba(tokens.y);
    colors.axis_z = rgba(tokens.z, 0.45F);
    colors.body = mixed(tokens.edge, tokens.t1, dark ? 0.22F : 0.0F);
    if (!dark)
        colors.body = mixed(tokens.edge, tokens.raised, 0.42F);
    colors.body_opacity = 0.86F;
    colors.ghost = rgba(tokens.ref, dark ? 0.9F : 0.8F);
    colors.bone = rgba(tokens.t1, dark ? 0.28F : 0.38F);
    colors.joint = rgba(tokens.t1, dark ? 0.4F : 0.5F);
    colors.shadow = {0, 0, 0, dark ? 0.55F : 0.16F};
    colors.contact = rgba(tokens.acc, 0.55F);
    colors.trail = rgba(tokens.acc, 0.8F);
    colors.board_fill = dark ? rgba(tokens.bg) : rgba(tokens.t1);
    colors.board_edge = dark ? rgba(tokens.t1) : rgba(tokens.raised);
    colors.source_fill = colors.board_fill;
    colors.source_edge = rgba(tokens.acc);
    colors.chosen = rgba(tokens.warn);
    return colors;
}

SceneColors SceneColors::faded() const {
    constexpr float kLeft = 0.35F;
    SceneColors colors = *this;
    colors.body_opacity *= kLeft;
    for (Rgba* color : {&colors.bone, &colors.joint, &colors.shadow, &colors.board_fill, &colors.board_edge,
                        &colors.source_fill, &colors.source_edge})
        color->a *= kLeft;
    return colors;
}

}  // namespace noctule::ui
