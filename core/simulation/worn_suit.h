// SPDX-License-Identifier: Apache-2.0
// The suit as it really sits on the performer: nominal places plus this take's mounting errors, and how the
// flesh under each board gives way. Hidden truth; the take only knows the nominal suit.
#pragma once

#include <vector>

#include "core/body/actor.h"
#include "core/simulation/coordinates.h"
#include "core/simulation/scenario.h"
#include "core/suit/suit.h"

namespace noctule::simulation {

/// Smooth random function of the angles of two neighbouring joints: zero in the rest pose, each component a
/// sine of a random combination of the angles.
struct PoseShift {
    Eigen::Matrix<double, 3, 6> slope =
        Eigen::Matrix<double, 3,
                      6>::Zero();  ///< of the sines' arguments, per unit of half the sine of an angle
    double bound = 0;              ///< largest length of the result
};

struct WornBoard {
    int segment = -1;  ///< -1: fixed in the room
    Vector3d p_segment_board_m = Vector3d::Zero();
    Quaterniond q_segment_board = Quaterniond::Identity();
    Vector3d p_board_mic_m = Vector3d::Zero();
    Vector3d wobble_axis = Vector3d::UnitX();  ///< the board tilts about axis x displacement
    PoseShift shift_m{}, tilt_rad{};
    double twist_lag = 0;  ///< share of the segment's axial twist that the board misses
};

struct WornSource {
    int segment = -1;
    Vector3d p_segment_source_m = Vector3d::Zero();
    Vector3d normal_segment = Vector3d::UnitZ();
    int board = -1;  ///< in the same housing: it moves with that board, soft tissue included
    Vector3d p_board_source_m = Vector3d::Zero(), normal_board = Vector3d::UnitZ();
};

struct WornSuit {
    std::vector<WornBoard> boards;
    std::vector<WornSource> sources;
};

/// Fails (kUnusable) when the suit names a segment that the skeleton does not have, or when a source sits on
/// another segment than the board of its housing.
Result<WornSuit> wear(const Suit& suit, const Skeleton& skeleton, const Scenario& scenario, uint64_t seed);

/// The actor whose every bone is longer or shorter by scenario.bone_scale.
Actor withScaledBones(const Actor& actor, const Scenario& scenario, uint64_t seed);

/// The rest pose as this performer holds it: every freedom off by scenario.initial_pose_rad, the root level,
/// lowest point on the floor.
std::vector<double> heldRestRow(const Coordinates& coordinates, const Actor& actor, const Scenario& scenario,
                                uint64_t seed);

}  // namespace noctule::simulation
