// SPDX-License-Identifier: Apache-2.0
#include "core/render/shape_painter.h"

#include "core/render/shaders.h"

namespace noctule {

namespace {

/// What is left of lines and markers behind the body's surface.
constexpr float kLinePale = 0.35F, kMarkerPale = 0.45F;
/// Rays end on the skin; this much nearer, it does not hide their ends.
constexpr float kLineInFrontOfSkin_m = 0.03F;

void append(std::vector<float>& values, const Rgba& color) {
    values.insert(values.end(), {color.r, color.g, color.b, color.a});
}
template <class Vector>
void appendVector(std::vector<float>& values, const Vector& v) {
    values.insert(values.end(), v.data(), v.data() + v.size());
}

std::vector<float> packed(const std::vector<SceneDisc>& discs) {
    std::vector<float> values;
    for (const SceneDisc& disc : discs) {
        appendVector(values, disc.centre_m);
        values.insert(values.end(), {disc.radius_x_m, disc.radius_z_m, disc.softness});
        append(values, disc.color);
    }
    return values;
}

std::vector<float> packed(const std::vector<LineShape>& lines) {
    std::vector<float> values;
    values.reserve(lines.size() * 16);
    for (const LineShape& line : lines) {
        appendVector(values, line.from_m);
        appendVector(values, line.to_m);
        append(values, line.from_color);
        append(values, line.to_color);
        values.insert(values.end(), {line.width_px, line.dash_px});
    }
    return values;
}

std::vector<float> packed(const std::vector<MarkerShape>& markers) {
    std::vector<float> values;
    values.reserve(markers.size() * 24);
    for (const MarkerShape& marker : markers) {
        appendVector(values, marker.centre_px);
        values.insert(values.end(), {marker.depth, marker.radius_px});
        for (const Eigen::Vector2f& corner : marker.corner)
            appendVector(values, corner);
        appendVector(values, marker.half_axis_px);
        values.insert(values.end(), {marker.minor_px, marker.edge_px});
        append(values, marker.fill);
        append(values, marker.edge);
    }
    return values;
}

Eigen::Matrix4f viewOf(const ScreenView& view) {
    return view.camera.viewMatrix().cast<float>();
}
Eigen::Matrix4f projectionOf(const ScreenView& view) {
    return view.camera.projectionMatrix(view.size).cast<float>();
}

/// What is visible in full, then what the body hides paler.
void drawHidden(const InstanceBatch& batch, GLint strength, float pale) {
    glUniform1f(strength, pale);
    glDepthFunc(GL_GREATER);
    batch.drawAgain();
    glDepthFunc(GL_LEQUAL);
}

void drawBatch(InstanceBatch& batch, const std::vector<float>& values, GLint strength, Hiding hiding,
               float pale) {
    glUniform1f(strength, 1);
    if (hiding == Hiding::kNone) {
        glDisable(GL_DEPTH_TEST);
        batch.draw(values);
        return;
    }
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    batch.draw(values);
    drawHidden(batch, strength, pale);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace

ShapePainter::ShapePainter()
    : nothing_(makeVertexArray()), discs_({3, 3, 4}), lines_({3, 3, 4, 4, 2}), markers_({4, 4, 4, 4, 4, 4}) {}

Result<std::unique_ptr<ShapePainter>> ShapePainter::create() {
    std::unique_ptr<ShapePainter> painter(new ShapePainter);
    struct Wanted {
        const char *name, *vertex, *fragment;
        GlProgram* program;
    };
    for (const Wanted& wanted :
         {Wanted{"background", shaders::kBackgroundVertex, shaders::kBackgroundFragment,
                 &painter->background_},
          Wanted{"disc", shaders::kDiscVertex, shaders::kDiscFragment, &painter->disc_},
          Wanted{"line", shaders::kLineVertex, shaders::kLineFragment, &painter->line_},
          Wanted{"marker", shaders::kMarkerVertex, shaders::kMarkerFragment, &painter->marker_}}) {
        auto program = GlProgram::link(wanted.name, wanted.vertex, wanted.fragment);
        if (!program)
            return program.error();
        *wanted.program = std::move(*program);
    }
    return painter;
}

void ShapePainter::drawBackground(const SceneBackground& background) {
    background_.use();
    glUniform3f(background_.at("top"), background.top.r, background.top.g, background.top.b);
    glUniform3f(background_.at("bottom"), background.bottom.r, background.bottom.g, background.bottom.b);
    glBindVertexArray(nothing_);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEnable(GL_BLEND);
}

void ShapePainter::drawDiscs(const std::vector<SceneDisc>& discs, const ScreenView& view) {
    if (discs.empty())
        return;
    disc_.use();
    const Eigen::Matrix4f clip_from_world = projectionOf(view) * viewOf(view);
    glUniformMatrix4fv(disc_.at("clip_from_world"), 1, GL_FALSE, clip_from_world.data());
    glDisable(GL_DEPTH_TEST);
    discs_.draw(packed(discs));
}

void ShapePainter::drawLines(const std::vector<LineShape>& lines, const ScreenView& view, Hiding hiding) {
    if (lines.empty())
        return;
    line_.use();
    glUniformMatrix4fv(line_.at("view_from_world"), 1, GL_FALSE, viewOf(view).data());
    glUniformMatrix4fv(line_.at("clip_from_view"), 1, GL_FALSE, projectionOf(view).data());
    glUniform2f(line_.at("size_px"), static_cast<float>(view.size.width_px),
                static_cast<float>(view.size.height_px));
    glUniform1f(line_.at("nearer_m"), kLineInFrontOfSkin_m);
    drawBatch(lines_, packed(lines), line_.at("strength"), hiding, kLinePale);
}

void ShapePainter::drawMarkers(const std::vector<MarkerShape>& markers, const ScreenView& view,
                               Hiding hiding) {
    if (markers.empty())
        return;
    marker_.use();
    glUniform2f(marker_.at("size_px"), static_cast<float>(view.size.width_px),
                static_cast<float>(view.size.height_px));
    drawBatch(markers_, packed(markers), marker_.at("strength"), hiding, kMarkerPale);
}

}  // namespace noctule
