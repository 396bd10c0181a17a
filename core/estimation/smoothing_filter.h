// SPDX-License-Identifier: Apache-2.0
// The manifold filter with poses that know what came later, those of the whole take (fixed interval) or of
// half a second (fixed lag): a BackwardPass over what the filter really did, with its own linearisation,
// weights, gates and widened covariances. Sigmas are those of the smoothed poses.
#pragma once

#include <functional>
#include <limits>

#include "core/estimation/backward_pass.h"
#include "core/estimation/step_spool.h"

namespace noctule {

/// Goes back over a tape; `each` is given every frame up to `last_ns` and what is then known of its error,
/// the newest first, and ends it by returning false.
using EachSmoothed = std::function<bool(const TapedFrame& frame, const BackwardPass::Smoothed& smoothed)>;
bool goBackOver(const FilterTape& tape, BackwardPass& backward, const EachSmoothed& each,
                int64_t last_ns = std::numeric_limits<int64_t>::max());

/// What both have in common: a filter driven by steps, its tape, and going back over it.
class SmoothingFilter : public Estimator {
public:
    void start(const Pose& rest_pose, const RestReadings& rest, const RootMeasurement* root) override;
    void add(const InertialMeasurement& measurement) override { filter_.add(measurement); }
    void add(const DistanceMeasurement& measurement) override { filter_.add(measurement); }
    void add(const RootMeasurement& measurement) override { filter_.add(measurement); }
    void end() override { filter_.end(); }
    std::vector<TimedPose> takePoses() override { return std::exchange(poses_, {}); }
    std::vector<DistanceDecision> takeDecisions() override { return filter_.takeDecisions(); }
    std::vector<FootContacts> contacts() const override { return filter_.contacts(); }
    int resets() const override { return filter_.resets(); }

protected:
    SmoothingFilter(const Skeleton& skeleton, SuitModel suit, const ManifoldParameters& parameters)
        : filter_(skeleton, std::move(suit), parameters) {}

    /// kAsTaped: the motion is the smoothed one already, only sigmas are to be found.
    enum class Shown { kCorrected, kAsTaped };
    /// Goes back over the tape; poses of its frames up to `last_ns` come out, in order of time. False when
    /// the job was cancelled.
    bool goBack(BackwardPass& backward, int64_t last_ns, const JobContext& job,
                Shown shown = Shown::kCorrected);

    ManifoldFilter filter_;
    FilterTape tape_;
    /// The instants before the filter's first step; the pose of them all is that of its start.
    std::vector<int64_t> rest_times_ns_;

private:
    std::vector<TimedPose> poses_;
};

/// Fixed interval. A tape takes 50 MB a second: inputs and, every `stretch_s`, the filter's memory go to a
/// spool. At the end each stretch is filtered again, the last one first, and gone back over; poses come out
/// stretch by stretch.
class FixedIntervalSmoother : public SmoothingFilter {
public:
    FixedIntervalSmoother(const Skeleton& skeleton, SuitModel suit, const ManifoldParameters& parameters,
                          UnnamedFile spool, double stretch_s = 2);

    void start(const Pose& rest_pose, const RestReadings& rest, const RootMeasurement* root) override;
    void advanceTo(double time_s) override;
    std::vector<FootContacts> contacts() const override { return contacts_; }
    int resets() const override { return resets_; }
    int portionsLeft() const override { return left_; }
    Status finishPortion(const JobContext& job) override;

private:
    StepSpool spool_;
    int64_t steps_per_stretch_;
    BackwardPass backward_;
    int left_ = 0;
    int resets_ = 0;
    std::vector<FootContacts> contacts_;
};

/// Fixed lag: every `stride_s` the last `lag_s` of the tape are gone over. A pose knows of at least lag_s -
/// stride_s that follow, and waits for lag_s at most; a shorter stride costs lag_s / stride_s times the work.
class FixedLagSmoother : public SmoothingFilter {
public:
    FixedLagSmoother(const Skeleton& skeleton, SuitModel suit, const ManifoldParameters& parameters,
                     double lag_s = 0.5, double stride_s = 0.2);

    void start(const Pose& rest_pose, const RestReadings& rest, const RootMeasurement* root) override;
    void advanceTo(double time_s) override;
    int portionsLeft() const override { return tape_.empty() ? 0 : 1; }
    Status finishPortion(const JobContext& job) override;

private:
    int64_t lag_ns_, stride_ns_;
};

}  // namespace noctule
