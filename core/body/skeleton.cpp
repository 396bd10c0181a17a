// SPDX-License-Identifier: Apache-2.0
#include "core/body/skeleton.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/math/rotation.h"

namespace noctule {
namespace {

size_t freedomsOf(JointType type) {
    switch (type) {
        case JointType::kBall:
            return 3;
        case JointType::kUniversal:
            return 2;
        case JointType::kHinge:
            return 1;
        case JointType::kFree:
        case JointType::kFixed:
            return 0;
    }
    return 0;
}

Error unusable(const std::string& message, const std::string& remedy) {
    return {ErrorKind::kUnusable, message, remedy};
}

Status checkJoint(const Joint& joint, int index) {
    const std::string name = "joint " + joint.name;
    if (joint.name.empty())
        return unusable("joint number " + std::to_string(index) + " has no name", "Give every joint a name");
    if (index == 0 ? joint.parent != -1 : (joint.parent < 0 || joint.parent >= index))
        return unusable(name + ": its parent " + std::to_string(joint.parent) + " does not come before it",
                        "List parents first; only joint 0 has parent -1");
    if (index > 0 && joint.type == JointType::kFree)
        return unusable(name + " is free but not the root", "Only joint 0 may be free");
    if (!joint.offset_m.allFinite() || (joint.end_m && !joint.end_m->allFinite()))
        return unusable(name + ": an offset is not a finite number", "Correct the joint's offset");
    if (joint.dof.size() != freedomsOf(joint.type))
        return unusable(
            name + " lists " + std::to_string(joint.dof.size()) + " freedoms, which does not fit its type",
            "Ball joints have three, universal two, hinges one, free and fixed none");
    for (const DegreeOfFreedom& dof : joint.dof) {
        if (!dof.axis.allFinite() || std::abs(dof.axis.norm() - 1) > 1e-6)
            return unusable(name + ": the axis of " + dof.name + " is not a unit vector", "Correct the axis");
        if (!(dof.min_rad <= dof.max_rad))
            return unusable(name + ": the limits of " + dof.name + " are reversed", "Correct the limits");
    }
    return Done{};
}

double clampTo(const DegreeOfFreedom& dof, double angle_rad, bool apply_limits) {
    return apply_limits ? std::clamp(angle_rad, dof.min_rad, dof.max_rad) : angle_rad;
}

/// Angle of the rotation about `axis` that is nearest to q (the twist of q).
double twistAngle(const Quaterniond& q, const Vector3d& axis) {
    const double angle = 2 * std::atan2(q.vec().dot(axis), q.w());
    return std::remainder(angle, 2 * std::numbers::pi);
}

/// exp(x0 a0) exp(x1 a1) nearest to q: with p = q rotated into the axes, maximise |<q, q0(a0) q1(a1)>|.
/// For fixed a1 the best a0 is the twist of q q1^-1 and vice versa; the alternation converges in a few rounds
/// because each half-step is the exact optimum.
Eigen::Vector2d universalAngles(const Quaterniond& q, const Vector3d& x0, const Vector3d& x1) {
    Eigen::Vector2d angles(twistAngle(q, x0), 0);
    for (int round = 0; round < 60; ++round) {
        const double second = twistAngle(axisAngle(x0, angles[0]).conjugate() * q, x1);
        const double first = twistAngle(q * axisAngle(x1, second).conjugate(), x0);
        const double change = std::abs(first - angles[0]) + std::abs(second - angles[1]);
        angles = {first, second};
        if (change < 1e-13)
            break;
    }
    return angles;
}

}  // namespace

Result<Skeleton> Skeleton::make(std::vector<Joint> joints) {
    if (joints.empty())
        return unusable("the skeleton has no joints", "Describe at least the root");
    std::set<std::string> names;
    for (size_t i = 0; i < joints.size(); ++i) {
        Status checked = checkJoint(joints[i], static_cast<int>(i));
        if (!checked)
            return checked.error();
        if (!names.insert(joints[i].name).second)
            return unusable("two joints are named " + joints[i].name, "Give every joint its own name");
    }
    Skeleton skeleton;
    skeleton.joints_ = std::move(joints);
    return skeleton;
}

int Skeleton::find(const std::string& name) const {
    const auto found =
        std::find_if(joints_.begin(), joints_.end(), [&](const Joint& j) { return j.name == name; });
    return found == joints_.end() ? -1 : static_cast<int>(found - joints_.begin());
}

Pose Skeleton::zeroPose() const {
    return {Vector3d::Zero(), std::vector<Quaterniond>(joints_.size(), Quaterniond::Identity())};
}

GlobalPose globalPose(const Skeleton& skeleton, const Pose& pose) {
    require(pose.q_parent_joint.size() == skeleton.joints().size(), "the pose does not fit the skeleton");
    GlobalPose global;
    global.p_world_joint.reserve(skeleton.joints().size());
    global.q_world_joint.reserve(skeleton.joints().size());
    for (int j = 0; j < skeleton.size(); ++j) {
        const Joint& joint = skeleton.joint(j);
        const size_t parent = static_cast<size_t>(joint.parent);
        const Quaterniond& q_local = pose.q_parent_joint[static_cast<size_t>(j)];
        if (j == 0) {
            global.p_world_joint.push_back(pose.p_world_root);
            global.q_world_joint.push_back(q_local);
        } else {
            global.p_world_joint.push_back(global.p_world_joint[parent] +
                                           global.q_world_joint[parent] * joint.offset_m);
            global.q_world_joint.push_back(global.q_world_joint[parent] * q_local);
        }
    }
    return global;
}

JointAngles projectOntoJoint(const Joint& joint, const Quaterniond& q_parent_joint, bool apply_limits) {
    const Quaterniond q = q_parent_joint.normalized();
    JointAngles result{Quaterniond::Identity(), Eigen::VectorXd(static_cast<int>(joint.dof.size()))};
    switch (joint.type) {
        case JointType::kFree:
            result.q_parent_joint = q;
            return result;
        case JointType::kFixed:
            return result;
        case JointType::kBall:
            result.angles_rad = logQuaternion(q);
            break;
        case JointType::kUniversal:
            result.angles_rad = universalAngles(q, joint.dof[0].axis, joint.dof[1].axis);
            break;
        case JointType::kHinge:
            result.angles_rad[0] = twistAngle(q, joint.dof[0].axis);
            break;
    }
    for (size_t i = 0; i < joint.dof.size(); ++i) {
        double& angle = result.angles_rad[static_cast<int>(i)];
        angle = clampTo(joint.dof[i], angle, apply_limits);
    }
    result.q_parent_joint = rotationFromAngles(joint, result.angles_rad);
    return result;
}

Quaterniond rotationFromAngles(const Joint& joint, const Eigen::VectorXd& angles_rad) {
    switch (joint.type) {
        case JointType::kBall:
            return expQuaternion(angles_rad);
        case JointType::kUniversal:
            return axisAngle(joint.dof[0].axis, angles_rad[0]) * axisAngle(joint.dof[1].axis, angles_rad[1]);
        case JointType::kHinge:
            return axisAngle(joint.dof[0].axis, angles_rad[0]);
        case JointType::kFree:
        case JointType::kFixed:
            break;
    }
    return Quaterniond::Identity();
}

}  // namespace noctule
