// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/gauss_newton_stretch.h"

#include <utility>

namespace noctule {

GaussNewtonStretch::GaussNewtonStretch(const MapProblem& problem, MapProblem::Estimate begin)
    : problem_(problem), begin_(std::move(begin)), estimate_(begin_) {}

void GaussNewtonStretch::pass(const DecidedStep& step, const Leg& leg) {
    problem_.filterStep(step, leg, estimate_, &tape_);
    passed_.push_back({{}, problem_.defect(leg)});
    passed_.back().noise.acceleration_variance = step.acceleration_variance;
    passed_.back().noise.widened = step.widened;
}

std::vector<Eigen::VectorXd> GaussNewtonStretch::errors(AdjointPass& adjoint) const {
    std::vector<Eigen::VectorXd> lambdas(passed_.size());
    auto lambda = lambdas.rbegin();
    for (auto event = tape_.rbegin(); event != tape_.rend(); ++event) {
        if (const auto* update = std::get_if<ObservedUpdate>(&*event))
            adjoint.back(*update);
        if (const auto* transition = std::get_if<LinkTransitions>(&*event)) {
            *lambda++ = adjoint.lambda();
            adjoint.back(*transition);
        }
    }
    std::vector<Eigen::VectorXd> errors{begin_.error - begin_.P.dense() * adjoint.lambda()};
    Eigen::VectorXd error = errors.front();
    for (const auto& event : tape_)
        if (const auto* transition = std::get_if<LinkTransitions>(&event)) {
            const size_t step = errors.size() - 1;
            transition->carry(error);
            error += passed_[step].defect - problem_.noiseTimes(passed_[step].noise, lambdas[step]);
            errors.push_back(error);
        }
    return errors;
}

}  // namespace noctule
