// SPDX-License-Identifier: Apache-2.0
// The suit as the estimator believes it: every board and source on its link of a kinematic tree, with the
// mounting of the calibration in force where it has one.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/body/actor.h"
#include "core/body/kinematics.h"
#include "core/suit/calibration.h"

namespace noctule {

/// BoardFlesh on this body.
struct MountedFlesh {
    std::array<int, 2> joints{-1, -1};  ///< of the skeleton; -1: none
    Vector6 at_rest = Vector6::Zero();  ///< features in the rest pose
    Matrix36 tilt_rad, shift_m;
};

/// Link -1: fixed in the world.
struct MountedBoard {
    int link = -1;
    Vector3d p_link_board = Vector3d::Zero();
    Matrix3d R_link_board = Matrix3d::Identity();
    Vector3d p_link_mic = Vector3d::Zero();
    std::optional<MountedFlesh> flesh = {};
    double rate_hz = kUsualBoardRate_hz;  ///< nominal
    /// Of R_link_board, about the board's axes; zero: known exactly, none: the calibration states nothing.
    std::optional<Vector3d> sigma_mounting_rad = Vector3d::Zero();
};

/// A board where the flesh has taken it; in the link's frame.
struct PlacedBoard {
    Vector3d p_m, p_mic_m;
    Matrix3d R;
    Vector3d omega_rad_per_s;  ///< of the board against the link
};

/// `offset_s` later than the state. Observations take it as given: its derivatives by the joints are left out
/// of their Jacobians (a tilt turns by some hundredths of what the joints turn), and so is the acceleration
/// of its shift.
PlacedBoard placeBoard(const MountedBoard& board, const KinematicTree& tree, const MotionState& state,
                       double offset_s);

struct MountedSource {
    int link = -1;
    Vector3d p_link_source = Vector3d::Zero();
    Vector3d normal_link = Vector3d::UnitZ();
};

struct SuitModel {
    std::vector<MountedBoard> boards;
    std::vector<MountedSource> sources;
};

/// Per link, in its frame, rad^2: covariance of its attitude caused by its boards' mountings. Several boards
/// share what they err by, the rest pose, so their mean is no better than one. `unstated_rad`: standard
/// deviation about each axis where nothing is stated.
std::vector<Matrix3d> mountingCovariances(const SuitModel& suit, const KinematicTree& tree,
                                          double unstated_rad);

/// Fails (kUnusable) and names board or source when a joint of its flesh or a segment is not in the actor's
/// skeleton.
Result<SuitModel> mountSuit(const Suit& suit, const Calibration& calibration, const Actor& actor,
                            const KinematicTree& tree);

}  // namespace noctule
