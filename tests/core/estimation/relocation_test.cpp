// SPDX-License-Identifier: Apache-2.0
// A world that moves as the filter assumes, whose suit is silent for a while.
#include "core/estimation/relocation.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/estimation/smoothing_filter.h"
#include "tests/core/estimation/judged_run.h"

namespace noctule {
namespace {

using testing::judge;
using testing::Judged;
using testing::World;

constexpr double kSilent_s = 1, kBack_s = 1.4, kEnd_s = 2.7;

/// Passes on what sensors say outside of the silence.
class BehindABrokenLink : public Estimator {
public:
    explicit BehindABrokenLink(Estimator& estimator, double back_s = kBack_s)
        : BehindABrokenLink(estimator, back_s, back_s) {}
    BehindABrokenLink(Estimator& estimator, double first_board_back_s, double back_s)
        : estimator_(estimator), first_board_back_s_(first_board_back_s), back_s_(back_s) {}

    void start(const Pose& rest_pose, const RestReadings& rest, const RootMeasurement* root) override {
        estimator_.start(rest_pose, rest, root);
    }
    void add(const InertialMeasurement& measurement) override {
        if (isHeard(measurement.time_s) ||
            (measurement.board == 0 && measurement.time_s > first_board_back_s_))
            estimator_.add(measurement);
    }
    void add(const DistanceMeasurement& measurement) override {
        if (isHeard(measurement.arrival_s))
            estimator_.add(measurement);
    }
    void add(const RootMeasurement& measurement) override { estimator_.add(measurement); }
    void advanceTo(double time_s) override { estimator_.advanceTo(time_s); }
    void end() override { estimator_.end(); }
    std::vector<TimedPose> takePoses() override { return estimator_.takePoses(); }
    std::vector<DistanceDecision> takeDecisions() override { return estimator_.takeDecisions(); }
    int resets() const override { return estimator_.resets(); }
    int portionsLeft() const override { return estimator_.portionsLeft(); }
    Status finishPortion(const JobContext& job) override { return estimator_.finishPortion(job); }

private:
    bool isHeard(double time_s) const { return time_s < kSilent_s || time_s > back_s_; }
    Estimator& estimator_;
    double first_board_back_s_, back_s_;
};

ManifoldParameters livelyParameters(int rounds) {
    ManifoldParameters parameters = testing::fittingParameters({true, true, true}, true);
    parameters.joint_accel_rad_per_s2 = 2;  // half a radian within the silence
    parameters.relocation.rounds = rounds;
    return parameters;
}

struct Spread {
    double rms_deg = 0, nees = 0;
};

/// From 0.1 s after the suit is heard again; means of so many worlds.
Spread afterTheSilence(int rounds, double first_board_back_s = kBack_s) {
    constexpr int kRuns = 8;
    const ManifoldParameters parameters = livelyParameters(rounds);
    Spread spread;
    for (unsigned seed = 1; seed <= kRuns; ++seed) {
        World world(parameters, seed);
        ManifoldFilter filter(testing::smallSkeleton(), world.suit, parameters);
        BehindABrokenLink heard(filter, first_board_back_s, kBack_s);
        const Judged judged = judge(heard, parameters, seed, kEnd_s, (kBack_s + 0.1) / kEnd_s);

        spread.rms_deg += judged.rms_deg / kRuns;
        spread.nees += judged.nees / kRuns;
    }
    std::printf("%d rounds: %.2f degrees rms, NEES %.2f\n", rounds, spread.rms_deg, spread.nees);
    return spread;
}

TEST(Relocation, FindsTheBodyAfterASilenceAndIsHonest) {
    const Spread found = afterTheSilence(2), not_looked_for = afterTheSilence(0);
    EXPECT_LT(found.rms_deg, 0.5 * not_looked_for.rms_deg);
    EXPECT_LT(found.nees, 2);
    EXPECT_GT(not_looked_for.nees, 5) << "the test asks for nothing";
}

TEST(Relocation, OneBoardThatComesBackFirstIsNotTheSuit) {
    const Spread found = afterTheSilence(2, kBack_s - 0.15);
    EXPECT_LT(found.rms_deg, 0.5 * afterTheSilence(0).rms_deg);
    EXPECT_LT(found.nees, 2);
}

TEST(Relocation, AStretchThatBeginsAmidItIsFilteredAgainToTheBit) {
    const ManifoldParameters parameters = livelyParameters(2);
    World world(parameters, 1);
    FixedIntervalSmoother one(testing::smallSkeleton(), world.suit, parameters, testing::spool(), 1e6);
    FixedIntervalSmoother many(testing::smallSkeleton(), world.suit, parameters, testing::spool(), 0.13);
    BehindABrokenLink one_heard(one), many_heard(many);
    const Judged whole = judge(one_heard, parameters, 5, kEnd_s),
                 pieces = judge(many_heard, parameters, 5, kEnd_s);
    ASSERT_EQ(whole.poses.size(), pieces.poses.size());
    for (size_t i = 0; i < whole.poses.size(); ++i) {
        EXPECT_EQ(whole.poses[i].pose->p_world_root, pieces.poses[i].pose->p_world_root);
        EXPECT_EQ(whole.poses[i].sigma_rad, pieces.poses[i].sigma_rad);
    }
}

/// Sigmas grow over the silence, more than twofold, and shrink when the suit is heard again.
TEST(Relocation, SigmasTellOfTheSilence) {
    const ManifoldParameters parameters = livelyParameters(2);
    World world(parameters, 1);
    ManifoldFilter filter(testing::smallSkeleton(), world.suit, parameters);
    BehindABrokenLink heard(filter);
    const Judged judged = judge(heard, parameters, 1, kEnd_s);
    const auto sigmaAt = [&](double time_s) {
        const auto pose = std::ranges::find_if(judged.poses, [&](const TimedPose& p) {
            return static_cast<double>(p.time_ns) * 1e-9 >= time_s;
        });
        return *std::ranges::max_element(pose->sigma_rad);
    };
    EXPECT_GT(sigmaAt(kBack_s - 0.02), 2 * sigmaAt(kSilent_s - 0.02));
    EXPECT_LT(sigmaAt(kBack_s + 1), 0.5 * sigmaAt(kBack_s - 0.02));
}

TEST(Relocation, ASuitThatIsBackJustBeforeTheEndHasPosesUpToIt) {
    const ManifoldParameters parameters = livelyParameters(2);
    World world(parameters, 1);
    ManifoldFilter filter(testing::smallSkeleton(), world.suit, parameters);
    BehindABrokenLink heard(filter, kEnd_s - 0.1);
    const Judged judged = judge(heard, parameters, 1, kEnd_s);
    EXPECT_NEAR(static_cast<double>(judged.poses.back().time_ns) * 1e-9, kEnd_s, 0.03);
    for (const TimedPose& pose : judged.poses)
        EXPECT_TRUE(pose.pose->p_world_root.allFinite());
    size_t after = 0;
    for (const DistanceDecision& decision : filter.takeDecisions())
        after += decision.fate == RangeFate::kUsed;
    EXPECT_GT(after, 0u);
}

}  // namespace
}  // namespace noctule
