// SPDX-License-Identifier: Apache-2.0
#include "ui/scene/figure_scene.h"

#include "core/math/rotation.h"

namespace noctule::ui {

namespace {

/// How far a source's axis is drawn, so that its direction can be seen.
constexpr double kAxis_m = 0.05;

Quaterniond fromNormal(const Vector3d& normal) {
    return smallestRotation(Vector3d::UnitZ(), normal);
}

}  // namespace

FigureScene::FigureScene(Actor actor, Suit suit) {
    setFigure(std::move(actor), std::move(suit));
}

void FigureScene::setFigure(Actor actor, Suit suit) {
    actor_ = std::move(actor);
    suit_ = std::move(suit);
    rest_ = actor_.restPose();
    places_ = placeBody(actor_.skeleton, rest_, suit_, nullptr);
    choose(chosen_);
}

void FigureScene::choose(SuitPart part) {
    const size_t count = part.kind == SuitPart::Kind::kBoard    ? suit_.boards.size()
                         : part.kind == SuitPart::Kind::kSource ? suit_.sources.size()
                                                                : 0;
    const bool is_there = part.index >= 0 && static_cast<size_t>(part.index) < count;
    if (!is_there || !(part == chosen_))
        drag_.reset();
    chosen_ = is_there ? part : SuitPart{};
}

const std::string& FigureScene::segmentOf(SuitPart part) const {
    const auto index = static_cast<size_t>(part.index);
    return part.kind == SuitPart::Kind::kBoard ? suit_.boards[index].segment : suit_.sources[index].segment;
}

Eigen::Isometry3d FigureScene::worldPose(SuitPart part) const {
    const auto index = static_cast<size_t>(part.index);
    Eigen::Isometry3d T_segment_thing = Eigen::Isometry3d::Identity();
    if (part.kind == SuitPart::Kind::kBoard) {
        T_segment_thing.linear() = suit_.boards[index].q_segment_board.toRotationMatrix();
        T_segment_thing.translation() = suit_.boards[index].p_segment_board_m;
    } else {
        T_segment_thing.linear() = fromNormal(suit_.sources[index].normal_segment).toRotationMatrix();
        T_segment_thing.translation() = suit_.sources[index].p_segment_source_m;
    }
    return segmentFrame(actor_.skeleton, places_.joints, segmentOf(part)) * T_segment_thing;
}

PartPlacement FigureScene::place(const Eigen::Isometry3d& T_world_thing) {
    const auto index = static_cast<size_t>(chosen_.index);
    const Eigen::Isometry3d T_segment_thing =
        segmentFrame(actor_.skeleton, places_.joints, segmentOf(chosen_)).inverse() * T_world_thing;
    const PartPlacement placement{T_segment_thing.translation(),
                                  Quaterniond(T_segment_thing.linear()).normalized()};
    if (chosen_.kind == SuitPart::Kind::kBoard) {
        suit_.boards[index].p_segment_board_m = placement.p_segment_m;
        suit_.boards[index].q_segment_board = placement.q_segment;
    } else {
        suit_.sources[index].p_segment_source_m = placement.p_segment_m;
        suit_.sources[index].normal_segment = placement.q_segment * Vector3d::UnitZ();
    }
    places_ = placeBody(actor_.skeleton, rest_, suit_, nullptr);
    return placement;
}

std::optional<SceneGizmo> FigureScene::gizmo() const {
    if (chosen_.kind == SuitPart::Kind::kNone)
        return std::nullopt;
    const Tokens& tokens = Theme::get().tokens();
    const Eigen::Isometry3d T_world_thing = worldPose(chosen_);
    SceneGizmo gizmo;
    gizmo.p_m = T_world_thing.translation().cast<float>();
    gizmo.q_world_thing = Quaterniond(T_world_thing.linear()).cast<float>();
    gizmo.x = rgba(tokens.x);
    gizmo.y = rgba(tokens.y);
    gizmo.z = rgba(tokens.z);
    gizmo.active = rgba(tokens.t1);
    gizmo.hot = drag_ ? drag_->part : hot_;
    return gizmo;
}

ComposedScene FigureScene::compose(const SceneLayers& layers,
                                   const std::shared_ptr<const SkinnedMesh>& body) {
    const SceneColors colors = SceneColors::of(Theme::get());
    ComposedScene composed;
    composed.places = places_;
    Scene& scene = composed.scene;
    addRoom(scene, colors, layers, Vector3d::Zero());
    addShadow(scene, colors, places_);
    if (layers.has(SceneLayer::kMesh))
        addSurface(scene, colors, body_.fit({body, nullptr}, actor_.skeleton, feetAtRest(actor_.skeleton)),
                   rest_, Blending::kLinear);
    if (layers.has(SceneLayer::kSkeleton))
        addSkeleton(scene, colors, places_, scene.bodies.empty());
    if (layers.has(SceneLayer::kBoards)) {
        addSuit(scene, colors, places_);
        for (const SourcePlace& source : places_.sources)
            scene.rays.push_back({source.p_m.cast<float>(),
                                  (source.p_m + kAxis_m * source.normal.normalized()).cast<float>(),
                                  colors.source_edge.faded(0.7F), 1.3F, false});
    }
    scene.gizmo = gizmo();
    return composed;
}

GizmoPart FigureScene::hover(const ScreenView& view, const Eigen::Vector2d& at_px) {
    const auto shown = gizmo();
    hot_ = shown ? gizmoPartAt(*shown, view, at_px) : GizmoPart::kNone;
    return hot_;
}

bool FigureScene::beginDrag(const ScreenView& view, const Eigen::Vector2d& at_px) {
    const GizmoPart part = hover(view, at_px);
    if (part == GizmoPart::kNone)
        return false;
    drag_ = Drag{part, worldPose(chosen_), at_px};
    return true;
}

PartPlacement FigureScene::dragTo(const ScreenView& view, const Eigen::Vector2d& at_px) {
    return place(dragGizmo(drag_->T_world_thing, drag_->part, view, drag_->from_px, at_px));
}

void FigureScene::endDrag() {
    drag_.reset();
}

PartPlacement FigureScene::nudge(const Camera& camera, double right_m, double up_m) {
    Eigen::Isometry3d T_world_thing = worldPose(chosen_);
    T_world_thing.translation() += camera.axes() * Vector3d(right_m, up_m, 0);
    return place(T_world_thing);
}

}  // namespace noctule::ui
