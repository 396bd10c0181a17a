// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/map_problem.h"

#include "core/estimation/prediction.h"
#include "core/math/rotation.h"

namespace noctule {
namespace {

Eigen::Array3i placesOf(Eigen::Index coordinate, Eigen::Index freedoms) {
    const auto first = static_cast<int>(coordinate), n = static_cast<int>(freedoms);
    return {first, n + first, 2 * n + first};
}

}  // namespace

MapProblem::MapProblem(ManifoldFilter& filter)
    : filter_(filter), first_(filter.state()), P_first_(filter.covariance()), P_first_factor_(P_first_) {}

double MapProblem::priorCost(const BodyState& first) const {
    const Eigen::VectorXd error = errorBetween(filter_.tree(), filter_.layout(), first_, first);
    return 0.5 * P_first_factor_.matrixL().solve(error).squaredNorm();
}

Matrix3d MapProblem::motionNoiseOf(const DecidedStep& step, Eigen::Index i) const {
    return motionNoise(filter_.stepSeconds(), filter_.accelerationDecay()[i], step.acceleration_variance[i]);
}

Eigen::VectorXd MapProblem::otherNoise(const DecidedStep& step) const {
    Eigen::VectorXd variance = filter_.wander();
    if (step.widened.size() > 0)
        variance += step.widened;
    return variance;
}

Eigen::VectorXd MapProblem::defect(const Leg& leg) const {
    BodyState expected = leg.from;
    predictMotion(filter_.tree(), expected.motion, filter_.stepSeconds(), filter_.accelerationDecay());
    return errorBetween(filter_.tree(), filter_.layout(), leg.to, expected);
}

double MapProblem::stepCost(const DecidedStep& step, const Leg& leg) const {
    const Eigen::Index n = filter_.layout().freedoms;
    const Eigen::VectorXd noise = defect(leg), other = otherNoise(step);
    double twice = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::Array3i places = placesOf(i, n);
        Matrix3d Q = motionNoiseOf(step, i);
        Q.diagonal() += other(places);
        twice += Q.llt().matrixL().solve(Vector3d(noise(places))).squaredNorm();
    }
    for (Eigen::Index i = 3 * n; i < noise.size(); ++i)  // what has no noise is the same in all steps
        if (other[i] > 0)
            twice += noise[i] * noise[i] / other[i];
    for (const auto& blocks : step.updates)
        for (const ObservationBlock& taped : blocks) {
            const ObservationBlock block = filter_.again(taped, step.input, leg.to, leg.at_s);
            twice += (block.residual.array().square() / block.variance.array()).sum();
        }
    return 0.5 * twice;
}

MapProblem::Estimate MapProblem::prior(const BodyState& first) const {
    const Eigen::VectorXd moved = errorBetween(filter_.tree(), filter_.layout(), first_, first);
    Estimate estimate{-moved, Covariance(Eigen::VectorXd::Zero(moved.size()))};
    estimate.P.dense() = P_first_;
    shiftOfErrors(filter_.tree(), moved).carry(estimate.P.dense());
    return estimate;
}

void MapProblem::filterStep(const DecidedStep& step, const Leg& leg, Estimate& estimate,
                            FilterTape* tape) const {
    MotionState motion = leg.from.motion;
    LinkTransitions transition =
        predictMotion(filter_.tree(), motion, estimate.P.dense(), filter_.stepSeconds(),
                      filter_.accelerationDecay(), step.acceleration_variance);
    estimate.P.dense().diagonal() += otherNoise(step);
    transition.carry(estimate.error);
    estimate.error += defect(leg);
    if (tape)
        tape->push_back(std::move(transition));
    for (const auto& taped_blocks : step.updates) {
        std::vector<ObservationBlock> blocks;
        for (const ObservationBlock& taped : taped_blocks) {
            blocks.push_back(filter_.again(taped, step.input, leg.to, leg.at_s));
            ObservationBlock& block = blocks.back();
            block.residual -= block.of(estimate.error);
        }
        ObservedUpdate observed;
        estimate.error += estimate.P.update(blocks, tape ? &observed : nullptr);
        if (tape)
            tape->push_back(std::move(observed));
    }
}

Eigen::VectorXd MapProblem::noiseTimes(const DecidedStep& step, const Eigen::VectorXd& lambda) const {
    const Eigen::Index n = filter_.layout().freedoms;
    Eigen::VectorXd product = otherNoise(step).cwiseProduct(lambda);
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::Array3i places = placesOf(i, n);
        product(places) += motionNoiseOf(step, i) * Vector3d(lambda(places));
    }
    return product;
}

}  // namespace noctule
