// SPDX-License-Identifier: Apache-2.0
// The most probable motion of a whole take, all readings known: the reference solution that the filter and
// the fixed-interval smoother approximate, for they linearise every reading once, about what was known when
// it came. Here the filter decides in its first time over the data which readings to believe and how far;
// from then on that stays, and MapProblem's cost is brought to its minimum by Gauss-Newton steps, each a
// smoother linearised about the motion found before. A step that would raise the cost is halved. The first
// step starts at the filter's estimates, so what it gives is Rauch, Tung and Striebel's but for where
// readings are linearised. Sigmas are those at the solution.
//
// Nothing long is held in memory: a stretch of two seconds takes 100 MB; about 3 MB a second of the default
// suit's take are put aside. Two or three passes do on a take, each two to three times as long as the filter
// takes.
#pragma once

#include <optional>

#include "core/estimation/map_problem.h"
#include "core/estimation/smoothing_filter.h"
#include "core/estimation/trajectory_spool.h"

namespace noctule {

struct BatchParameters {
    double stretch_s = 2;
    int most_passes = 8;
    double settled = 1e-5;  ///< a smaller gain, as a share of the cost, is the last
};

/// Files in which the smoother puts aside what memory should not hold.
struct BatchFiles {
    UnnamedFile steps, trajectory, marks;
};

class BatchSmoother : public SmoothingFilter {
public:
    BatchSmoother(const Skeleton& skeleton, SuitModel suit, const ManifoldParameters& parameters,
                  BatchFiles files, const BatchParameters& batch = {});

    void start(const Pose& rest_pose, const RestReadings& rest, const RootMeasurement* root) override;
    void advanceTo(double time_s) override;
    int portionsLeft() const override { return left_; }
    Status finishPortion(const JobContext& job) override;

    struct Report {
        enum class End { kSettled, kNoStepGains, kMostPasses };
        std::vector<double> costs;  ///< after each pass
        End end = End::kMostPasses;
    };
    const Report& report() const { return report_; }
    /// The motion found, the steps and the cost that it is the minimum of.
    TrajectorySpool& motion() { return motion_; }
    DecidedSteps& steps() { return steps_; }
    const MapProblem& problem() const { return *problem_; }

private:
    /// kLinearise: the filter goes forward about the motion and leaves marks. kImprove: back over the
    /// stretches, for the motion's corrections. kJudge: their cost. kShow: back once more, for the poses.
    enum class Phase { kLinearise, kImprove, kJudge, kShow };

    int stretches() const { return steps_.stretches(); }
    void begin(Phase phase);
    int portionsFromHere() const;
    Status workOnStretch(const JobContext& job);
    void endPhase();
    Status linearise(const JobContext& job);
    Status improve(const JobContext& job);
    Status judge(const JobContext& job);
    Status show(const JobContext& job);
    void decide();
    void settle(Report::End end);
    /// Calls each(step, leg, index) for the steps of the stretch at work.
    template <class Each>
    Status forEachStep(const JobContext& job, const Each& each);
    double timeOf(int64_t index) const {
        return static_cast<double>(first_index_ + index) * filter_.stepSeconds();
    }
    /// The filter's estimate at the begin of the stretch at work.
    void putMark();
    Status goToMark();

    BatchParameters batch_;
    DecidedSteps steps_;
    TrajectorySpool motion_;
    UnnamedFile marks_;
    int64_t steps_per_stretch_;
    int64_t first_index_ = 0;  ///< the filter's step index at the start
    std::optional<MapProblem> problem_;

    Phase phase_ = Phase::kLinearise;
    bool settled_ = false;  ///< only the poses are left to be shown
    int stretch_ = 0;       ///< at work
    MapProblem::Estimate estimate_;
    AdjointPass adjoint_;
    BackwardPass backward_;
    double cost_ = std::numeric_limits<double>::infinity(), trial_cost_ = 0;
    Report report_;
    int left_ = 0;
};

}  // namespace noctule
