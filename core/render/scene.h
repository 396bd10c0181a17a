// SPDX-License-Identifier: Apache-2.0
// One picture of a body in its room as plain values: what there is to see, in which colours. Metres in the
// world of math/conventions.h; widths and sizes on the screen in pixels of the picture. Colours are sRGB, not
// premultiplied. Empty lists and hidden parts are simply not drawn.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

#include "core/mesh/skinning.h"

namespace noctule {

struct Rgba {
    float r = 0, g = 0, b = 0, a = 1;

    Rgba faded(float factor) const { return {r, g, b, a * factor}; }
    bool operator==(const Rgba&) const = default;
};

/// Vertical gradient behind everything; opaque.
struct SceneBackground {
    Rgba top, bottom;
};

/// Lines on y = 0 around a centre that fade out with the distance from it.
struct SceneGrid {
    Eigen::Vector3f centre_m = Eigen::Vector3f::Zero();  ///< rounded to whole steps
    float step_m = 0.5F;
    float radius_m = 5;
    Rgba line;
    Rgba axis_x, axis_z;  ///< the lines through the world's origin
};

enum class BodyStyle {
    kSolid,    ///< shaded surface
    kOutline,  ///< only its contours: the ghost of another motion; seen through solid bodies
};

/// A mesh in a pose. The mesh is uploaded once and recognised by its pointer.
struct SceneBody {
    std::shared_ptr<const SkinnedMesh> mesh;
    std::vector<Eigen::Matrix4f> skin;  ///< per bone, from skinMatrices()
    Blending blending = Blending::kLinear;
    Rgba color;
    float opacity = 1;  ///< below 1 the ground shows through; of the body only the nearest surface
    BodyStyle style = BodyStyle::kSolid;
    float outline_px = 1.5F;  ///< kOutline only
};

/// A straight line; dashes are measured along the line on the screen.
struct SceneLine {
    Eigen::Vector3f from_m = Eigen::Vector3f::Zero(), to_m = Eigen::Vector3f::Zero();
    Rgba color;
    float width_px = 1;
    bool dashed = false;
};

/// A joint, as a disc that faces the viewer.
struct SceneJoint {
    Eigen::Vector3f p_m = Eigen::Vector3f::Zero();
    float radius_px = 2.5F;
    Rgba color;
};

/// Where a point has been, oldest first; fades towards the oldest.
struct SceneTrail {
    std::vector<Eigen::Vector3f> points_m;
    Rgba color;
    float width_px = 1.5F;
};

/// A small box with rounded contour. Never smaller on the screen than `min_px` along its longest edge.
struct SceneBoard {
    Eigen::Vector3f p_m = Eigen::Vector3f::Zero();
    Eigen::Quaternionf q_world_board = Eigen::Quaternionf::Identity();
    Eigen::Vector3f size_m{0.030F, 0.022F, 0.009F};
    Rgba fill, edge;
    float edge_px = 1.5F;
    float min_px = 10;
};

/// A round transducer that faces along its normal.
struct SceneSource {
    Eigen::Vector3f p_m = Eigen::Vector3f::Zero();
    Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();
    float radius_m = 0.009F;
    Rgba fill, edge;
    float edge_px = 1.5F;
    float min_px = 9;  ///< diameter
};

/// A round patch on the ground: a foot's contact (softness 0) or a soft shadow (1).
struct SceneDisc {
    Eigen::Vector3f centre_m = Eigen::Vector3f::Zero();
    float radius_x_m = 0.1F, radius_z_m = 0.1F;
    Rgba color;
    float softness = 0;
};

/// A circle around something that is pointed out, in front of everything.
struct SceneRing {
    Eigen::Vector3f p_m = Eigen::Vector3f::Zero();
    float radius_px = 11, width_px = 2;
    Rgba color;
};

enum class GizmoPart { kNone, kMoveX, kMoveY, kMoveZ, kTurnX, kTurnY, kTurnZ };

/// Handles that move and turn a thing along its own axes, in front of everything.
struct SceneGizmo {
    Eigen::Vector3f p_m = Eigen::Vector3f::Zero();
    Eigen::Quaternionf q_world_thing = Eigen::Quaternionf::Identity();
    float size_px = 72;  ///< length of an arrow; rings are a little smaller
    Rgba x, y, z, active;
    GizmoPart hot = GizmoPart::kNone;  ///< drawn in `active`
    bool turns = true;                 ///< whether there are rings
};

struct Scene {
    SceneBackground background;
    std::optional<SceneGrid> grid;
    std::vector<SceneDisc> discs;
    std::vector<SceneBody> bodies;
    std::vector<SceneLine> bones;
    std::vector<SceneJoint> joints;
    std::vector<SceneTrail> trails;
    std::vector<SceneLine> rays;
    std::vector<SceneBoard> boards;
    std::vector<SceneSource> sources;
    std::vector<SceneRing> rings;
    std::optional<SceneGizmo> gizmo;
};

}  // namespace noctule
