// SPDX-License-Identifier: Apache-2.0
#include "core/robot/self_collision.h"

#include <algorithm>
#include <limits>
#include <set>

#include "core/math/segment_distance.h"

namespace noctule::robot {
namespace {

/// Parts with fewer moving joints between them touch by their build.
constexpr size_t kNeighbours = 2;

/// Moving joints above a link.
std::vector<int> movingAbove(const RobotModel& model, int link) {
    std::vector<int> above = model.jointsAbove(link);
    std::erase_if(above, [&](int joint) { return !model.joints[static_cast<size_t>(joint)].moves(); });
    return above;
}

size_t movingBetween(const std::vector<int>& a, const std::vector<int>& b) {
    size_t shared = 0;
    while (shared < std::min(a.size(), b.size()) && a[shared] == b[shared])
        ++shared;
    return a.size() + b.size() - 2 * shared;
}

}  // namespace

SelfCollision::SelfCollision(const RobotModel& model, const RobotProfile& profile,
                             const JointValues& reference)
    : model_(model) {
    std::set<int> driven;
    for (const auto& [joint, value] : reference)
        driven.insert(joint);
    std::vector<std::vector<int>> above;
    for (size_t i = 0; i < model.links.size(); ++i) {
        for (const LinkShape& shape : shapesOf(model, i, profile.capsule_radius_m)) {
            parts_.push_back({static_cast<int>(i), shape});
            above.push_back(movingAbove(model, static_cast<int>(i)));
        }
    }
    const auto at_reference = linkPlaces(model, reference);
    const auto isDriven = [&](const std::vector<int>& joints) {
        return std::any_of(joints.begin(), joints.end(), [&](int joint) { return driven.contains(joint); });
    };
    for (size_t a = 0; a < parts_.size(); ++a)
        for (size_t b = a + 1; b < parts_.size(); ++b)
            if ((isDriven(above[a]) || isDriven(above[b])) &&
                movingBetween(above[a], above[b]) > kNeighbours &&
                distance(at_reference, parts_[a], parts_[b]) > profile.clearance_m)
                pairs_.emplace_back(a, b);
}

double SelfCollision::distance(const std::vector<Eigen::Isometry3d>& places, const Part& a,
                               const Part& b) const {
    const Eigen::Isometry3d& A = places[static_cast<size_t>(a.link)];
    const Eigen::Isometry3d& B = places[static_cast<size_t>(b.link)];
    return segmentDistance(A * a.shape.a_m, A * a.shape.b_m, B * b.shape.a_m, B * b.shape.b_m) -
           a.shape.radius_m - b.shape.radius_m;
}

SelfCollision::Nearest SelfCollision::nearest(const JointValues& values) const {
    Nearest nearest{std::numeric_limits<double>::infinity(), -1, -1};
    const auto at = linkPlaces(model_, values);
    for (const auto& [a, b] : pairs_)
        if (const double d = distance(at, parts_[a], parts_[b]); d < nearest.distance_m)
            nearest = {d, parts_[a].link, parts_[b].link};
    return nearest;
}

}  // namespace noctule::robot
