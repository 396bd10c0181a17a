// SPDX-License-Identifier: Apache-2.0
#include "core/robot/miller_mapping.h"

#include <cmath>

namespace noctule::robot {
namespace {

/// The axis of the body nearest to a joint's, of those that are free.
std::pair<int, double> nearestAxis(const Vector3d& axis, const std::vector<int>& taken) {
    int nearest = -1;
    for (int i = 0; i < 3; ++i)
        if (std::find(taken.begin(), taken.end(), i) == taken.end() &&
            (nearest < 0 || std::abs(axis[i]) > std::abs(axis[nearest])))
            nearest = i;
    return {nearest, axis[nearest] < 0 ? -1.0 : 1.0};
}

}  // namespace

Result<MillerMapping> MillerMapping::make(const RobotArm& arm) {
    // Axes more than 60 degrees off decompose another rotation than the arm makes.
    constexpr double kNear = 0.5;
    MillerMapping made;
    made.side_ = arm.profile.side;
    made.offsets_ = arm.reference;
    made.lower_ = arm.chain.lower();
    made.upper_limit_ = arm.chain.upper();
    ChainState state;
    arm.chain.forward(arm.reference, state);
    std::vector<int> taken;
    // Joints 0 to 2 turn the upper arm, the elbow and the joint behind it the forearm.
    for (int joint = 0; joint < std::min(arm.elbow + 2, arm.chain.size()); ++joint) {
        if (joint == arm.elbow)
            taken.clear();
        const Vector3d axis =
            arm.profile.R_base_body.transpose() * state.axis_base[static_cast<size_t>(joint)];
        const auto [nearest, sign] = taken.size() < 3 ? nearestAxis(axis, taken) : std::pair(-1, 1.0);
        if (nearest < 0 || std::abs(axis[nearest]) < kNear)
            return Error{ErrorKind::kUnusable,
                         "arm " + arm.profile.name + ": the axes of its shoulder are no Euler sequence",
                         "Take --mapping posture"};
        taken.push_back(nearest);
        (joint < arm.elbow ? made.upper_ : made.forearm_).push_back({joint, sign});
        EulerOrder& order = joint < arm.elbow ? made.upper_order_ : made.forearm_order_;
        order[taken.size() - 1] = nearest;
        if (taken.size() == 2)
            order[2] = 3 - order[0] - order[1];
    }
    if (made.upper_.size() != 3)
        return Error{ErrorKind::kUnusable,
                     "arm " + arm.profile.name + ": its shoulder has " + std::to_string(made.upper_.size()) +
                         " joints, the mapping of Miller needs three",
                     "Take --mapping posture"};
    return made;
}

JointVector MillerMapping::map(const ArmPose& pose) {
    const Quaterniond q1(pose.R_upper * PerformerArms::referenceUpper(side_).transpose());
    const Quaterniond q2(pose.R_forearm * PerformerArms::referenceForearm(side_).transpose());
    const Quaterniond q2_local = q1.conjugate() * q2;
    upper_angles_ = eulerFromRotation(upper_order_, q1, upper_angles_);
    forearm_angles_ = eulerFromRotation(forearm_order_, q2_local, forearm_angles_);
    JointVector q = offsets_;
    for (size_t i = 0; i < upper_.size(); ++i)
        q[upper_[i].joint] += upper_[i].sign * upper_angles_[static_cast<Eigen::Index>(i)];
    for (size_t i = 0; i < forearm_.size(); ++i)
        q[forearm_[i].joint] += forearm_[i].sign * forearm_angles_[static_cast<Eigen::Index>(i)];
    return q.cwiseMax(lower_).cwiseMin(upper_limit_);
}

}  // namespace noctule::robot
