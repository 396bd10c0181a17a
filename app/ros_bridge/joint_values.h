// SPDX-License-Identifier: Apache-2.0
// The newest value of every driven joint, gathered from messages that name their joints in any order.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace noctule::ros_bridge {

class JointValues {
public:
    explicit JointValues(const std::vector<std::string>& joints);

    /// False: the message tells nothing of our joints, or a value is missing, no number or beyond
    /// robot_link::kLargestValue; then nothing is taken. Joints that are not driven are ignored.
    bool take(const std::vector<std::string>& names, const std::vector<double>& q,
              const std::vector<double>& v);
    /// Every joint was told at least once.
    bool complete() const { return missing_ == 0; }
    const std::vector<double>& q() const { return q_; }  ///< rad or m, in the order of the joints
    const std::vector<double>& v() const { return v_; }  ///< rad/s or m/s; 0 where none is told

private:
    std::map<std::string, size_t> index_;
    std::vector<double> q_, v_;
    std::vector<bool> seen_;
    size_t missing_;
};

}  // namespace noctule::ros_bridge
