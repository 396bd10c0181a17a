// SPDX-License-Identifier: Apache-2.0
// What smoothers ask of the filter: frames for them, and what it observed, about another state.
#include "core/estimation/manifold_filter.h"
#include "core/estimation/prediction.h"
#include "core/math/rotation.h"

namespace noctule {

/// Of a coordinate that is pulled: the root's place in the world, a joint's turn away from the usual; of a
/// rate; of an acceleration.
double ManifoldFilter::valueOf(const BodyState& state, int column) const {
    if (column >= 2 * layout_.freedoms)
        return state.motion.accel[column - 2 * layout_.freedoms];
    if (column >= layout_.freedoms)
        return state.motion.rate[column - layout_.freedoms];
    if (tree_.link(0).type == LinkType::kFree && column < 3)
        return state.motion.p_world_root[column];
    return coordinateError(tree_, usual_, state.motion)[column];
}

ObservationBlock ManifoldFilter::again(const ObservationBlock& taped, const StepInput& input,
                                       const BodyState& state, double at_s) {
    const ObservationOrigin& origin = taped.origin;
    const auto index = static_cast<size_t>(origin.index);
    ObservationBlock block;
    switch (origin.kind) {
        case ObservationOrigin::Kind::kPull:
            // What turns with the heading is left out: the target stands along the world's axes.
            block = taped;
            block.columns.resize(static_cast<size_t>(block.rows()));
            block.H.conservativeResize(Eigen::NoChange, block.rows());
            block.residual = origin.target;
            for (Eigen::Index i = 0; i < block.rows(); ++i)
                block.residual[i] -= valueOf(state, block.columns[static_cast<size_t>(i)]);
            return block;
        case ObservationOrigin::Kind::kTurn:
            block = turnOf(origin.index, LimbTarget(origin.target), state.motion);
            break;
        case ObservationOrigin::Kind::kGyro:
            block = observations_.gyro(state, input.inertial[index], input.inertial[index].time_s - at_s);
            break;
        case ObservationOrigin::Kind::kAccel:
            block =
                observations_.accel(state, input.inertial[index], input.inertial[index].time_s - at_s).block;
            break;
        case ObservationOrigin::Kind::kGain:
            block = gainOf(origin.index, origin.target, state);
            break;
        case ObservationOrigin::Kind::kDistance: {
            DistanceMeasurement believed = input.distances[index];
            believed.distance_m = origin.target[0];
            block =
                observations_.distance(state, believed, believed.emission_s - at_s, believed.arrival_s - at_s)
                    .block;
            break;
        }
        case ObservationOrigin::Kind::kRoot:
            block = observations_.root(state, input.roots[index], input.roots[index].time_s - at_s);
            break;
        case ObservationOrigin::Kind::kGive:
            block = now_.give.again(origin, state.motion);
            break;
    }
    const bool is_triad =
        origin.kind == ObservationOrigin::Kind::kGyro || origin.kind == ObservationOrigin::Kind::kAccel;
    if (is_triad && origin.target.size() > 0)
        block.residual += origin.target;
    block.variance = taped.variance;
    return block;
}

TapedFrame ManifoldFilter::frame(std::vector<int64_t> times_ns) const {
    Eigen::VectorXd apart;
    if (now_.apart)
        apart = now_.apart->head(layout_.freedoms);
    return {std::move(times_ns), now_.state.motion, std::move(apart),
            now_.P.dense().topRows(layout_.freedoms), now_.give.meanVariance_rad2()};
}

TimedPose ManifoldFilter::poseOf(const TapedFrame& frame, int64_t time_ns, const Eigen::VectorXd& error,
                                 const Eigen::MatrixXd& covariance) const {
    MotionState motion = frame.motion;
    tree_.retract(motion, frame.apart.size() > 0 ? frame.apart + error : error);
    return {time_ns, tree_.poseFromState(motion),
            jointSigmas(tree_, skeleton_, motion, covariance, frame.flesh_rad2, mounting_rad2_)};
}

}  // namespace noctule
