// SPDX-License-Identifier: Apache-2.0
// Puts a body in a pose with its suit into a scene, in the colours of the theme and as far as layers are
// switched on.
#pragma once

#include <memory>
#include <vector>

#include "core/mesh/retarget/moving_body.h"
#include "core/render/body_scene.h"
#include "core/render/scene.h"
#include "ui/models/shown_body.h"
#include "ui/scene/scene_colors.h"
#include "ui/scene/scene_layers.h"

namespace noctule::ui {

/// The body of a view in the measures of a skeleton; made once for each.
class FittedBody {
public:
    /// An empty one without a body. A mesh that cannot be worn by this skeleton gives way to ours.
    const MovingBody& fit(const BodyLook& look, const Skeleton& skeleton, const FeetAtRest& feet);

private:
    BodyLook look_;
    Skeleton skeleton_;
    FeetAtRest feet_;
    MovingBody fitted_;
};

/// What one pair heard lately.
struct HeardPair {
    int source = 0, board = 0;
    float confidence = 0;
};
/// From here on a pair counts as good, below it its ray is dashed.
inline constexpr float kGoodConfidence = 0.5F;
/// Below this a ray is not drawn.
inline constexpr float kLeastConfidence = 0.2F;

void addRoom(Scene& scene, const SceneColors& colors, const SceneLayers& layers, const Vector3d& centre_m);
/// The soft shadow below a body.
void addShadow(Scene& scene, const SceneColors& colors, const BodyPlaces& places);
void addSurface(Scene& scene, const SceneColors& colors, const MovingBody& body, const Pose& pose,
                Blending blending);
void addGhost(Scene& scene, const SceneColors& colors, const MovingBody& body, const Pose& pose,
              Blending blending);
void addSkeleton(Scene& scene, const SceneColors& colors, const BodyPlaces& places, bool alone);
void addSuit(Scene& scene, const SceneColors& colors, const BodyPlaces& places);
/// `chosen_source`, `chosen_board` (-1: none): rays of the chosen pair, or of the chosen board, stand out.
void addRays(Scene& scene, const BodyPlaces& places, const std::vector<HeardPair>& pairs, int chosen_source,
             int chosen_board);

}  // namespace noctule::ui
