// SPDX-License-Identifier: Apache-2.0
#include "core/robot/robot_model.h"

#include <algorithm>

namespace noctule::robot {
namespace {

Eigen::Isometry3d motionOf(const RobotJoint& joint, double value) {
    Eigen::Isometry3d T = joint.T_parent_joint;
    if (joint.kind == JointKind::kPrismatic)
        T.translate(joint.axis * value);
    else if (joint.moves())
        T.rotate(Eigen::AngleAxisd(value, joint.axis));
    return T;
}

Eigen::Isometry3d placeInRoot(const RobotModel& model, int link) {
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    for (const int index : model.jointsAbove(link)) {
        const RobotJoint& joint = model.joints[static_cast<size_t>(index)];
        T = T * motionOf(joint, joint.mimic ? joint.mimic->offset : 0);
    }
    return T;
}

template <class Parts>
int indexOf(const Parts& parts, const std::string& name) {
    const auto found =
        std::find_if(parts.begin(), parts.end(), [&](const auto& p) { return p.name == name; });
    return found == parts.end() ? -1 : static_cast<int>(found - parts.begin());
}

}  // namespace

int RobotModel::findLink(const std::string& link) const {
    return indexOf(links, link);
}

int RobotModel::findJoint(const std::string& joint) const {
    return indexOf(joints, joint);
}

std::vector<int> RobotModel::jointsAbove(int link) const {
    std::vector<int> above;
    for (int joint = links[static_cast<size_t>(link)].parent_joint; joint >= 0;) {
        above.push_back(joint);
        const int parent = joints[static_cast<size_t>(joint)].parent_link;
        joint = links[static_cast<size_t>(parent)].parent_joint;
    }
    std::reverse(above.begin(), above.end());
    return above;
}

Eigen::Isometry3d placeAtZero(const RobotModel& model, int from_link, int to_link) {
    return placeInRoot(model, from_link).inverse() * placeInRoot(model, to_link);
}

}  // namespace noctule::robot
