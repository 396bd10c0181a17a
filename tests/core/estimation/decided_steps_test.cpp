// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/decided_steps.h"

#include <gtest/gtest.h>

namespace noctule {
namespace {

/// What a filter observed of a free root and of one state, in this order.
DecidedStep stepOfFreeRoot(double rate) {
    StateLayout layout;
    layout.freedoms = 6;
    MotionState motion;
    motion.q_parent_link = {Quaterniond::Identity()};
    motion.rate = VectorXd::Constant(6, rate);
    DecidedStep step;
    step.acceleration_variance = VectorXd::Constant(6, 0.5);
    step.updates = {{velocityOfRoot(layout, motion, {0.1, 0.2, 0.3}, {1, 2, 3}), pull(7, 0.4, 0.04)}};
    for (ObservationBlock& block : step.updates[0])
        block.origin.target = block.residual;
    step.time_ns = 1000;
    return step;
}

TEST(DecidedSteps, AreReadBackAsTheyWereKept) {
    DecidedSteps steps(UnnamedFile::make(::testing::TempDir(), "steps", "").value());
    steps.beginStretch();
    for (const double rate : {0.0, 2.0})
        steps.add(stepOfFreeRoot(rate));
    steps.goTo(0);
    for (int count = 0; count < 2; ++count) {
        DecidedStep step;
        ASSERT_TRUE(steps.next(step));
        EXPECT_EQ(step.time_ns, 1000);
        ASSERT_EQ(step.updates.size(), 1u);
        ASSERT_EQ(step.updates[0].size(), 2u);
        const ObservationBlock &root = step.updates[0][0], &single = step.updates[0][1];
        EXPECT_EQ(root.columns, (std::vector<int>{6, 7, 8}));
        EXPECT_EQ(root.origin.target, Vector3d(0.1, 0.2, 0.3));
        EXPECT_EQ(root.variance, Vector3d(1, 2, 3));
        EXPECT_EQ(single.columns, std::vector<int>{7});
        EXPECT_EQ(single.variance[0], 0.04);
    }
    DecidedStep beyond;
    EXPECT_FALSE(steps.next(beyond));
}

}  // namespace
}  // namespace noctule
