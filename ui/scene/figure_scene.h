// SPDX-License-Identifier: Apache-2.0
// A performer in the rest pose whose boards and sources can be chosen, dragged by handles and nudged.
#pragma once

#include <optional>

#include "core/body/actor.h"
#include "core/render/gizmo.h"
#include "ui/scene/suit_part.h"
#include "ui/scene/take_scene.h"

namespace noctule::ui {

/// Where a part sits, in its segment's frame. Of a source the rotation turns +Z onto its normal.
struct PartPlacement {
    Vector3d p_segment_m = Vector3d::Zero();
    Quaterniond q_segment = Quaterniond::Identity();
};

class FigureScene {
public:
    FigureScene(Actor actor, Suit suit);

    void setFigure(Actor actor, Suit suit);
    const Suit& suit() const { return suit_; }

    SuitPart chosen() const { return chosen_; }
    void choose(SuitPart part);

    ComposedScene compose(const SceneLayers& layers, const std::shared_ptr<const SkinnedMesh>& body);

    /// Handle under the pixel; it is shown as active.
    GizmoPart hover(const ScreenView& view, const Eigen::Vector2d& at_px);
    /// True when a handle was taken.
    bool beginDrag(const ScreenView& view, const Eigen::Vector2d& at_px);
    bool isDragging() const { return drag_.has_value(); }
    PartPlacement dragTo(const ScreenView& view, const Eigen::Vector2d& at_px);
    void endDrag();
    /// Moves the chosen part along the picture.
    PartPlacement nudge(const Camera& camera, double right_m, double up_m);

private:
    struct Drag {
        GizmoPart part;
        Eigen::Isometry3d T_world_thing;
        Eigen::Vector2d from_px;
    };
    const std::string& segmentOf(SuitPart part) const;
    Eigen::Isometry3d worldPose(SuitPart part) const;
    PartPlacement place(const Eigen::Isometry3d& T_world_thing);
    std::optional<SceneGizmo> gizmo() const;

    Actor actor_;
    Suit suit_;
    Pose rest_;
    BodyPlaces places_;
    FittedBody body_;
    SuitPart chosen_;
    GizmoPart hot_ = GizmoPart::kNone;
    std::optional<Drag> drag_;
};

}  // namespace noctule::ui
