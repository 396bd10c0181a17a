// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "core/body/kinematics.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

/// Direction in which the joint's segment extends, in its own frame.
Vector3d boneDirection(const Skeleton& skeleton, int joint) {
    if (skeleton.joint(joint).end_m)
        return *skeleton.joint(joint).end_m;
    for (const Joint& child : skeleton.joints())
        if (child.parent == joint && child.offset_m.norm() > 1e-6)
            return child.offset_m;
    return Vector3d::UnitY();
}

/// Axes of the three hinges that stand for a ball joint. The bone's axis comes last, so that the singularity
/// (second angle at 90 degrees) needs the limb to point sideways.
std::array<Vector3d, 3> eulerAxes(const Vector3d& bone) {
    Eigen::Index longest = 0;
    bone.cwiseAbs().maxCoeff(&longest);
    if (longest == 0)
        return {Vector3d::UnitZ(), Vector3d::UnitY(), Vector3d::UnitX()};
    if (longest == 1)
        return {Vector3d::UnitX(), Vector3d::UnitZ(), Vector3d::UnitY()};
    return {Vector3d::UnitY(), Vector3d::UnitX(), Vector3d::UnitZ()};
}

/// Angles about three mutually perpendicular axes with q = exp(x0 a0) exp(x1 a1) exp(x2 a2).
Vector3d anglesAbout(const std::array<Vector3d, 3>& x, const Quaterniond& q) {
    const Matrix3d R = q.toRotationMatrix();
    const double handed = x[0].cross(x[1]).dot(x[2]);  // +1 for an even order of the axes, -1 for an odd one
    const auto element = [&](int row, int column) {
        return x[static_cast<size_t>(row)].dot(R * x[static_cast<size_t>(column)]);
    };
    const double second = std::asin(std::clamp(handed * element(0, 2), -1.0, 1.0));
    return {std::atan2(-handed * element(1, 2), element(2, 2)), second,
            std::atan2(-handed * element(0, 1), element(0, 0))};
}

}  // namespace

void KinematicTree::addHinge(int parent, int joint, const Vector3d& offset_m, const Vector3d& axis) {
    links_.push_back({parent, joint, LinkType::kHinge, offset_m, axis, freedoms_, 1});
    freedoms_ += 1;
}

KinematicTree::KinematicTree(const Skeleton& skeleton, BallCoordinates balls)
    : skeleton_(skeleton), balls_(balls) {
    for (int j = 0; j < skeleton.size(); ++j) {
        const Joint& joint = skeleton.joint(j);
        const int parent = joint.parent < 0 ? -1 : linkOfJoint(joint.parent);
        const auto next = [&] { return static_cast<int>(links_.size()); };
        if (joint.type == JointType::kUniversal || joint.type == JointType::kHinge) {
            for (size_t d = 0; d < joint.dof.size(); ++d) {
                addHinge(d == 0 ? parent : next() - 1, j, d == 0 ? joint.offset_m : Vector3d::Zero(),
                         joint.dof[d].axis);
                links_.back().min_rad = joint.dof[d].min_rad;
                links_.back().max_rad = joint.dof[d].max_rad;
            }
        } else if (joint.type == JointType::kFixed) {
            links_.push_back({parent, j, LinkType::kFixed, joint.offset_m, Vector3d::UnitX(), freedoms_, 0});
        } else if (balls == BallCoordinates::kManifold) {
            const bool free = joint.type == JointType::kFree;
            links_.push_back({parent, j, free ? LinkType::kFree : LinkType::kBall, joint.offset_m,
                              Vector3d::UnitX(), freedoms_, free ? 6 : 3});
            freedoms_ += links_.back().count;
        } else {
            int above = parent;
            if (joint.type == JointType::kFree) {  // translations alone; its rotation follows as hinges
                links_.push_back(
                    {parent, j, LinkType::kFree, joint.offset_m, Vector3d::UnitX(), freedoms_, 3});
                freedoms_ += 3;
                above = next() - 1;
            }
            const auto axes = eulerAxes(boneDirection(skeleton, j));
            for (size_t d = 0; d < 3; ++d)
                addHinge(d == 0 ? above : next() - 1, j,
                         d == 0 && joint.type == JointType::kBall ? joint.offset_m : Vector3d::Zero(),
                         axes[d]);
        }
        link_of_joint_.push_back(next() - 1);
    }
    for (int i = 0; i < static_cast<int>(links_.size()); ++i) {
        std::vector<int> chain;
        for (int k = i; k >= 0; k = link(k).parent)
            chain.insert(chain.begin(), k);
        chains_.push_back(std::move(chain));
    }
}

MotionState KinematicTree::stateFromPose(const Pose& pose) const {
    require(pose.q_parent_joint.size() == skeleton_.joints().size(), "the pose does not fit the skeleton");
    MotionState state;
    state.p_world_root = pose.p_world_root;
    state.q_parent_link.assign(links_.size(), Quaterniond::Identity());
    state.angle_rad.assign(links_.size(), 0.0);
    state.rate = Eigen::VectorXd::Zero(freedoms_);
    state.accel = Eigen::VectorXd::Zero(freedoms_);
    for (int j = 0; j < skeleton_.size(); ++j) {
        const Joint& joint = skeleton_.joint(j);
        const Quaterniond& q = pose.q_parent_joint[static_cast<size_t>(j)];
        const int last = linkOfJoint(j);
        const auto setHinge = [&](int index, double angle_rad) {
            state.angle_rad[static_cast<size_t>(index)] = angle_rad;
            state.q_parent_link[static_cast<size_t>(index)] = axisAngle(link(index).axis, angle_rad);
        };
        const bool turns_freely = joint.type == JointType::kFree || joint.type == JointType::kBall;
        if (turns_freely && balls_ == BallCoordinates::kEuler) {
            const Vector3d angles =
                anglesAbout({link(last - 2).axis, link(last - 1).axis, link(last).axis}, q);
            for (int d = 0; d < 3; ++d)
                setHinge(last - 2 + d, angles[d]);
        } else if (turns_freely) {
            state.q_parent_link[static_cast<size_t>(last)] = q.normalized();
        } else {
            const JointAngles angles = projectOntoJoint(joint, q, false);
            const int count = static_cast<int>(joint.dof.size());
            for (int d = 0; d < count; ++d)
                setHinge(last - count + 1 + d, angles.angles_rad[d]);
        }
    }
    return state;
}

int KinematicTree::movingLink(int link) const {
    while (this->link(link).count == 0 && this->link(link).parent >= 0)
        link = this->link(link).parent;
    return link;
}

KinematicTree::JointTurn KinematicTree::jointTurn(const MotionState& state, int joint) const {
    JointTurn turn;
    for (int i = linkOfJoint(joint); i >= 0 && link(i).joint == joint; i = link(i).parent) {
        const Link& l = link(i);
        if (l.type == LinkType::kHinge)
            turn.omega_rad_per_s += turn.R_parent_joint.transpose() * (l.axis * state.rate[l.first]);
        else if (l.count >= 3)
            turn.omega_rad_per_s +=
                turn.R_parent_joint.transpose() * state.rate.segment<3>(l.first + l.count - 3);
        turn.R_parent_joint =
            state.q_parent_link[static_cast<size_t>(i)].toRotationMatrix() * turn.R_parent_joint;
    }
    return turn;
}

Pose KinematicTree::poseFromState(const MotionState& state) const {
    Pose pose = skeleton_.zeroPose();
    pose.p_world_root = state.p_world_root;
    for (size_t i = 0; i < links_.size(); ++i) {
        Quaterniond& q = pose.q_parent_joint[static_cast<size_t>(links_[i].joint)];
        q = (q * state.q_parent_link[i]).normalized();
    }
    return pose;
}

void KinematicTree::retractLink(MotionState& state, int index, const double* delta) const {
    const Link& l = link(index);
    const size_t i = static_cast<size_t>(index);
    if (l.type == LinkType::kHinge) {
        state.angle_rad[i] += delta[0];
        state.q_parent_link[i] = axisAngle(l.axis, state.angle_rad[i]);
        return;
    }
    const int rotation = l.type == LinkType::kFree ? 3 : 0;
    if (l.type == LinkType::kFree)
        state.p_world_root += Vector3d(delta[0], delta[1], delta[2]);
    if (l.count - rotation == 3) {
        const Vector3d turn(delta[rotation], delta[rotation + 1], delta[rotation + 2]);
        state.q_parent_link[i] = (state.q_parent_link[i] * expQuaternion(turn)).normalized();
    }
}

void KinematicTree::retract(MotionState& state, const Eigen::VectorXd& delta) const {
    require(delta.size() == freedoms_, "a perturbation has one entry per freedom");
    for (int i = 0; i < static_cast<int>(links_.size()); ++i)
        retractLink(state, i, delta.data() + link(i).first);
}

}  // namespace noctule
