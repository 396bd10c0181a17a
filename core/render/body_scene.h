// SPDX-License-Identifier: Apache-2.0
// Where everything of a dressed body is in one pose: bones, boards, sources, and which pairs heard each other
// near a time. Pure geometry.
#pragma once

#include <optional>
#include <vector>

#include "core/body/skeleton.h"
#include "core/render/scene.h"
#include "core/suit/calibration.h"
#include "core/suit/suit.h"

namespace noctule {

struct BonePlace {
    int joint = 0;  ///< whose segment it is
    Vector3d from_m, to_m;
};
struct BoardPlace {
    Vector3d p_m;
    Quaterniond q_world_board;
};
struct SourcePlace {
    Vector3d p_m, normal;
};

struct BodyPlaces {
    GlobalPose joints;
    std::vector<BonePlace> bones;      ///< from each joint to its children, and to its tip
    std::vector<BoardPlace> boards;    ///< as Suit::boards; on the body or fixed in the world
    std::vector<SourcePlace> sources;  ///< as Suit::sources
    Eigen::AlignedBox3d box() const;   ///< around all joints and tips; empty without joints
};

/// A board or source whose segment the skeleton lacks sits at the root. `calibration` may be null; its
/// corrected mountings replace the suit's.
BodyPlaces placeBody(const Skeleton& skeleton, const Pose& pose, const Suit& suit,
                     const Calibration* calibration);

/// The shadow below a body in this box, not empty: paler and wider the higher it is.
SceneDisc softShadow(const Eigen::AlignedBox3d& box, const Rgba& color);

/// The segment's frame of a board or source: where its placement is measured from. Identity for the world.
Eigen::Isometry3d segmentFrame(const Skeleton& skeleton, const GlobalPose& joints,
                               const std::string& segment);

}  // namespace noctule
