// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/smoothing_filter.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace noctule {
namespace {

constexpr int64_t kAll = std::numeric_limits<int64_t>::max();

const TapedFrame* frameOf(const FilterTape::value_type& event) {
    return std::get_if<TapedFrame>(&event);
}

}  // namespace

bool goBackOver(const FilterTape& tape, BackwardPass& backward, const EachSmoothed& each, int64_t last_ns) {
    for (auto event = tape.rbegin(); event != tape.rend(); ++event) {
        const auto goBack = [&](const auto& change) {
            using Change = std::decay_t<decltype(change)>;
            if constexpr (!std::is_same_v<Change, TapedFrame> && !std::is_same_v<Change, Widening>)
                backward.back(change);
        };
        std::visit(goBack, *event);
        if (const TapedFrame* frame = frameOf(*event); frame && frame->times_ns.back() <= last_ns) {
            if (!each(*frame, backward.smooth(frame->P_pose)))
                return false;
        }
    }
    return true;
}

void SmoothingFilter::start(const Pose& rest_pose, const RestReadings& rest, const RootMeasurement* root) {
    filter_.start(rest_pose, rest, root);
    for (const TimedPose& pose : filter_.takePoses())
        rest_times_ns_.push_back(pose.time_ns);
}

bool SmoothingFilter::goBack(BackwardPass& backward, int64_t last_ns, const JobContext& job, Shown shown) {
    std::vector<TimedPose> newest_first;
    const auto each = [&](const TapedFrame& frame, const BackwardPass::Smoothed& smoothed) {
        const Eigen::VectorXd error = (shown == Shown::kCorrected ? 1.0 : 0.0) * smoothed.error;
        for (auto time_ns = frame.times_ns.rbegin(); time_ns != frame.times_ns.rend(); ++time_ns)
            newest_first.push_back(filter_.poseOf(frame, *time_ns, error, smoothed.covariance));
        return !job.cancelled();
    };
    if (!goBackOver(tape_, backward, each, last_ns))
        return false;
    std::move(newest_first.rbegin(), newest_first.rend(), std::back_inserter(poses_));
    return true;
}

FixedIntervalSmoother::FixedIntervalSmoother(const Skeleton& skeleton, SuitModel suit,
                                             const ManifoldParameters& parameters, UnnamedFile spool,
                                             double stretch_s)
    : SmoothingFilter(skeleton, std::move(suit), parameters),
      spool_(std::move(spool)),
      steps_per_stretch_(std::max<int64_t>(1, std::llround(stretch_s / filter_.stepSeconds()))),
      backward_(filter_.layout().size) {}

void FixedIntervalSmoother::start(const Pose& rest_pose, const RestReadings& rest,
                                  const RootMeasurement* root) {
    SmoothingFilter::start(rest_pose, rest, root);
    spool_.mark(filter_.memory());
    left_ = 1;
}

void FixedIntervalSmoother::advanceTo(double time_s) {
    for (; filter_.isDue(time_s); resets_ = filter_.resets()) {
        if (spool_.steps() >= steps_per_stretch_) {
            spool_.mark(filter_.memory());
            ++left_;
        }
        const ManifoldFilter::StepInput input = filter_.nextInput();
        spool_.add(input);
        filter_.step(input);
        filter_.takePoses();
    }
    contacts_ = filter_.contacts();  // as of the first time over the data
}

Status FixedIntervalSmoother::finishPortion(const JobContext& job) {
    auto memory = spool_.goTo(left_ - 1);
    if (!memory)
        return memory.error();
    filter_.recall(*memory);
    tape_.clear();
    if (left_ == 1 && !rest_times_ns_.empty())
        tape_.push_back(filter_.frame(rest_times_ns_));
    filter_.setTape(&tape_);
    for (ManifoldFilter::StepInput input; spool_.next(input);) {
        if (job.cancelled())
            return JobContext::cancelledError();
        filter_.step(input);
    }
    filter_.setTape(nullptr);
    if (const Status read = spool_.status(); !read)
        return read;
    filter_.takeDecisions();  // those came out the first time
    if (!goBack(backward_, kAll, job))
        return JobContext::cancelledError();
    tape_.clear();
    --left_;
    return Done{};
}

FixedLagSmoother::FixedLagSmoother(const Skeleton& skeleton, SuitModel suit,
                                   const ManifoldParameters& parameters, double lag_s, double stride_s)
    : SmoothingFilter(skeleton, std::move(suit), parameters),
      lag_ns_(std::llround(lag_s * 1e9)),
      stride_ns_(std::llround(stride_s * 1e9)) {}

void FixedLagSmoother::start(const Pose& rest_pose, const RestReadings& rest, const RootMeasurement* root) {
    SmoothingFilter::start(rest_pose, rest, root);
    filter_.setTape(&tape_);
    if (!rest_times_ns_.empty())
        tape_.push_back(filter_.frame(rest_times_ns_));
}

void FixedLagSmoother::advanceTo(double time_s) {
    while (filter_.isDue(time_s)) {
        filter_.step(filter_.nextInput());
        const TapedFrame* newest = tape_.empty() ? nullptr : frameOf(tape_.back());
        const auto oldest = std::ranges::find_if(tape_, frameOf);
        if (!newest || newest->times_ns.back() - frameOf(*oldest)->times_ns.back() < lag_ns_)
            continue;
        const int64_t last_ns = newest->times_ns.back() - lag_ns_ + stride_ns_;
        BackwardPass backward(filter_.layout().size);
        goBack(backward, last_ns, {});
        const auto waits = [&](const FilterTape::value_type& event) {
            return frameOf(event) && frameOf(event)->times_ns.back() > last_ns;
        };
        tape_.erase(tape_.begin(), std::ranges::find_if(tape_, waits));
    }
}

Status FixedLagSmoother::finishPortion(const JobContext& job) {
    BackwardPass backward(filter_.layout().size);
    if (!goBack(backward, kAll, job))
        return JobContext::cancelledError();
    tape_.clear();
    return Done{};
}

}  // namespace noctule
