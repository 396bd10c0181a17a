// SPDX-License-Identifier: Apache-2.0
// Joint values that bring a chain's tip to a place and rotation, from any start: a bounded
// Levenberg-Marquardt descent, begun again at random postures until one arrives. For finding a posture only;
// following a motion never restarts (see arm_follower.h), since a restart throws joints by radians.
#pragma once

#include <cstdint>

#include "core/robot/chain.h"

namespace noctule::robot {

struct PostureSearch {
    double tolerance_m = 1e-5, tolerance_rad = 1e-5;
    int most_iterations = 1500;  ///< of all starts together; one takes about 2 us on a desktop
    int most_per_start = 40;     ///< then the next random start
    uint64_t seed = 1;           ///< of the random starts; the same seed gives the same posture
};

struct FoundPosture {
    JointVector q;  ///< the best one, inside the limits, whether it arrived or not
    bool arrived = false;
    double distance_m = 0, angle_rad = 0;  ///< what is left
    int iterations = 0, starts = 0;
};

/// `q` is the first start.
FoundPosture findPosture(const Chain& chain, const Matrix3d& R_base_tip, const Vector3d& p_base_tip,
                         const JointVector& q, const PostureSearch& search = {});

/// Rotation vector that takes R to R_target (in the base's axes) and its derivative by a turn of R.
struct TurnError {
    Vector3d error;
    Matrix3d by_turn;
};
TurnError turnError(const Matrix3d& R_target, const Matrix3d& R);

/// Numbers between 0 and 1, the same on every machine.
class RandomPostures {
public:
    explicit RandomPostures(uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15u + 1) {}
    double uniform();
    /// Inside the limits; a continuous joint turns to any side.
    JointVector next(const Chain& chain);

private:
    uint64_t state_;
};

}  // namespace noctule::robot
