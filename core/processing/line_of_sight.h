// SPDX-License-Identifier: Apache-2.0
// Whether a pose explains that a board did not hear a source: the source faces away, or the body (its
// capsules) stands between. For reports only; no estimator knows it.
#pragma once

#include <vector>

#include "core/body/actor.h"
#include "core/suit/calibration.h"
#include "core/suit/suit.h"

namespace noctule {

class LineOfSight {
public:
    /// Boards sit where the calibration says, else where the suit does. Parts on segments that the actor does
    /// not have count as seen by all.
    LineOfSight(const Suit& suit, const Calibration& calibration, const Actor& actor);

    void setPose(const Pose& pose);
    /// In the pose set last.
    bool isBlocked(int source, int board) const;

private:
    struct Place {
        int segment = -1;  ///< -1: fixed in the world
        bool known = true;
        Vector3d p_segment_m = Vector3d::Zero(), normal_segment = Vector3d::Zero();
        Vector3d p_world_m = Vector3d::Zero(), normal_world = Vector3d::Zero();
    };
    struct PlacedCapsule {
        int segment = -1;
        Vector3d a_segment_m, b_segment_m;
        double radius_m = 0;
        Vector3d a_world_m = Vector3d::Zero(), b_world_m = Vector3d::Zero();
    };
    Place placeOn(const std::string& segment, const Vector3d& p_segment_m, const Vector3d& normal) const;

    Skeleton skeleton_;
    std::vector<Place> sources_, microphones_;
    std::vector<PlacedCapsule> capsules_;
};

}  // namespace noctule
