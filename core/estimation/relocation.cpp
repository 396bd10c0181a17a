// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/relocation.h"

#include <utility>

#include "core/estimation/gauss_newton_stretch.h"

namespace noctule {
namespace {

constexpr int kMostSteps = 15, kMostInVain = 4;  ///< of Gauss-Newton
constexpr double kSettledGain = 0.01;            ///< of a step, as a share of the cost

/// The motion over the next steps, from before the first one, and what the filter decides there: first by its
/// gyroscopes alone, which keep limbs about where they were believed.
class Window {
public:
    explicit Window(ManifoldFilter& filter)
        : filter_(filter), problem_(filter), before_(filter.memory()), begin_s_(filter.seconds()) {}

    /// What the filter believes over these steps. The first time it finds the motion, too.
    void decide(const std::vector<ManifoldFilter::StepInput>& ahead) {
        filter_.recall(before_);
        steps_.clear();
        std::vector<BodyState> found{filter_.state()};
        FilterTape tape;
        filter_.setTape(&tape);
        for (const ManifoldFilter::StepInput& input : ahead) {
            tape.clear();
            DecidedStep step;
            step.input = input;
            step.acceleration_variance = filter_.memory().motion_noise.variance();
            filter_.step(input);
            step.note(tape);
            steps_.push_back(std::move(step));
            found.push_back(filter_.state());
        }
        filter_.setTape(nullptr);
        if (states_.empty())
            states_ = std::move(found);
    }

    /// Full steps: one opens gaps between states, which cost a lot, and the next closes them.
    /// False where none gains.
    bool fit() {
        std::vector<BodyState> moving = states_;
        double least = costOf(states_);
        const double begin = least;
        for (int step = 0, in_vain = 0; step < kMostSteps && in_vain < kMostInVain; ++step) {
            const std::vector<Eigen::VectorXd> errors = errorsOf(moving);
            for (size_t i = 0; i < moving.size(); ++i)
                addError(filter_.tree(), filter_.layout(), errors[i], moving[i]);
            const double cost = costOf(moving);
            ++in_vain;
            if (!(cost < least))
                continue;
            states_ = moving;
            if (std::exchange(least, cost) - cost < kSettledGain * cost)
                break;
            in_vain = 0;
        }
        return least < begin;
    }

    std::vector<ManifoldFilter::StepInput::About> legs() const {
        std::vector<ManifoldFilter::StepInput::About> legs;
        for (size_t i = 0; i + 1 < states_.size(); ++i)
            legs.push_back({states_[i], states_[i + 1]});
        return legs;
    }

private:
    Leg leg(const std::vector<BodyState>& states, size_t step) const {
        return {states[step], states[step + 1],
                begin_s_ + static_cast<double>(step + 1) * filter_.stepSeconds()};
    }

    double costOf(const std::vector<BodyState>& states) const {
        double cost = problem_.priorCost(states.front());
        for (size_t i = 0; i < steps_.size(); ++i)
            cost += problem_.stepCost(steps_[i], leg(states, i));
        return cost;
    }

    std::vector<Eigen::VectorXd> errorsOf(const std::vector<BodyState>& states) const {
        GaussNewtonStretch stretch(problem_, problem_.prior(states.front()));
        for (size_t i = 0; i < steps_.size(); ++i)
            stretch.pass(steps_[i], leg(states, i));
        AdjointPass adjoint(filter_.layout().size);
        return stretch.errors(adjoint);
    }

    ManifoldFilter& filter_;
    MapProblem problem_;
    ManifoldFilter::Memory before_;
    double begin_s_;
    std::vector<DecidedStep> steps_;
    std::vector<BodyState> states_;  ///< before the first step, then at the end of each
};

}  // namespace

std::vector<ManifoldFilter::StepInput::About> relocate(ManifoldFilter filter,
                                                       std::vector<ManifoldFilter::StepInput> ahead) {
    Window window(filter);
    std::vector<ManifoldFilter::StepInput> turns = ahead;
    for (ManifoldFilter::StepInput& input : turns) {
        input.distances.clear();
        for (InertialMeasurement& reading : input.inertial)
            reading.accel.count = 0;
    }
    window.decide(turns);
    bool is_found = false;
    for (int round = 0; round < filter.parameters().relocation.rounds; ++round) {
        const auto legs = window.legs();
        for (size_t i = 0; i < ahead.size(); ++i)
            ahead[i].about = legs[i];
        window.decide(ahead);
        is_found |= window.fit();
    }
    return is_found ? window.legs() : std::vector<ManifoldFilter::StepInput::About>();
}

}  // namespace noctule
