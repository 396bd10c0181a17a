// SPDX-License-Identifier: Apache-2.0
// Distances between a robot's own parts, links as capsules: the primitive collision shapes of the URDF, or
// for links without any the lines between their joints in the profile's radius. Pairs of neighbours and
// pairs that touch in the reference posture are left out.
#pragma once

#include "core/robot/link_shapes.h"
#include "core/robot/profile.h"

namespace noctule::robot {

class SelfCollision {
public:
    SelfCollision(const RobotModel& model, const RobotProfile& profile, const JointValues& reference);

    struct Nearest {
        double distance_m = 0;  ///< below 0: they overlap; infinite without pairs
        int link_a = -1, link_b = -1;
    };
    Nearest nearest(const JointValues& values) const;
    size_t pairs() const { return pairs_.size(); }

private:
    struct Part {
        int link = -1;
        LinkShape shape;
    };
    double distance(const std::vector<Eigen::Isometry3d>& places, const Part& a, const Part& b) const;

    const RobotModel& model_;
    std::vector<Part> parts_;
    std::vector<std::pair<size_t, size_t>> pairs_;
};

}  // namespace noctule::robot
