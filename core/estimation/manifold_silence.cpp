// SPDX-License-Identifier: Apache-2.0
// How the filter takes its readings step by step, and looks ahead after a silence of the whole suit.
#include <algorithm>
#include <cmath>

#include "core/estimation/manifold_filter.h"
#include "core/estimation/prediction.h"
#include "core/estimation/relocation.h"

namespace noctule {

bool ManifoldFilter::isDue(double time_s) {
    const auto lookAhead = [&] {
        const auto next = static_cast<double>(now_.step_index + 1 + std::ssize(ahead_));
        const bool is_reached = next * step_s_ + inertial_.reach_s() <= time_s;
        if (is_reached)
            ahead_.push_back(takeInput());
        return is_reached;
    };
    if (ahead_.empty() && !lookAhead())
        return false;
    if (ahead_.front().about || !findsTheBody(ahead_.front()))
        return true;
    const auto steps = static_cast<size_t>(std::llround(parameters_.relocation.window_s / step_s_));
    while (ahead_.size() < steps)
        if (!lookAhead()) {
            if (!ended_)
                return false;
            break;
        }
    auto motion = relocate(*this, {ahead_.begin(), ahead_.end()});
    now_.lost = !motion.empty();  // else it goes on as it can
    for (size_t i = 0; i < motion.size(); ++i)
        ahead_[i].about = std::move(motion[i]);
    return true;
}

ManifoldFilter::StepInput ManifoldFilter::nextInput() {
    if (ahead_.empty())
        return takeInput();
    StepInput input = std::move(ahead_.front());
    ahead_.pop_front();
    return input;
}

ManifoldFilter::StepInput ManifoldFilter::takeInput() {
    const int64_t step = now_.step_index + 1 + std::ssize(ahead_);
    const double limit_s = (static_cast<double>(step) + 0.5) * step_s_;
    StepInput input{roots_.takeUpTo(limit_s), {}, distances_.takeUpTo(limit_s), {}};
    if (step % parameters_.steps_per_frame == 0)
        input.inertial = inertial_.at(limit_s - 0.5 * step_s_);
    const auto is_before = [&](const auto& m) { return m.time_s < limit_s - step_s_ - 1e-9; };
    std::erase_if(input.roots, is_before);
    return input;
}

bool ManifoldFilter::speaks(const InertialMeasurement& measurement) const {
    return (parameters_.sensors.gyroscopes ? measurement.gyro : measurement.accel).count == 3;
}

void ManifoldFilter::noteHeard(const std::vector<InertialMeasurement>& measurements) {
    for (const InertialMeasurement& measurement : measurements)
        if (speaks(measurement))
            now_.heard_s[static_cast<size_t>(measurement.board)] = seconds();
}

ManifoldFilter::Hearing ManifoldFilter::hearing(double within_s,
                                                const std::vector<InertialMeasurement>& now) const {
    std::vector<double> heard_s = now_.heard_s;
    for (const InertialMeasurement& measurement : now)
        if (speaks(measurement))
            heard_s[static_cast<size_t>(measurement.board)] = seconds();
    Hearing hearing;
    for (size_t board = 0; board < suit_.boards.size(); ++board) {
        if (suit_.boards[board].link < 0 || heard_s[board] == 0)
            continue;  // on nobody, as an anchor's, or never heard
        ++hearing.worn;
        hearing.heard += seconds() - heard_s[board] <= within_s;
    }
    return hearing;
}

bool ManifoldFilter::isSilent() const {
    const SensorSelection& sensors = parameters_.sensors;
    const Hearing now = hearing(parameters_.relocation.silence_s);
    return sensors.gyroscopes && sensors.accelerometers && now.worn > 0 && now.heard == 0;
}

/// At the end of a step.
void ManifoldFilter::noteSilence() {
    constexpr double kGivenUp_s = 1;  // most of the suit may be broken
    const bool is_silent = isSilent();
    now_.motion_noise.setCalm(is_silent);
    if (is_silent) {
        now_.lost = true;
        now_.back_s.reset();
    }
    if (!now_.lost || is_silent)
        return;
    if (!now_.back_s)
        now_.back_s = seconds();
    const Hearing now = hearing(parameters_.relocation.silence_s);
    now_.lost = 2 * now.heard < now.worn && seconds() - *now_.back_s < kGivenUp_s;
}

/// After a silence of the whole suit its boards come back one by one.
bool ManifoldFilter::findsTheBody(const StepInput& input) const {
    const RelocationParameters& relocation = parameters_.relocation;
    if (!now_.lost || relocation.rounds == 0 || seconds() - now_.relocated_s < relocation.pause_s)
        return false;
    const Hearing now = hearing(relocation.silence_s, input.inertial);
    return 2 * now.heard >= now.worn;
}

/// Nobody sees how joints turn: they stop, and may be elsewhere the longer it lasts.
void ManifoldFilter::holdInSilence() {
    std::vector<ObservationBlock> blocks;
    const Eigen::VectorXd away = coordinateError(tree_, usual_, now_.state.motion);
    Widening widening{Eigen::VectorXd::Zero(layout_.size)};
    for (size_t i = 0; i < tree_.links().size(); ++i) {
        const Link& link = tree_.links()[i];
        if (i == 0 && parameters_.root_given)
            continue;
        const int turning = link.type == LinkType::kFree ? 3 : link.count;
        const double rate2 =
            std::max(std::pow(parameters_.silent.least_rad_per_s, 2), now_.mean_square_rates[i]);
        for (int index = link.first + link.count - turning; index < link.first + link.count; ++index) {
            if (i > 0)
                blocks.push_back(pull(layout_.theta(index), -away[index], usual_variance_[index]));
            blocks.push_back(pull(layout_.rate(index), -now_.state.motion.rate[index],
                                  std::pow(parameters_.silent.rate_rad_per_s, 2)));
            blocks.push_back(pull(layout_.accel(index), -now_.state.motion.accel[index],
                                  std::pow(parameters_.silent.accel_rad_per_s2, 2)));
            // It may begin to turn at any time.
            widening.variance[layout_.rate(index)] = rate2;
            widening.variance[layout_.accel(index)] = rate2 / std::pow(parameters_.prior_interval_s, 2);
            widening.variance[layout_.theta(index)] =
                parameters_.prior_interval_s * parameters_.silent.turn_s * rate2;
        }
    }
    observe(std::move(blocks));
    now_.P.dense().diagonal() += widening.variance;
    if (tape_)
        tape_->push_back(std::move(widening));
}

void ManifoldFilter::predictAbout(const StepInput::About& about) {
    if (!now_.apart) {
        linearise(about.from);
        now_.relocated_s = seconds();
    }
    Eigen::VectorXd& apart = *now_.apart;
    BodyState expected = about.from;
    LinkTransitions transition =
        predictMotion(tree_, expected.motion, now_.P.dense(), step_s_, acceleration_decay_,
                      now_.motion_noise.variance(), LinkTransitions{tree_.freedoms()});
    transition.carry(apart);
    apart += errorBetween(tree_, layout_, about.to, expected);
    if (tape_)
        tape_->push_back(std::move(transition));
    now_.P.dense().diagonal() += wander_;
    now_.state = about.to;
    now_.fitted = now_.state.motion;
}

void ManifoldFilter::linearise(const BodyState& state) {
    fitErrors();
    const Eigen::VectorXd moved = errorBetween(tree_, layout_, now_.state, state);
    carryErrors(shiftOfErrors(tree_, moved));
    now_.apart = -moved;
    now_.state = state;
    now_.fitted = state.motion;
}

void ManifoldFilter::returnToEstimate() {
    if (!now_.apart)
        return;
    addError(tree_, layout_, *now_.apart, now_.state);
    now_.apart.reset();
}

Eigen::VectorXd ManifoldFilter::estimatedAccel() const {
    const Eigen::VectorXd& accel = now_.state.motion.accel;
    return now_.apart ? accel + now_.apart->segment(layout_.accel(0), layout_.freedoms) : accel;
}

}  // namespace noctule
