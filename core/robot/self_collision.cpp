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

std::vector<LinkShape> linesToJoints(const RobotModel& model, const RobotLink& link, double radius_m) {
    std::vector<LinkShape> lines;
    for (const int child : link.child_joints) {
        const RobotJoint& joint = model.joints[static_cast<size_t>(child)];
        if (joint.moves() && joint.T_parent_joint.translation().norm() > radius_m)
            lines.push_back({Vector3d::Zero(), joint.T_parent_joint.translation(), radius_m});
    }
    return lines;
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
        const RobotLink& link = model.links[i];
        const auto shapes =
            link.shapes.empty() ? linesToJoints(model, link, profile.capsule_radius_m) : link.shapes;
        for (const LinkShape& shape : shapes) {
            parts_.push_back({static_cast<int>(i), shape});
            above.push_back(movingAbove(model, static_cast<int>(i)));
        }
    }
    const auto at_reference = places(reference);
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

std::vector<Eigen::Isometry3d> SelfCollision::places(const JointValues& values) const {
    std::vector<Eigen::Isometry3d> places(model_.links.size(), Eigen::Isometry3d::Identity());
    const auto valueOf = [&](int joint) {
        const auto found = values.find(joint);
        return found == values.end() ? 0 : found->second;
    };
    for (size_t i = 1; i < model_.links.size(); ++i) {
        const int index = model_.links[i].parent_joint;
        const RobotJoint& joint = model_.joints[static_cast<size_t>(index)];
        Eigen::Isometry3d T = places[static_cast<size_t>(joint.parent_link)] * joint.T_parent_joint;
        const double value = joint.mimic
                                 ? joint.mimic->factor * valueOf(joint.mimic->joint) + joint.mimic->offset
                                 : valueOf(index);
        if (joint.kind == JointKind::kPrismatic)
            T.translate(joint.axis * value);
        else if (joint.moves())
            T.rotate(Eigen::AngleAxisd(value, joint.axis));
        places[i] = T;
    }
    return places;
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
    const auto at = places(values);
    for (const auto& [a, b] : pairs_)
        if (const double d = distance(at, parts_[a], parts_[b]); d < nearest.distance_m)
            nearest = {d, parts_[a].link, parts_[b].link};
    return nearest;
}

}  // namespace noctule::robot
