// SPDX-License-Identifier: Apache-2.0
#include "app/ros_bridge/joint_values.h"

#include "devices/robot/link_types.h"

namespace noctule::ros_bridge {

JointValues::JointValues(const std::vector<std::string>& joints)
    : q_(joints.size()), v_(joints.size()), seen_(joints.size()), missing_(joints.size()) {
    for (size_t i = 0; i < joints.size(); ++i)
        index_.emplace(joints[i], i);
}

bool JointValues::take(const std::vector<std::string>& names, const std::vector<double>& q,
                       const std::vector<double>& v) {
    if (q.size() != names.size() || (!v.empty() && v.size() != names.size()))
        return false;
    std::vector<std::pair<size_t, size_t>> ours;  // in the message, here
    for (size_t i = 0; i < names.size(); ++i)
        if (const auto found = index_.find(names[i]); found != index_.end()) {
            if (!robot_link::areSound({q[i]}, {v.empty() ? 0 : v[i]}, 1))
                return false;
            ours.emplace_back(i, found->second);
        }
    for (const auto& [from, to] : ours) {
        q_[to] = q[from];
        v_[to] = v.empty() ? 0 : v[from];
        missing_ -= seen_[to] ? 0 : 1;
        seen_[to] = true;
    }
    return !ours.empty();
}

}  // namespace noctule::ros_bridge
