// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/heading_shift.h"

#include <gtest/gtest.h>

#include "core/estimation/error_state.h"
#include "core/math/rotation.h"
#include "tests/core/estimation/adjoint_law.h"

namespace noctule {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing::Gaussian;

struct TwoEstimates {
    explicit TwoEstimates(unsigned seed) : random(seed) {
        layout.freedoms = tree.freedoms();
        layout.size = 3 * layout.freedoms + 2;
        before.motion = after.motion = tree.stateFromPose(testing::smallSkeleton().zeroPose());
        for (BodyState* state : {&before, &after}) {
            tree.retract(state->motion, random.vector(layout.freedoms, 0.7));
            state->motion.rate = random.vector(layout.freedoms, 2);
            state->motion.accel = random.vector(layout.freedoms, 5);
        }
    }
    /// What turning the whole body about the vertical makes of its state, per radian.
    VectorXd turning(const BodyState& state, bool place = false) const {
        constexpr double kTurn_rad = 1e-6;
        BodyState turned = state;
        const Quaterniond turn = expQuaternion(kTurn_rad * Vector3d::UnitY());
        turned.motion.q_parent_link[0] = turn * state.motion.q_parent_link[0];
        if (place)
            turned.motion.p_world_root = turn * state.motion.p_world_root;
        turned.motion.rate.head<3>() = turn * Vector3d(state.motion.rate.head<3>());
        turned.motion.accel.head<3>() = turn * Vector3d(state.motion.accel.head<3>());
        return errorBetween(tree, layout, state, turned) / kTurn_rad;
    }

    Gaussian random;
    KinematicTree tree{testing::smallSkeleton(), BallCoordinates::kManifold};
    StateLayout layout;
    BodyState before, after;
};

TEST(HeadingShift, ATurnOfTheBodyStaysOne) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        const TwoEstimates two(seed);
        const VectorXd turning = two.turning(two.before), expected = two.turning(two.after);
        MatrixXd P = turning * turning.transpose();
        HeadingShift(two.before.motion, two.after.motion).carry(P);
        EXPECT_LT((P - expected * expected.transpose()).norm(), 1e-4);
        EXPECT_GT((P - turning * turning.transpose()).norm(), 1) << "nothing was to do";
    }
}

TEST(HeadingShift, AmongOthersThePlaceTurnsAlong) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        const TwoEstimates two(seed);
        const VectorXd turning = two.turning(two.before, true), expected = two.turning(two.after, true);
        const HeadingShift shift(two.before.motion, two.after.motion, true);
        MatrixXd P = turning * turning.transpose();
        shift.carry(P);
        EXPECT_LT((P - expected * expected.transpose()).norm(), 1e-4);
        MatrixXd C = turning.transpose();
        shift.timesTransposed(C);
        EXPECT_LT((C - expected.transpose()).norm(), 1e-4);
        EXPECT_GT((two.after.motion.p_world_root - two.before.motion.p_world_root).norm(), 0.1);
    }
}

TEST(HeadingShift, GoesBackByItsAdjoint) {
    TwoEstimates two(4);
    testing::expectAdjoint(HeadingShift(two.before.motion, two.after.motion, true), two.layout.size,
                           two.random);
    testing::expectAdjoint(HeadingShift(two.before.motion, two.after.motion), two.layout.size, two.random);
}

}  // namespace
}  // namespace noctule
