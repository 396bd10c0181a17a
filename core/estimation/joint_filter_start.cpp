// SPDX-License-Identifier: Apache-2.0
// How a joint filter begins: places, headings and clocks from the rest pose, then its ranges as measurements.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "core/estimation/joint_filter.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kRoomSourceOffset_m = 0.0008;
constexpr double kFarOff_m = 0.15;          ///< at rest: an echo
constexpr double kDoubtfulAtRest_m = 0.01;  ///< where a rest pose is not quite the one asked for

}  // namespace

std::vector<RestingMember> JointFilter::restingMembers() const {
    constexpr double kAtLeast_s = 0.5;  // nobody moves at once
    std::vector<RestingMember> members;
    for (size_t i = 0; i < bodies_.size(); ++i) {
        const Body& body = bodies_[i];
        RestingMember member = restingMember(body.tree, body.made_of.suit, *body.rest_pose);
        const ClockLine& clock = alignment_.clocks[i];
        member.from_s = clock.common_s(body.rest.begin_s);
        member.to_s = clock.common_s(std::max(body.rest.end_s, body.rest.begin_s + kAtLeast_s));
        member.clock_known = i == 0 || body.made_of.clock_known || parameters_.clocks_shared;
        members.push_back(std::move(member));
    }
    RestingMember room =
        restingRoom(room_ ? room_->suit : SuitModel{}, room_ ? room_->housings : std::vector<int>{});
    room.clock_known = room_ && (room_->clock_known || parameters_.clocks_shared);
    members.push_back(std::move(room));
    return members;
}

void JointFilter::begin() {
    begun_ = true;
    const std::vector<RestingMember> members = restingMembers();
    alignment_ = alignAtRest(members, distances_, alignment_.clocks, room_.has_value());
    for (size_t i = 0; i < bodies_.size(); ++i)
        bodies_[i].joined = alignment_.places[i].placed;
    for (const int anchor : alignment_.moved_anchors)
        anchors_[anchor] = {.off_share = 1, .moved = true};
    order_.resize(distances_.size());
    std::iota(order_.begin(), order_.end(), size_t{0});
    const auto arrives_s = [&](size_t index) {
        const JointDistance& distance = distances_[index];
        return alignment_.clocks[static_cast<size_t>(distance.to)].common_s(distance.arrival_s);
    };
    std::ranges::stable_sort(order_, {}, arrives_s);
    startBodies();
    useRest();
}

void JointFilter::startBodies() {
    Eigen::VectorXd variance = Eigen::VectorXd::Zero(common_.size());
    const auto set = [&](int first, int count, double sigma) {
        if (first >= 0)
            variance.segment(first, count).setConstant(sigma * sigma);
    };
    for (const int at : clock_at_) {
        set(at, 1, parameters_.unknown_clock_m);
        set(at < 0 ? at : at + 1, 1, parameters_.unknown_rate_m_per_s);
    }
    for (const int at : board_at_)
        set(at, 3, parameters_.anchor_m);
    for (const int at : source_at_)
        set(at, 3, parameters_.anchor_m);
    for (const int at : source_offset_at_)
        set(at, 1, kRoomSourceOffset_m);
    std::vector<ManifoldFilter*> filters;
    for (size_t i = 0; i < bodies_.size(); ++i) {
        Body& body = bodies_[i];
        Pose pose = *body.rest_pose;
        const RestPlace& place = alignment_.places[i];
        const Quaterniond turn(axisAngle(Vector3d::UnitY(), place.heading_rad));
        pose.p_world_root = place.p_m + turn * pose.p_world_root;
        pose.q_parent_joint[0] = turn * pose.q_parent_joint[0];
        body.filter->start(pose, body.rest, nullptr);
        body.poses = body.filter->takePoses();
        if (body.joined && (room_ || i > 0))
            body.filter->loosenRoot(parameters_.unknown_place_m, parameters_.unknown_heading_rad);
        filters.push_back(body.filter.get());
        common_s_ = i == 0 ? now_s(i) : std::min(common_s_, now_s(i));
    }
    covariance_ = JointCovariance(std::move(filters), variance);
}

/// Ranges of the rest pose, one mean per pair and half second.
void JointFilter::useRest() {
    constexpr double kBin_s = 0.5;
    const std::vector<RestingMember> still = restingMembers();
    struct Mean {
        JointDistance distance;
        double error_m = 0, count = 0, time_s = 0;
    };
    std::map<std::array<int, 5>, Mean> means;
    for (const JointDistance& distance : distances_) {
        const auto from = static_cast<size_t>(distance.from), to = static_cast<size_t>(distance.to);
        const double emitted_s = alignment_.clocks[from].common_s(distance.emission_s);
        const auto within = [&](size_t member) {
            return member == room() || (bodies_[member].joined && emitted_s >= still[member].from_s &&
                                        emitted_s <= still[member].to_s);
        };
        if (!isJoined(distance) || isMoved(anchorOf(distance)) || !within(from) || !within(to) ||
            distance.confidence < kLeastConfidence)
            continue;
        const auto bin = static_cast<int>(std::floor((emitted_s - common_s_) / kBin_s));
        Mean& mean = means[{distance.from, distance.source, distance.to, distance.board, bin}];
        if (mean.count == 0)
            mean.distance = distance;
        mean.count += 1;
        mean.error_m += (distance.distance_m(alignment_.clocks) -
                         mean.distance.distance_m(alignment_.clocks) - mean.error_m) /
                        mean.count;
        mean.time_s += (emitted_s - mean.time_s) / mean.count;
    }
    std::set<int> seen;
    for (const auto& [pair, mean] : means)
        seen.insert(pair[4]);
    const auto bins = static_cast<double>(seen.size());  // the means of a pair share what is lasting
    std::vector<JointRow> rows;
    for (auto& [pair, mean] : means) {
        JointDistance distance = mean.distance;
        distance.beyond_m += mean.error_m;
        JointDecision decision;
        // The bodies are still: sent and heard at the state's time.
        const auto timed = [&](int member) {
            return static_cast<size_t>(member) == room() ? 0 : filter(static_cast<size_t>(member)).seconds();
        };
        const double measured_m = distance.distance_m(alignment_.clocks);
        distance.emission_s = timed(distance.from);
        distance.arrival_s = timed(distance.to);
        distance.beyond_m += measured_m - distance.distance_m(alignment_.clocks);
        auto row = rowOf(distance, mean.time_s - common_s_, decision);
        if (!row || std::abs(row->residual) > kFarOff_m)
            continue;
        row->variance = (row->variance + std::pow(kDoubtfulAtRest_m, 2)) * bins;
        rows.push_back(std::move(*row));
    }
    common_ += covariance_.update(std::move(rows));
}

}  // namespace noctule
