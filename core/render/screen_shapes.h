// SPDX-License-Identifier: Apache-2.0
// From a scene to the few kinds of shapes that the card draws: lines with a width on the screen, and flat
// markers (boards, sources, joints, rings) that are already projected. Pure; `ratio` multiplies all lengths
// that the scene gives in pixels.
#pragma once

#include <array>
#include <vector>

#include "core/render/camera.h"
#include "core/render/scene.h"

namespace noctule {

struct LineShape {
    Eigen::Vector3f from_m, to_m;
    Rgba from_color, to_color;
    float width_px = 1;
    float dash_px = 0;  ///< length of a dash, three quarters of it are the gap; 0: drawn through
};

/// A contour on the screen, filled and edged: every point nearer than `radius_px` to a quadrangle (which may
/// be a line or a point), or an ellipse.
struct MarkerShape {
    Eigen::Vector2f centre_px;                ///< from the top left corner
    float depth = 0;                          ///< of normalised device coordinates
    float distance_m = 0;                     ///< from the eye, for the order of drawing
    std::array<Eigen::Vector2f, 4> corner{};  ///< in px from the centre, y down
    float radius_px = 0;                      ///< > 0: quadrangle; 0: ellipse with the two half axes
    Eigen::Vector2f half_axis_px{0, 0};       ///< of the ellipse: direction and length of the longer one
    float minor_px = 0;                       ///< length of the shorter one
    Rgba fill, edge;
    float edge_px = 0;
};

struct ScreenView {
    Camera camera;
    PictureSize size;
    double ratio = 1;
};

std::vector<LineShape> gridLines(const SceneGrid& grid);
void appendLine(const SceneLine& line, double ratio, std::vector<LineShape>& out);
void appendTrail(const SceneTrail& trail, double ratio, std::vector<LineShape>& out);

/// Boards and sources, the farthest first.
std::vector<MarkerShape> deviceMarkers(const Scene& scene, const ScreenView& view);
std::vector<MarkerShape> jointMarkers(const Scene& scene, const ScreenView& view);
std::vector<MarkerShape> ringMarkers(const Scene& scene, const ScreenView& view);

}  // namespace noctule
