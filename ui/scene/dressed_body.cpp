// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/dressed_body.h"

#include <algorithm>

namespace noctule::ui {

namespace {

bool sameMeasures(const Skeleton& a, const Skeleton& b) {
    return std::equal(a.joints().begin(), a.joints().end(), b.joints().begin(), b.joints().end(),
                      [](const Joint& x, const Joint& y) {
                          return x.name == y.name && x.parent == y.parent && x.offset_m == y.offset_m &&
                                 x.end_m == y.end_m;
                      });
}

bool isPicked(const HeardPair& pair, int source, int board) {
    const bool of_source = source < 0 || pair.source == source, of_board = board < 0 || pair.board == board;
    return (source >= 0 || board >= 0) && of_source && of_board;
}

}  // namespace

const MovingBody& FittedBody::fit(const BodyLook& look, const Skeleton& skeleton, const FeetAtRest& feet) {
    const bool same = look.ours == look_.ours && look.worn == look_.worn && feet == feet_ &&
                      sameMeasures(skeleton, skeleton_);
    look_ = look;
    if (same)
        return fitted_;
    skeleton_ = skeleton;
    feet_ = feet;
    if (look.worn)
        if (auto worn = MovingBody::of(look.worn, skeleton, feet))
            return fitted_ = std::move(*worn);
    return fitted_ = look.ours ? MovingBody::ofOurs(*look.ours, skeleton, feet) : MovingBody();
}

void addRoom(Scene& scene, const SceneColors& colors, const SceneLayers& layers, const Vector3d& centre_m) {
    scene.background = colors.background;
    if (!layers.has(SceneLayer::kGrid))
        return;
    SceneGrid grid;
    grid.centre_m = centre_m.cast<float>();
    grid.line = colors.grid;
    grid.axis_x = colors.axis_x;
    grid.axis_z = colors.axis_z;
    scene.grid = grid;
}

void addShadow(Scene& scene, const SceneColors& colors, const BodyPlaces& places) {
    if (const Eigen::AlignedBox3d box = places.box(); !box.isEmpty())
        scene.discs.push_back(softShadow(box, colors.shadow));
}

void addSurface(Scene& scene, const SceneColors& colors, const MovingBody& body, const Pose& pose,
                Blending blending) {
    if (!body.mesh())
        return;
    SceneBody drawn;
    drawn.mesh = body.mesh();
    drawn.skin = body.skinMatrices(pose);
    drawn.blending = blending;
    drawn.color = colors.body;
    drawn.opacity = colors.body_opacity;
    scene.bodies.push_back(std::move(drawn));
}

void addGhost(Scene& scene, const SceneColors& colors, const MovingBody& body, const Pose& pose,
              Blending blending) {
    if (!body.mesh())
        return;
    SceneBody ghost;
    ghost.mesh = body.mesh();
    ghost.skin = body.skinMatrices(pose);
    ghost.blending = blending;
    ghost.color = colors.ghost;
    ghost.style = BodyStyle::kOutline;
    ghost.outline_px = 1.4F;
    scene.bodies.push_back(std::move(ghost));
}

void addSkeleton(Scene& scene, const SceneColors& colors, const BodyPlaces& places, bool alone) {
    // Without a mesh around it the skeleton is the picture.
    const float strength = alone ? 2.2F : 1;
    const auto stronger = [&](Rgba color) {
        return Rgba{color.r, color.g, color.b, std::min(1.0F, color.a * strength)};
    };
    for (const BonePlace& bone : places.bones)
        scene.bones.push_back({bone.from_m.cast<float>(), bone.to_m.cast<float>(), stronger(colors.bone),
                               alone ? 2.5F : 1.2F, false});
    for (const Vector3d& p : places.joints.p_world_joint)
        scene.joints.push_back({p.cast<float>(), alone ? 3.5F : 2.0F, stronger(colors.joint)});
}

void addSuit(Scene& scene, const SceneColors& colors, const BodyPlaces& places) {
    for (const BoardPlace& place : places.boards) {
        SceneBoard board;
        board.p_m = place.p_m.cast<float>();
        board.q_world_board = place.q_world_board.cast<float>();
        board.fill = colors.board_fill;
        board.edge = colors.board_edge;
        scene.boards.push_back(board);
    }
    for (const SourcePlace& place : places.sources) {
        SceneSource source;
        source.p_m = place.p_m.cast<float>();
        source.normal = place.normal.cast<float>();
        source.fill = colors.source_fill;
        source.edge = colors.source_edge;
        scene.sources.push_back(source);
    }
}

void addRays(Scene& scene, const BodyPlaces& places, const std::vector<HeardPair>& pairs, int chosen_source,
             int chosen_board) {
    const Theme& theme = Theme::get();
    for (const HeardPair& pair : pairs) {
        if (pair.confidence < kLeastConfidence)
            continue;
        const bool picked = isPicked(pair, chosen_source, chosen_board);
        const bool other_picked = (chosen_source >= 0 || chosen_board >= 0) && !picked;
        const float strength = (0.25F + 0.7F * pair.confidence) * (other_picked ? 0.55F : 1);
        SceneLine ray;
        ray.from_m = places.sources[static_cast<size_t>(pair.source)].p_m.cast<float>();
        ray.to_m = places.boards[static_cast<size_t>(pair.board)].p_m.cast<float>();
        ray.color = rgba(theme.confidence(pair.confidence), picked ? 1 : strength);
        ray.width_px = 0.7F + pair.confidence + (picked ? 0.8F : 0);
        ray.dashed = pair.confidence < kGoodConfidence;
        scene.rays.push_back(ray);
    }
    // Certain ones last, on top of the rest.
    std::stable_sort(scene.rays.begin(), scene.rays.end(),
                     [](const auto& a, const auto& b) { return a.color.a < b.color.a; });
}

}  // namespace noctule::ui
