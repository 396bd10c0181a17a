// SPDX-License-Identifier: Apache-2.0
// The suit as the estimator believes it: every board and source on its link of a kinematic tree, with the
// mounting of the calibration in force where it has one.
#pragma once

#include <vector>

#include "core/body/actor.h"
#include "core/body/kinematics.h"
#include "core/suit/calibration.h"

namespace noctule {

/// Link -1: fixed in the world.
struct MountedBoard {
    int link = -1;
    Vector3d p_link_board = Vector3d::Zero();
    Matrix3d R_link_board = Matrix3d::Identity();
    Vector3d p_link_mic = Vector3d::Zero();
};

struct MountedSource {
    int link = -1;
    Vector3d p_link_source = Vector3d::Zero();
    Vector3d normal_link = Vector3d::UnitZ();
};

struct SuitModel {
    std::vector<MountedBoard> boards;
    std::vector<MountedSource> sources;
};

/// Fails (kUnusable) and names board or source when a segment is not in the actor's skeleton.
Result<SuitModel> mountSuit(const Suit& suit, const Calibration& calibration, const Actor& actor,
                            const KinematicTree& tree);

}  // namespace noctule
