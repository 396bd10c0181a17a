// SPDX-License-Identifier: Apache-2.0
// The maths of the handles that move and turn a thing along its own axes: their lines, which of them lies
// under a pixel, and where the thing goes when a handle is dragged. Pure.
#pragma once

#include <vector>

#include "core/render/camera.h"
#include "core/render/scene.h"
#include "core/render/screen_shapes.h"

namespace noctule {

std::vector<LineShape> gizmoLines(const SceneGizmo& gizmo, const ScreenView& view);

/// kNone when no handle is within `reach_px` (of the scene, not yet multiplied by the ratio).
GizmoPart gizmoPartAt(const SceneGizmo& gizmo, const ScreenView& view, const Eigen::Vector2d& at_px,
                      double reach_px = 7);

/// The pose of the thing after a handle was dragged from one pixel to another, both counted from the pose at
/// the start of the drag. Unchanged where the drag says nothing (the axis points at the eye).
Eigen::Isometry3d dragGizmo(const Eigen::Isometry3d& T_world_thing, GizmoPart part, const ScreenView& view,
                            const Eigen::Vector2d& from_px, const Eigen::Vector2d& to_px);

}  // namespace noctule
