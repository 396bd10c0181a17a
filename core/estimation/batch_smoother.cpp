// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/batch_smoother.h"

#include <algorithm>
#include <cmath>

#include "core/estimation/gauss_newton_stretch.h"

namespace noctule {
namespace {

constexpr double kLeastShare = 1.0 / 32;  // of a step of Gauss-Newton

}  // namespace

BatchSmoother::BatchSmoother(const Skeleton& skeleton, SuitModel suit, const ManifoldParameters& parameters,
                             BatchFiles files, const BatchParameters& batch)
    : SmoothingFilter(skeleton, std::move(suit), parameters),
      batch_(batch),
      steps_(std::move(files.steps)),
      motion_(std::move(files.trajectory), filter_.tree(), filter_.layout()),
      marks_(std::move(files.marks)),
      steps_per_stretch_(std::max<int64_t>(1, std::llround(batch.stretch_s / filter_.stepSeconds()))) {}

void BatchSmoother::start(const Pose& rest_pose, const RestReadings& rest, const RootMeasurement* root) {
    SmoothingFilter::start(rest_pose, rest, root);
    problem_.emplace(filter_);
    first_index_ = filter_.memory().step_index;
    motion_.add(filter_.state());
    steps_.beginStretch();
    begin(Phase::kLinearise);
}

void BatchSmoother::advanceTo(double time_s) {
    FilterTape tape;
    filter_.setTape(&tape);
    for (; filter_.isDue(time_s); tape.clear()) {
        if (steps_.stepsOf(stretches() - 1) == steps_per_stretch_)
            steps_.beginStretch();
        DecidedStep step;
        step.input = filter_.nextInput();
        step.acceleration_variance = filter_.memory().motion_noise.variance();
        filter_.step(step.input);
        step.note(tape);
        steps_.add(step);
        motion_.add(filter_.state());
    }
    filter_.setTape(nullptr);
    left_ = portionsFromHere();
}

void BatchSmoother::begin(Phase phase) {
    phase_ = phase;
    stretch_ = phase == Phase::kLinearise || phase == Phase::kJudge ? 0 : stretches() - 1;
    if (phase == Phase::kLinearise)
        estimate_ = problem_->prior(motion_.at(0));
    if (phase == Phase::kImprove)
        adjoint_ = AdjointPass(filter_.layout().size);
    if (phase == Phase::kShow)
        backward_ = BackwardPass(filter_.layout().size);
    if (phase == Phase::kJudge)
        trial_cost_ = problem_->priorCost(motion_.at(0));
}

/// At most: fewer passes may do.
int BatchSmoother::portionsFromHere() const {
    const int all = stretches(), forward = all - stretch_, back = stretch_ + 1;
    const int passes = settled_ ? 0 : batch_.most_passes - static_cast<int>(report_.costs.size());
    switch (phase_) {
        case Phase::kLinearise:
            return forward + all + (settled_ ? 0 : (3 * passes) * all);
        case Phase::kImprove:
            return back + all + (3 * passes - 1) * all;
        case Phase::kJudge:
            return forward + (3 * passes - 1) * all;
        case Phase::kShow:
            return back;
    }
    return 0;
}

Status BatchSmoother::finishPortion(const JobContext& job) {
    const Status done = workOnStretch(job);
    if (done)
        left_ = std::min(left_, portionsFromHere());
    return done;
}

Status BatchSmoother::workOnStretch(const JobContext& job) {
    const bool forward = phase_ == Phase::kLinearise || phase_ == Phase::kJudge;
    const Status done = phase_ == Phase::kLinearise ? linearise(job)
                        : phase_ == Phase::kImprove ? improve(job)
                        : phase_ == Phase::kJudge   ? judge(job)
                                                    : show(job);
    if (!done)
        return done;
    stretch_ += forward ? 1 : -1;
    if (stretch_ == stretches() || (stretch_ < 0 && phase_ != Phase::kShow))
        endPhase();
    return Done{};
}

void BatchSmoother::endPhase() {
    if (phase_ == Phase::kLinearise)
        return begin(settled_ ? Phase::kShow : Phase::kImprove);
    if (phase_ == Phase::kJudge)
        return decide();
    motion_.setShare(1);
    begin(Phase::kJudge);
}

/// The motion with its corrections has a cost now.
void BatchSmoother::decide() {
    if (!(trial_cost_ < cost_)) {
        motion_.setShare(motion_.share() / 2);
        if (motion_.share() >= kLeastShare)
            return begin(Phase::kJudge);
        motion_.setShare(0);
        return settle(Report::End::kNoStepGains);
    }
    const double gain = cost_ - trial_cost_;
    cost_ = trial_cost_;
    report_.costs.push_back(cost_);
    if (gain < batch_.settled * cost_)
        return settle(Report::End::kSettled);
    if (std::ssize(report_.costs) >= batch_.most_passes)
        return settle(Report::End::kMostPasses);
    begin(Phase::kLinearise);
}

void BatchSmoother::settle(Report::End end) {
    report_.end = end;
    settled_ = true;
    begin(Phase::kLinearise);
}

template <class Each>
Status BatchSmoother::forEachStep(const JobContext& job, const Each& each) {
    steps_.goTo(stretch_);
    int64_t index = stretch_ * steps_per_stretch_;
    BodyState from = motion_.at(index);
    DecidedStep step;
    for (int64_t left = steps_.stepsOf(stretch_); left > 0; --left) {
        if (job.cancelled())
            return JobContext::cancelledError();
        BodyState to = motion_.at(++index);
        if (!steps_.next(step) || !motion_.good())
            return unreadableSpool();
        each(step, Leg{from, to, timeOf(index)}, index);
        from = std::move(to);
    }
    return Done{};
}

void BatchSmoother::putMark() {
    const Eigen::MatrixXd& P = estimate_.P.dense();
    marks_.seek(stretch_ * static_cast<int64_t>(sizeof(double)) * (P.size() + P.rows()));
    marks_.putBytes(estimate_.error.data(), sizeof(double) * static_cast<size_t>(P.rows()));
    marks_.putBytes(P.data(), sizeof(double) * static_cast<size_t>(P.size()));
}

Status BatchSmoother::goToMark() {
    Eigen::MatrixXd& P = estimate_.P.dense();
    const bool kept = marks_.good();
    marks_.seek(stretch_ * static_cast<int64_t>(sizeof(double)) * (P.size() + P.rows()));
    if (!kept || !marks_.takeBytes(estimate_.error.data(), sizeof(double) * static_cast<size_t>(P.rows())) ||
        !marks_.takeBytes(P.data(), sizeof(double) * static_cast<size_t>(P.size())))
        return unreadableSpool();
    return Done{};
}

Status BatchSmoother::linearise(const JobContext& job) {
    putMark();
    return forEachStep(job, [&](const DecidedStep& step, const Leg& leg, int64_t) {
        problem_->filterStep(step, leg, estimate_, nullptr);
    });
}

Status BatchSmoother::improve(const JobContext& job) {
    if (Status read = goToMark(); !read)
        return read;
    const int64_t first = stretch_ * steps_per_stretch_;
    std::vector<BodyState> states{motion_.at(first)};
    GaussNewtonStretch stretch(*problem_, estimate_);
    const auto pass = [&](const DecidedStep& step, const Leg& leg, int64_t) {
        stretch.pass(step, leg);
        states.push_back(leg.to);
    };
    if (Status done = forEachStep(job, pass); !done)
        return done;
    const std::vector<Eigen::VectorXd> errors = stretch.errors(adjoint_);
    for (size_t i = stretch_ == 0 ? 0 : 1; i < states.size(); ++i)
        motion_.replace(first + static_cast<int64_t>(i), states[i], errors[i]);
    return Done{};
}

Status BatchSmoother::judge(const JobContext& job) {
    return forEachStep(job, [&](const DecidedStep& step, const Leg& leg, int64_t) {
        trial_cost_ += problem_->stepCost(step, leg);
    });
}

Status BatchSmoother::show(const JobContext& job) {
    if (Status read = goToMark(); !read)
        return read;
    const auto frame = [&](std::vector<int64_t> times_ns, const BodyState& state, double flesh_rad2) {
        tape_.push_back(TapedFrame{std::move(times_ns),
                                   state.motion,
                                   {},
                                   estimate_.P.dense().topRows(filter_.layout().freedoms),
                                   flesh_rad2});
    };
    if (stretch_ == 0 && !rest_times_ns_.empty())
        frame(rest_times_ns_, motion_.at(0), 0);
    const auto filter = [&](const DecidedStep& step, const Leg& leg, int64_t) {
        problem_->filterStep(step, leg, estimate_, &tape_);
        if (step.is_frame)
            frame({step.time_ns}, leg.to, step.flesh_rad2);
    };
    if (Status done = forEachStep(job, filter); !done)
        return done;
    if (!goBack(backward_, std::numeric_limits<int64_t>::max(), job, Shown::kAsTaped))
        return JobContext::cancelledError();
    tape_.clear();
    return Done{};
}

}  // namespace noctule
