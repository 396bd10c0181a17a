// SPDX-License-Identifier: Apache-2.0
// Errors of a filter's state in the order of its StateLayout: rotations by right perturbations, all else by
// differences.
#pragma once

#include "core/estimation/observation.h"
#include "core/math/transition_kernels.h"

namespace noctule {

/// The coordinates' part: what retracts `from` to `to`.
Eigen::VectorXd coordinateError(const KinematicTree& tree, const MotionState& from, const MotionState& to);

void addError(const KinematicTree& tree, const StateLayout& layout, const Eigen::VectorXd& error,
              BodyState& state);

/// What added to `from` gives `to`.
Eigen::VectorXd errorBetween(const KinematicTree& tree, const StateLayout& layout, const BodyState& from,
                             const BodyState& to);

/// To errors of the state that `moved`, added to the one they are of, gives: one after another turns on its
/// right, hence right Jacobians.
LinkTransitions shiftOfErrors(const KinematicTree& tree, const Eigen::VectorXd& moved);

/// Calls `each(numbers, count)` for all there is in a state.
template <class State, class Each>
void forEachNumber(State& state, const Each& each) {
    each(state.motion.p_world_root.data(), 3);
    for (auto& q : state.motion.q_parent_link)
        each(q.coeffs().data(), 4);
    each(state.motion.angle_rad.data(), std::ssize(state.motion.angle_rad));
    each(state.motion.rate.data(), state.motion.rate.size());
    each(state.motion.accel.data(), state.motion.accel.size());
    for (auto& bias : state.gyro_bias)
        each(bias.data(), 3);
    for (auto& bias : state.accel_bias)
        each(bias.data(), 3);
    each(state.source_offset_m.data(), std::ssize(state.source_offset_m));
    each(&state.sound_scale, 1);
}

}  // namespace noctule
