// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/error_state.h"

#include "core/math/rotation.h"

namespace noctule {
namespace {

/// Calls `each(place, value)` for every constant that is estimated, a reference into `state`.
template <class State, class Each>
void forEachConstant(const StateLayout& layout, State& state, const Each& each) {
    const auto triads = [&](int first, auto& values) {
        for (size_t b = 0; first >= 0 && b < values.size(); ++b)
            for (int i = 0; i < 3; ++i)
                each(first + 3 * static_cast<int>(b) + i, values[b][i]);
    };
    triads(layout.gyro_bias, state.gyro_bias);
    triads(layout.accel_bias, state.accel_bias);
    for (size_t s = 0; layout.source_offset >= 0 && s < state.source_offset_m.size(); ++s)
        each(layout.source_offset + static_cast<int>(s), state.source_offset_m[s]);
    if (layout.sound_scale >= 0)
        each(layout.sound_scale, state.sound_scale);
}

}  // namespace

Eigen::VectorXd coordinateError(const KinematicTree& tree, const MotionState& from, const MotionState& to) {
    Eigen::VectorXd error(tree.freedoms());
    for (size_t i = 0; i < tree.links().size(); ++i) {
        const Link& link = tree.links()[i];
        if (link.type == LinkType::kHinge)
            error[link.first] = to.angle_rad[i] - from.angle_rad[i];
        if (link.type == LinkType::kFree)
            error.segment<3>(link.first) = to.p_world_root - from.p_world_root;
        if (link.type == LinkType::kFree || link.type == LinkType::kBall)
            error.segment<3>(link.first + link.count - 3) =
                logQuaternion(from.q_parent_link[i].conjugate() * to.q_parent_link[i]);
    }
    return error;
}

void addError(const KinematicTree& tree, const StateLayout& layout, const Eigen::VectorXd& error,
              BodyState& state) {
    const int n = layout.freedoms;
    tree.retract(state.motion, error.head(n));
    state.motion.rate += error.segment(n, n);
    state.motion.accel += error.segment(2 * n, n);
    forEachConstant(layout, state, [&](int place, double& value) { value += error[place]; });
}

Eigen::VectorXd errorBetween(const KinematicTree& tree, const StateLayout& layout, const BodyState& from,
                             const BodyState& to) {
    Eigen::VectorXd error = Eigen::VectorXd::Zero(layout.size);
    error.head(3 * layout.freedoms) << coordinateError(tree, from.motion, to.motion),
        to.motion.rate - from.motion.rate, to.motion.accel - from.motion.accel;
    forEachConstant(layout, to, [&](int place, double value) { error[place] = value; });
    forEachConstant(layout, from, [&](int place, double value) { error[place] -= value; });
    return error;
}

LinkTransitions shiftOfErrors(const KinematicTree& tree, const Eigen::VectorXd& moved) {
    LinkTransitions shift{tree.freedoms()};
    for (const Link& link : tree.links())
        if (const int first = link.first + link.count - 3;
            link.type == LinkType::kBall || (link.type == LinkType::kFree && link.count == 6))
            shift.links.push_back(
                {.first = first, .count = 3, .turn = rightJacobian(moved.segment<3>(first))});
    return shift;
}

}  // namespace noctule
