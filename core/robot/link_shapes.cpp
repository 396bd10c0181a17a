// SPDX-License-Identifier: Apache-2.0
#include "core/robot/link_shapes.h"

namespace noctule::robot {

std::vector<Eigen::Isometry3d> linkPlaces(const RobotModel& model, const JointValues& values) {
    std::vector<Eigen::Isometry3d> places(model.links.size(), Eigen::Isometry3d::Identity());
    const auto valueOf = [&](int joint) {
        const auto found = values.find(joint);
        return found == values.end() ? 0 : found->second;
    };
    for (size_t i = 1; i < model.links.size(); ++i) {
        const int index = model.links[i].parent_joint;
        const RobotJoint& joint = model.joints[static_cast<size_t>(index)];
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

std::vector<LinkShape> shapesOf(const RobotModel& model, size_t link, double radius_m) {
    if (!model.links[link].shapes.empty())
        return model.links[link].shapes;
    std::vector<LinkShape> lines;
    for (const int child : model.links[link].child_joints) {
        const RobotJoint& joint = model.joints[static_cast<size_t>(child)];
        if (joint.moves() && joint.T_parent_joint.translation().norm() > radius_m)
            lines.push_back({Vector3d::Zero(), joint.T_parent_joint.translation(), radius_m});
    }
    return lines;
}

}  // namespace noctule::robot
