// SPDX-License-Identifier: Apache-2.0
#include "core/robot/chain.h"

#include <algorithm>
#include <cmath>

#include "core/math/rotation.h"

namespace noctule::robot {
namespace {

Error unusable(const RobotModel& model, const std::string& what, const std::string& remedy) {
    return {ErrorKind::kUnusable, "robot " + model.name + ": " + what, remedy};
}

Result<int> linkNamed(const RobotModel& model, const std::string& name) {
    const int link = model.findLink(name);
    if (link < 0)
        return unusable(model, "there is no link \"" + name + "\"", "Name a link of the URDF");
    return link;
}

/// The frame of the joint (at value 0) in the frame of the moving joint before it, as the file has both.
struct Offset {
    Matrix3d R = Matrix3d::Identity();
    Vector3d p = Vector3d::Zero();

    void append(const Eigen::Isometry3d& T) {
        p += R * T.translation();
        R = R * T.linear();
    }
};

}  // namespace

Result<Chain> Chain::make(const RobotModel& model, const std::string& base, const std::string& tip) {
    const auto base_link = linkNamed(model, base), tip_link = linkNamed(model, tip);
    if (!base_link || !tip_link)
        return base_link ? tip_link.error() : base_link.error();
    std::vector<int> path = model.jointsAbove(*tip_link);
    const std::vector<int> above = model.jointsAbove(*base_link);
    if (above.size() > path.size() || !std::equal(above.begin(), above.end(), path.begin()))
        return unusable(model, "link \"" + tip + "\" does not hang below link \"" + base + "\"",
                        "Name a base nearer to the root");
    path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(above.size()));
    Chain chain;
    Offset offset;
    for (const int index : path) {
        const RobotJoint& joint = model.joints[static_cast<size_t>(index)];
        offset.append(joint.T_parent_joint);
        if (!joint.moves())
            continue;
        if (joint.mimic)
            return unusable(model, "joint \"" + joint.name + "\" in the chain follows another joint",
                            "Choose a chain of joints that are driven");
        ChainJoint made;
        made.name = joint.name;
        made.model_joint = index;
        made.is_prismatic = joint.kind == JointKind::kPrismatic;
        made.lower = joint.lower;
        made.upper = joint.upper;
        made.max_speed = joint.max_speed;
        const Matrix3d turn = smallestRotation(Vector3d::UnitZ(), joint.axis).toRotationMatrix();
        made.R_axis_joint = turn.transpose();
        made.R_before = offset.R * turn;
        made.p_before = offset.p;
        offset = {made.R_axis_joint, Vector3d::Zero()};
        chain.joints_.push_back(std::move(made));
    }
    chain.R_last_tip_ = offset.R;
    chain.p_last_tip_ = offset.p;
    if (chain.joints_.empty() || chain.size() > kMostChainJoints)
        return unusable(
            model, std::to_string(chain.size()) + " joints move between \"" + base + "\" and \"" + tip + "\"",
            "Choose a chain of 1 to " + std::to_string(kMostChainJoints) + " moving joints");
    return chain;
}

int Chain::find(const std::string& joint) const {
    const auto found =
        std::find_if(joints_.begin(), joints_.end(), [&](const ChainJoint& j) { return j.name == joint; });
    return found == joints_.end() ? -1 : static_cast<int>(found - joints_.begin());
}

void Chain::forward(const JointVector& q, ChainState& state) const {
    const size_t count = joints_.size();
    state.p_base_joint.resize(count);
    state.axis_base.resize(count);
    state.R_base_link.resize(count);
    Matrix3d R = Matrix3d::Identity();
    Vector3d p = Vector3d::Zero();
    for (size_t i = 0; i < count; ++i) {
        const ChainJoint& joint = joints_[i];
        const double value = q[static_cast<Eigen::Index>(i)];
        p += R * joint.p_before;
        R = R * joint.R_before;
        state.p_base_joint[i] = p;
        state.axis_base[i] = R.col(2);
        if (joint.is_prismatic) {
            p += value * R.col(2);
        } else {
            const double c = std::cos(value), s = std::sin(value);
            const Vector3d x = R.col(0), y = R.col(1);
            R.col(0) = c * x + s * y;
            R.col(1) = c * y - s * x;
        }
        state.R_base_link[i].noalias() = R * joint.R_axis_joint;
    }
    state.p_base_tip = p + R * p_last_tip_;
    state.R_base_tip.noalias() = R * R_last_tip_;
}

void Chain::pointJacobian(const ChainState& state, int last, const Vector3d& p_base_point,
                          PointJacobian& J) const {
    J.setZero(3, size());
    for (int i = 0; i <= last; ++i) {
        const auto at = static_cast<size_t>(i);
        J.col(i) = joints_[at].is_prismatic
                       ? state.axis_base[at]
                       : Vector3d(state.axis_base[at].cross(p_base_point - state.p_base_joint[at]));
    }
}

void Chain::turnJacobian(const ChainState& state, int last, PointJacobian& J) const {
    J.setZero(3, size());
    for (int i = 0; i <= last; ++i)
        if (const auto at = static_cast<size_t>(i); !joints_[at].is_prismatic)
            J.col(i) = state.axis_base[at];
}

JointVector Chain::middle() const {
    JointVector q(size());
    for (int i = 0; i < size(); ++i)
        q[i] = std::isfinite(joint(i).lower) ? (joint(i).lower + joint(i).upper) / 2 : 0;
    return q;
}

JointVector Chain::lower() const {
    JointVector q(size());
    for (int i = 0; i < size(); ++i)
        q[i] = joint(i).lower;
    return q;
}

JointVector Chain::upper() const {
    JointVector q(size());
    for (int i = 0; i < size(); ++i)
        q[i] = joint(i).upper;
    return q;
}

}  // namespace noctule::robot
