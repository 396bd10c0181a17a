// SPDX-License-Identifier: Apache-2.0
// A chain of moving joints from a base link to a tip link of a robot: forward kinematics and the geometric
// Jacobian. All places and rotations are in the base link's frame; joint values in rad or m.
#pragma once

#include <string>
#include <vector>

#include "core/job/result.h"
#include "core/robot/robot_model.h"

namespace noctule::robot {

/// Moving joints of one chain at most; matrices of this size need no memory of their own.
inline constexpr int kMostChainJoints = 12;

using JointVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostChainJoints, 1>;
using PointJacobian = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, kMostChainJoints>;

struct ChainJoint {
    std::string name;
    int model_joint = -1;
    bool is_prismatic = false;
    double lower = 0, upper = 0;               ///< of a continuous joint -inf and inf
    double max_speed = 0;                      ///< rad/s or m/s
    Matrix3d R_before = Matrix3d::Identity();  ///< from the joint before to this one's frame, z its axis
    Vector3d p_before = Vector3d::Zero();
    Matrix3d R_axis_joint = Matrix3d::Identity();  ///< from the frame with z as axis to the file's
};

/// Where a chain stands for one set of joint values.
struct ChainState {
    std::vector<Vector3d> p_base_joint;  ///< origin of each joint
    std::vector<Vector3d> axis_base;     ///< unit axis of each joint
    std::vector<Matrix3d> R_base_link;   ///< of the link that each joint carries, as the file has it
    Matrix3d R_base_tip = Matrix3d::Identity();
    Vector3d p_base_tip = Vector3d::Zero();
};

class Chain {
public:
    /// kUnusable when the links do not lie above one another, nothing moves between them, more than
    /// kMostChainJoints do, or one of them mimics another joint.
    static Result<Chain> make(const RobotModel& model, const std::string& base, const std::string& tip);

    int size() const { return static_cast<int>(joints_.size()); }
    const std::vector<ChainJoint>& joints() const { return joints_; }
    ChainJoint& joint(int index) { return joints_[static_cast<size_t>(index)]; }
    const ChainJoint& joint(int index) const { return joints_[static_cast<size_t>(index)]; }
    int find(const std::string& joint) const;  ///< -1: not in the chain

    /// `state` keeps its memory from call to call.
    void forward(const JointVector& q, ChainState& state) const;
    /// Derivative of the place of a point that joint `last` carries; columns of joints behind it are 0.
    void pointJacobian(const ChainState& state, int last, const Vector3d& p_base_point,
                       PointJacobian& J) const;
    /// Derivative of the turn (rad, in the base's axes) of the link that joint `last` carries.
    void turnJacobian(const ChainState& state, int last, PointJacobian& J) const;

    /// Middle of the limits; of a continuous joint 0.
    JointVector middle() const;
    JointVector lower() const;
    JointVector upper() const;

private:
    std::vector<ChainJoint> joints_;
    Matrix3d R_last_tip_ = Matrix3d::Identity();
    Vector3d p_last_tip_ = Vector3d::Zero();
};

}  // namespace noctule::robot
