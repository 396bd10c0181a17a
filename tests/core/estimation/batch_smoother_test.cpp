// SPDX-License-Identifier: Apache-2.0
// The most probable motion: that it is one (the cost has no slope there, by differences of the cost alone),
// what it gains where linearising once is not enough, and that nothing is gained where it is.
#include "core/estimation/batch_smoother.h"

#include "tests/core/estimation/judged_run.h"

namespace noctule {
namespace {

using Eigen::VectorXd;
using testing::judge;
using testing::Judged;
using testing::spool;
using testing::World;

std::unique_ptr<BatchSmoother> batchOf(const ManifoldParameters& parameters, const BatchParameters& batch) {
    const World world(parameters, 1);
    return std::make_unique<BatchSmoother>(testing::smallSkeleton(), world.suit, parameters,
                                           BatchFiles{spool(), spool(), spool()}, batch);
}

/// Where the filter begins far off and linearises its first readings there.
ManifoldParameters farOff() {
    ManifoldParameters parameters = testing::fittingParameters({true, true, true}, true);
    parameters.initial_pose_rad = 0.2;
    return parameters;
}

/// A motion and its problem, in memory.
struct Solved {
    explicit Solved(BatchSmoother& smoother) : problem(smoother.problem()) {
        for (int64_t i = 0; i < smoother.motion().size(); ++i)
            states.push_back(smoother.motion().at(i));
        for (int stretch = 0; stretch < smoother.steps().stretches(); ++stretch) {
            smoother.steps().goTo(stretch);
            for (int64_t left = smoother.steps().stepsOf(stretch); left > 0; --left) {
                steps.emplace_back();
                EXPECT_TRUE(smoother.steps().next(steps.back()));
            }
        }
    }
    /// Of what depends on the state `index`.
    double costAround(size_t index) const {
        double cost = index == 0 ? problem.priorCost(states[0]) : stepCost(index);
        if (index + 1 < states.size())
            cost += stepCost(index + 1);
        return cost;
    }
    double stepCost(size_t index) const {
        const double step_s = 1.0 / (140 * 4);
        return problem.stepCost(steps[index - 1],
                                {states[index - 1], states[index], static_cast<double>(index) * step_s});
    }
    double wholeCost() const {
        double cost = problem.priorCost(states[0]);
        for (size_t index = 1; index < states.size(); ++index)
            cost += stepCost(index);
        return cost;
    }

    const MapProblem& problem;
    std::vector<BodyState> states;
    std::vector<DecidedStep> steps;
};

struct Slope {
    double slope = 0, curvature = 0;
    /// The step to the minimum along this direction, in its standard deviations.
    double sigmas() const { return std::abs(slope) / std::sqrt(curvature); }
};

/// By central differences; `cost(x)` along a line, `scale` about a standard deviation.
template <class Cost>
Slope slopeAtZero(const Cost& cost, double scale) {
    const double h = 0.1 * scale, ahead = cost(h), behind = cost(-h);
    return {(ahead - behind) / (2 * h), (ahead + behind - 2 * cost(0)) / (h * h)};
}

/// The worst of many directions: every state of some steps by itself, every constant in all steps at once.
double steepest(Solved& solved, const KinematicTree& tree, const StateLayout& layout) {
    const Eigen::Index n = layout.freedoms;
    VectorXd scale = VectorXd::Constant(layout.size, 1e-3);
    scale.segment(n, n).setConstant(0.01);
    scale.segment(2 * n, n).setConstant(1);
    double worst = 0;
    const auto along = [&](size_t first, size_t end, Eigen::Index place, const auto& cost) {
        const std::vector<BodyState> kept(solved.states.begin() + static_cast<long>(first),
                                          solved.states.begin() + static_cast<long>(end));
        const auto at = [&](double x) {
            for (size_t i = first; i < end; ++i) {
                solved.states[i] = kept[i - first];
                addError(tree, layout, x * VectorXd::Unit(layout.size, place), solved.states[i]);
            }
            return cost();
        };
        const Slope slope = slopeAtZero(at, scale[place]);
        at(0);
        EXPECT_GT(slope.curvature, 0) << "state " << place;
        worst = std::max(worst, slope.sigmas());
    };
    for (size_t index = 0; index < solved.states.size(); index += 37)
        for (Eigen::Index place = 0; place < 3 * n; ++place)
            along(index, index + 1, place, [&] { return solved.costAround(index); });
    for (Eigen::Index place = 3 * n; place < layout.size; ++place)
        along(0, solved.states.size(), place, [&] { return solved.wholeCost(); });
    return worst;
}

TEST(BatchSmoother, TheCostHasNoSlopeAtTheSolution) {
    const ManifoldParameters parameters = farOff();
    ManifoldFilter filter(testing::smallSkeleton(), World(parameters, 1).suit, parameters);
    double slope_once = 0;
    for (const int passes : {1, 12}) {
        const auto smoother = batchOf(parameters, {0.3, passes, 1e-12});
        judge(*smoother, parameters, 4, 0.75);
        const std::vector<double>& costs = smoother->report().costs;
        Solved solved(*smoother);
        EXPECT_NEAR(solved.wholeCost(), costs.back(), 1e-7 * costs.back());
        const double slope = steepest(solved, filter.tree(), filter.layout());
        std::printf("%d passes: cost", static_cast<int>(std::ssize(costs)));
        for (const double cost : costs)
            std::printf(" %.6f", cost);
        std::printf(", steepest slope %.2g\n", slope);
        EXPECT_TRUE(std::ranges::is_sorted(costs, std::greater<>()));
        if (passes == 1)
            slope_once = slope;
        else
            EXPECT_LT(slope, 1e-3 * slope_once);
    }
}

TEST(BatchSmoother, GainsWhereTheFilterBeganFarOff) {
    const ManifoldParameters parameters = farOff();
    double filter_deg = 0, full_deg = 0, batch_deg = 0, nees = 0;
    constexpr int kRuns = 6;
    for (unsigned seed = 1; seed <= kRuns; ++seed) {
        const World world(parameters, seed);
        ManifoldFilter filter(testing::smallSkeleton(), world.suit, parameters);
        FixedIntervalSmoother full(testing::smallSkeleton(), world.suit, parameters, spool());
        const auto batch = batchOf(parameters, {});
        filter_deg += judge(filter, parameters, seed, 1, 0).rms_deg / kRuns;
        full_deg += judge(full, parameters, seed, 1, 0).rms_deg / kRuns;
        const Judged judged = judge(*batch, parameters, seed, 1, 0);
        batch_deg += judged.rms_deg / kRuns;
        nees += judged.nees / kRuns;
    }
    std::printf("degrees rms: filter %.4f, full %.4f, batch %.4f; NEES %.2f\n", filter_deg, full_deg,
                batch_deg, nees);
    EXPECT_LT(batch_deg, full_deg);
    EXPECT_GT(nees, 0.65);
    EXPECT_LT(nees, 1.4);
}

TEST(BatchSmoother, IsTheOtherSmootherWhereLinearisingOnceIsEnough) {
    const ManifoldParameters parameters = testing::fittingParameters({true, true, true}, true);
    const World world(parameters, 1);
    FixedIntervalSmoother full(testing::smallSkeleton(), world.suit, parameters, spool());
    const auto batch = batchOf(parameters, {0.31, 8, 1e-5});
    const Judged one = judge(full, parameters, 5, 2), other = judge(*batch, parameters, 5, 2);
    EXPECT_EQ(batch->report().end, BatchSmoother::Report::End::kSettled);
    ASSERT_EQ(one.poses.size(), other.poses.size());
    for (size_t i = 0; i < one.poses.size(); ++i) {
        ASSERT_EQ(one.poses[i].time_ns, other.poses[i].time_ns);
        for (size_t k = 0; k < one.poses[i].sigma_rad.size(); ++k) {
            EXPECT_NEAR(other.poses[i].sigma_rad[k], one.poses[i].sigma_rad[k],
                        0.05 * one.poses[i].sigma_rad[k]);
            EXPECT_LT(one.poses[i].pose->q_parent_joint[k / 3].angularDistance(
                          other.poses[i].pose->q_parent_joint[k / 3]),
                      radians(0.05));
        }
    }
}

TEST(BatchSmoother, StretchesLeaveNoSeam) {
    const ManifoldParameters parameters = farOff();
    const auto one = batchOf(parameters, {1e6, 3, 0}), many = batchOf(parameters, {0.13, 3, 0});
    const Judged whole = judge(*one, parameters, 5, 1), pieces = judge(*many, parameters, 5, 1);
    ASSERT_EQ(whole.poses.size(), pieces.poses.size());
    EXPECT_EQ(whole.poses.front().time_ns, 0);
    for (size_t i = 0; i < whole.poses.size(); ++i)
        for (size_t j = 0; j < whole.poses[i].pose->q_parent_joint.size(); ++j)
            EXPECT_LT(whole.poses[i].pose->q_parent_joint[j].angularDistance(
                          pieces.poses[i].pose->q_parent_joint[j]),
                      1e-7);
}

TEST(BatchSmoother, CancelledAtAnyPortion) {
    const ManifoldParameters parameters = testing::fittingParameters({true, true, true}, true);
    for (const int before : {0, 2, 4}) {
        const auto batch = batchOf(parameters, {0.5, 2, 0});
        World world(parameters, 1);
        batch->start(testing::smallSkeleton().zeroPose(), {}, nullptr);
        testing::play(world, *batch, 1, [&](int64_t, double t) { batch->advanceTo(t); });
        for (int portion = 0; portion < before; ++portion) {
            const int left = batch->portionsLeft();
            ASSERT_TRUE(batch->finishPortion({}));
            EXPECT_LT(batch->portionsLeft(), left);
        }
        CancelFlag flag;
        flag.cancel();
        const Status cancelled = batch->finishPortion({nullptr, &flag});
        ASSERT_FALSE(cancelled);
        EXPECT_EQ(cancelled.error().kind, ErrorKind::kCancelled);
        EXPECT_TRUE(batch->takePoses().empty());
    }
}

}  // namespace
}  // namespace noctule
