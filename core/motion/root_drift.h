// SPDX-License-Identifier: Apache-2.0
// How the root wanders away from a reference. Nothing on the suit measures yaw or position absolutely, so
// both are made equal at the first frame; tilt is measured against gravity and is compared as it is.
#pragma once

#include "core/motion/angle_collector.h"
#include "core/motion/comparison.h"

namespace noctule {

struct RootState {
    Quaterniond q_world_root;
    Vector3d p_world_root_m;
};

class RootDrift {
public:
    void add(double time_s, const RootState& estimate, const RootState& reference);
    RootComparison finish();

private:
    std::optional<RootState> first_estimate_, first_reference_;
    Quaterniond q_reference_estimate_;     // about the vertical, from the first frame
    Vector3d squares_ = Vector3d::Zero();  // yaw, tilt, position
    double frames_ = 0;
    AngleCollector yaw_;
    double begin_s_ = 0;
    RootComparison result_;
};

}  // namespace noctule
