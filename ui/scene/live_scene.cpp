// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/live_scene.h"

namespace noctule::ui {
namespace {

/// Three rounds of eight sources: one pulse may be missed.
constexpr double kHeardFor_s = 0.2;

}  // namespace

void LiveScene::addPairs(ComposedScene& composed) const {
    const int sources = static_cast<int>(composed.places.sources.size());
    const int boards = static_cast<int>(composed.places.boards.size());
    composed.pair_count = sources * boards;
    const auto oldest = frame_->sample - static_cast<int64_t>(kHeardFor_s * wearer_.sample_rate_hz);
    for (const std::optional<RangeMeasurement>& range : frame_->ranges)
        if (range && range->pulse_sample >= oldest && range->source < sources && range->board < boards)
            composed.pairs.push_back({range->source, range->board, static_cast<float>(range->confidence())});
}

ComposedScene LiveScene::compose(Studio& studio, const SceneLayers& layers) {
    const SceneColors colors = SceneColors::of(Theme::get());
    ComposedScene composed;
    Scene& scene = composed.scene;
    const bool has_pose = frame_ && frame_->pose && frame_->pose->pose && wearer_.calibration;
    addRoom(scene, colors, layers, has_pose ? frame_->pose->pose->p_world_root : Vector3d::Zero());
    if (!has_pose)
        return composed;
    const Skeleton& skeleton = wearer_.actor.skeleton;
    composed.places = placeBody(skeleton, *frame_->pose->pose, wearer_.suit, &*wearer_.calibration);
    addShadow(scene, colors, composed.places);
    const BodyLook look = studio.look();
    const bool has_mesh = layers.has(SceneLayer::kMesh) && (look.ours || look.worn);
    if (has_mesh)
        addSurface(scene, colors, body_.fit(look, skeleton, feetAtRest(skeleton)), *frame_->pose->pose,
                   look.blending);
    if (layers.has(SceneLayer::kSkeleton))
        addSkeleton(scene, colors, composed.places, !has_mesh);
    addPairs(composed);
    if (layers.has(SceneLayer::kRays))
        addRays(scene, composed.places, composed.pairs, studio.selection().source(),
                studio.selection().board());
    if (layers.has(SceneLayer::kBoards))
        addSuit(scene, colors, composed.places);
    return composed;
}

}  // namespace noctule::ui
