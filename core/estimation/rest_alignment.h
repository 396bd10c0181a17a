// SPDX-License-Identifier: Apache-2.0
// Where performers stand and face while they hold their rest poses, and how their clocks differ, from the
// ranges between them and to the room: nothing on a suit tells either. A least-squares fit from many starts,
// since the problem has several minima; bodies are placed one after the other.
#pragma once

#include <optional>
#include <vector>

#include "core/estimation/joint_distance.h"

namespace noctule {

/// A member at rest. Of a body: in the frame of a root on the floor at the world's origin, heading 0. Of the
/// room: in the world.
struct RestingMember {
    std::vector<Vector3d> sources_m, microphones_m;
    bool is_room = false;
    std::vector<int> housings{};  ///< of the room: per source the board in its housing, -1: none
    double from_s = 0, to_s = 0;  ///< common time within which it is still
    bool clock_known = false;     ///< against the first member, to some microseconds
};

/// Sources and microphones of a body that holds `rest` over the world's origin.
RestingMember restingMember(const KinematicTree& tree, const SuitModel& suit, const Pose& rest);
/// Those of the room; `housings` as in RestingMember.
RestingMember restingRoom(const SuitModel& suit, const std::vector<int>& housings);

struct RestPlace {
    bool placed = false;
    Vector3d p_m = Vector3d::Zero();  ///< on the floor
    double heading_rad = 0;           ///< about the vertical
    double rms_m = 0;                 ///< of the residuals, robust
};

struct RestAlignment {
    std::vector<RestPlace> places;   ///< per member
    std::vector<ClockLine> clocks;   ///< corrected
    std::vector<int> moved_anchors;  ///< boards of the room that contradict the others at rest
    /// Fewer than three anchors agree at rest, so that nobody can tell which of them were moved.
    bool room_contradicts = false;
};

/// `uses_room`: the last member is the room, which fixes the world; else the first body stands at the origin.
/// A member that too few ranges concern stays unplaced.
RestAlignment alignAtRest(const std::vector<RestingMember>& members,
                          const std::vector<JointDistance>& distances, std::vector<ClockLine> clocks,
                          bool uses_room);

}  // namespace noctule
