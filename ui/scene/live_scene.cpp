// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/live_scene.h"

#include <algorithm>

namespace noctule::ui {
namespace {

/// Three rounds of eight sources: one pulse may be missed.
constexpr double kHeardFor_s = 0.2;

constexpr double kLetterOverHead_m = 0.32;

/// Before the first one, where its own stream has it or where it was reset to; each next one further to the
/// side.
Pose inRow(const TimedPose& shown, const FloorMove& floor, int performer) {
    Pose pose = movedOnFloor(*shown.pose, floor);
    pose.p_world_root.x() += LiveScene::kApart_m * performer;
    return pose;
}

Vector3d letterPlace(const BodyPlaces& places) {
    const std::vector<Vector3d>& joints = places.joints.p_world_joint;
    return *std::ranges::max_element(joints, {}, [](const Vector3d& p_m) { return p_m.y(); }) +
           kLetterOverHead_m * Vector3d::UnitY();
}

bool hasPose(const LiveWearer& wearer, const std::shared_ptr<const LiveFrame>& frame) {
    return frame && frame->pose && frame->pose->pose && wearer.calibration;
}

}  // namespace

void LiveScene::setCompany(int performer, std::vector<LiveCompanion> others) {
    performer_ = others.empty() ? 0 : performer;
    others_ = std::move(others);
    bodies_.resize(others_.size());
}

void LiveScene::addOther(ComposedScene& composed, const LiveCompanion& other, size_t index,
                         ReviewContext& review, const SceneLayers& layers, const SceneColors& in_view) {
    if (!hasPose(other.wearer, other.frame))
        return;
    const SceneColors colors = other.is_lost ? in_view.faded() : in_view;
    const Skeleton& skeleton = other.wearer.actor.skeleton;
    const Pose pose = inRow(*other.frame->pose, other.floor, other.performer);
    const BodyPlaces places = placeBody(skeleton, pose, other.wearer.suit, &*other.wearer.calibration);
    const BodyLook look = review.shared().look();
    const bool has_mesh = layers.has(SceneLayer::kMesh) && (look.ours || look.worn);
    addShadow(composed.scene, colors, places);
    if (has_mesh)
        addSurface(composed.scene, colors, bodies_[index].fit(look, skeleton, feetAtRest(skeleton)), pose,
                   look.blending);
    if (layers.has(SceneLayer::kSkeleton))
        addSkeleton(composed.scene, colors, places, !has_mesh);
    composed.tags.push_back({other.performer, letterPlace(places)});
    composed.others.extend(places.box());
}

void LiveScene::addPairs(ComposedScene& composed) const {
    const int sources = static_cast<int>(composed.places.sources.size());
    const int boards = static_cast<int>(composed.places.boards.size());
    composed.pair_count = sources * boards;
    if (is_lost_)
        return;
    const auto oldest = frame_->sample - static_cast<int64_t>(kHeardFor_s * wearer_.sample_rate_hz);
    for (const std::optional<RangeMeasurement>& range : frame_->ranges)
        if (range && range->pulse_sample >= oldest && range->source < sources && range->board < boards)
            composed.pairs.push_back({range->source, range->board, static_cast<float>(range->confidence())});
}

ComposedScene LiveScene::compose(ReviewContext& review, const SceneLayers& layers) {
    const SceneColors in_view = SceneColors::of(Theme::get());
    const SceneColors colors = is_lost_ ? in_view.faded() : in_view;
    ComposedScene composed;
    Scene& scene = composed.scene;
    const bool has_pose = hasPose(wearer_, frame_);
    const Pose pose = has_pose ? inRow(*frame_->pose, floor_, performer_) : Pose{};
    addRoom(scene, in_view, layers, has_pose ? pose.p_world_root : Vector3d::Zero());
    for (size_t i = 0; i < others_.size(); ++i)
        addOther(composed, others_[i], i, review, layers, in_view);
    if (!has_pose)
        return composed;
    const Skeleton& skeleton = wearer_.actor.skeleton;
    composed.places = placeBody(skeleton, pose, wearer_.suit, &*wearer_.calibration);
    if (isInCompany())
        composed.tags.push_back({performer_, letterPlace(composed.places)});
    addShadow(scene, colors, composed.places);
    const BodyLook look = review.shared().look();
    const bool has_mesh = layers.has(SceneLayer::kMesh) && (look.ours || look.worn);
    if (has_mesh)
        addSurface(scene, colors, body_.fit(look, skeleton, feetAtRest(skeleton)), pose, look.blending);
    if (layers.has(SceneLayer::kSkeleton))
        addSkeleton(scene, colors, composed.places, !has_mesh);
    addPairs(composed);
    if (layers.has(SceneLayer::kRays))
        addRays(scene, composed.places, composed.pairs, review.selection().source(),
                review.selection().board());
    if (layers.has(SceneLayer::kBoards))
        addSuit(scene, colors, composed.places);
    return composed;
}

}  // namespace noctule::ui
