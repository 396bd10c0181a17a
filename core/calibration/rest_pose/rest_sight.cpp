// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/rest_pose/rest_sight.h"

#include <algorithm>
#include <cmath>

#include "core/math/segment_distance.h"

namespace noctule {
namespace {

constexpr double kSurely_m = 0.02;                           // deep in the flesh
constexpr double kSurelyFacing = 0.2, kSurelyBehind = -0.1;  // cosine to the source's axis
constexpr double kHeardWell = 0.4;                           // confidence
constexpr double kEcho_m = 0.15;  // later than the rest pose allows: not the direct way
constexpr double kSurprise = 3;   // one pair in five is heard otherwise than its line of sight says

/// How deep the line between two points dips into the body; negative outside.
double depthInBody_m(const Actor& actor, const GlobalPose& rest, const Vector3d& from_m,
                     const Vector3d& to_m) {
    double depth_m = -1;
    for (const Capsule& capsule : actor.capsules) {
        const int joint = actor.skeleton.find(capsule.segment);
        if (joint < 0)
            continue;
        const Vector3d& p = rest.p_world_joint[static_cast<size_t>(joint)];
        const Quaterniond& q = rest.q_world_joint[static_cast<size_t>(joint)];
        depth_m = std::max(depth_m, capsule.radius_m - segmentDistance(from_m, to_m, p + q * capsule.a_m,
                                                                       p + q * capsule.b_m));
    }
    return depth_m;
}

}  // namespace

RestSight::RestSight(const Observations& take, const StillStretch& still, const RestEvidenceMaker& maker) {
    const size_t sources = take.suit.sources.size(), boards = take.suit.boards.size();
    ways_.assign(sources, std::vector<Way>(boards));
    distance_m_.assign(sources, std::vector<double>(boards, 0));
    source_heard_.assign(sources, false);
    stream_heard_.assign(boards, false);
    const RestPriors priors = priorsOf(take, false);
    const GlobalPose rest = globalPose(take.actor.skeleton, take.actor.restPose());
    for (size_t s = 0; s < sources; ++s)
        for (size_t b = 0; b < boards; ++b) {
            const int on_source = priors.sources[s].joint, on_board = priors.boards[b].joint;
            if (on_source < 0 || on_board < 0)
                continue;
            const auto from = static_cast<size_t>(on_source), to = static_cast<size_t>(on_board);
            const Vector3d source_m =
                rest.p_world_joint[from] + rest.q_world_joint[from] * priors.sources[s].p_segment_source_m;
            const Vector3d mic_m =
                rest.p_world_joint[to] + rest.q_world_joint[to] * priors.boards[b].p_segment_mic_m;
            const double depth_m = depthInBody_m(take.actor, rest, source_m, mic_m);
            const double facing = (mic_m - source_m)
                                      .normalized()
                                      .dot(rest.q_world_joint[from] * take.suit.sources[s].normal_segment);
            Way& way = ways_[s][b];
            way.distance_m = (mic_m - source_m).norm();
            if (depth_m > kSurely_m || facing < kSurelyBehind)
                way.sight = Sight::kBlocked;
            else if (depth_m < 0 && facing > kSurelyFacing)
                way.sight = Sight::kClear;
        }
    for (const StillFlight& flight : still.flights) {
        const auto s = static_cast<size_t>(flight.source), b = static_cast<size_t>(flight.board);
        source_heard_[s] = stream_heard_[b] = true;
        if (flight.confidence > kHeardWell)
            distance_m_[s][b] = maker.distance_m(flight, flight.board).value_or(0);
    }
}

double RestSight::cost(const Arrangement& arrangement) const {
    double cost = 0;
    for (size_t s = 0; s < ways_.size(); ++s)
        for (size_t place = 0; source_heard_[s] && place < arrangement.size(); ++place) {
            const auto stream = static_cast<size_t>(arrangement[place].stream);
            const Way& way = ways_[s][place];
            if (!stream_heard_[stream] || way.sight == Sight::kUnsure)
                continue;
            const double distance_m = distance_m_[s][stream];
            const bool heard = distance_m > 0 && distance_m < way.distance_m + kEcho_m;
            if (heard != (way.sight == Sight::kClear))
                cost += kSurprise;
        }
    return cost;
}

}  // namespace noctule
