// SPDX-License-Identifier: Apache-2.0
// Optical captures lose sight of a straight limb's twist, and the solver then turns thigh and shin by half a
// turn about their own length between two frames, with the foot where it was. Such a jump is no motion: it is
// taken off from there on. What several jumps leave over fades slowly towards the nearest half turn, so
// nothing accumulates.
#pragma once

#include <optional>

#include "core/math/conventions.h"

namespace noctule::simulation {

class TwistContinuity {
public:
    /// `bone`: unit vector along the limb, in the segment's own frame.
    TwistContinuity(const Vector3d& bone, double frame_time_s) : bone_(bone), frame_time_s_(frame_time_s) {}

    /// World orientation of the segment in the next frame, jumps taken off.
    Quaterniond next(const Quaterniond& q_world_segment);
    int jumps() const { return jumps_; }

private:
    Vector3d bone_;
    double frame_time_s_;
    std::optional<Quaterniond> previous_;  ///< as it came
    double correction_rad_ = 0;            ///< about the bone
    int jumps_ = 0;
};

}  // namespace noctule::simulation
