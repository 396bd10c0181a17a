// SPDX-License-Identifier: Apache-2.0
#include "core/processing/line_of_sight.h"

#include <algorithm>

#include "core/math/segment_distance.h"
#include "core/suit/placed_suit.h"

namespace noctule {
namespace {

constexpr double kSkin_m = 0.005;  ///< parts lie on the flesh, or a little in it

double pointDistance(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
    return segmentDistance(p, p, a, b);
}

}  // namespace

LineOfSight::LineOfSight(const Suit& suit, const Calibration& calibration, const Actor& actor)
    : skeleton_(actor.skeleton) {
    const Suit placed = placedSuit(suit, calibration);
    for (const Source& source : placed.sources)
        sources_.push_back(placeOn(source.segment, source.p_segment_source_m, source.normal_segment));
    for (const Board& board : placed.boards)
        microphones_.push_back(placeOn(board.segment,
                                       board.p_segment_board_m + board.q_segment_board * board.p_board_mic_m,
                                       Vector3d::Zero()));
    for (const Capsule& capsule : actor.capsules)
        if (const int segment = skeleton_.find(capsule.segment); segment >= 0)
            capsules_.push_back({segment, capsule.a_m, capsule.b_m, capsule.radius_m});
}

LineOfSight::Place LineOfSight::placeOn(const std::string& segment, const Vector3d& p_segment_m,
                                        const Vector3d& normal) const {
    Place place;
    place.segment = segment.empty() ? -1 : skeleton_.find(segment);
    place.known = segment.empty() || place.segment >= 0;
    place.p_segment_m = place.p_world_m = p_segment_m;
    place.normal_segment = place.normal_world = normal;
    return place;
}

void LineOfSight::setPose(const Pose& pose) {
    const GlobalPose global = globalPose(skeleton_, pose);
    const auto toWorld = [&](int segment, const Vector3d& p_m) -> Vector3d {
        const auto j = static_cast<size_t>(segment);
        return global.p_world_joint[j] + global.q_world_joint[j] * p_m;
    };
    for (std::vector<Place>* places : {&sources_, &microphones_})
        for (Place& place : *places)
            if (place.segment >= 0) {
                place.p_world_m = toWorld(place.segment, place.p_segment_m);
                place.normal_world =
                    global.q_world_joint[static_cast<size_t>(place.segment)] * place.normal_segment;
            }
    for (PlacedCapsule& capsule : capsules_) {
        capsule.a_world_m = toWorld(capsule.segment, capsule.a_segment_m);
        capsule.b_world_m = toWorld(capsule.segment, capsule.b_segment_m);
    }
}

bool LineOfSight::isBlocked(int source, int board) const {
    const Place& from = sources_[static_cast<size_t>(source)];
    const Place& to = microphones_[static_cast<size_t>(board)];
    if (!from.known || !to.known)
        return false;
    if (from.normal_world.dot(to.p_world_m - from.p_world_m) <= 0)
        return true;
    return std::any_of(capsules_.begin(), capsules_.end(), [&](const PlacedCapsule& capsule) {
        const double distance =
            segmentDistance(from.p_world_m, to.p_world_m, capsule.a_world_m, capsule.b_world_m);
        if (distance >= capsule.radius_m)
            return false;
        // A capsule ends where source or microphone sits on it.
        const double nearest = std::min(pointDistance(from.p_world_m, capsule.a_world_m, capsule.b_world_m),
                                        pointDistance(to.p_world_m, capsule.a_world_m, capsule.b_world_m));
        return distance < nearest - kSkin_m;
    });
}

}  // namespace noctule
