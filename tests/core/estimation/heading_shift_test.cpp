// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/heading_shift.h"

#include <gtest/gtest.h>

#include "core/estimation/error_state.h"
#include "core/math/rotation.h"
#include "tests/core/estimation/small_body.h"

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
    VectorXd turning(const BodyState& state) const {
        constexpr double kTurn_rad = 1e-6;
        BodyState turned = state;
        const Quaterniond turn = expQuaternion(kTurn_rad * Vector3d::UnitY());
        turned.motion.q_parent_link[0] = turn * state.motion.q_parent_link[0];
        turned.motion.rate.head<3>() = turn * Vector3d(state.motion.rate.head<3>());
        turned.motion.accel.head<3>() = turn * Vector3d(state.motion.accel.head<3>());
        return errorBetween(tree, layout, state, turned) / kTurn_rad;
    }
    MatrixXd symmetric() {
        const MatrixXd A = MatrixXd::NullaryExpr(layout.size, layout.size, [this] { return random(1.0); });
        return A * A.transpose();
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

TEST(HeadingShift, GoesBackByItsAdjoint) {
    TwoEstimates two(4);
    const HeadingShift shift(two.before.motion, two.after.motion);
    const MatrixXd P = two.symmetric(), Lambda = two.symmetric();
    MatrixXd carried = P, back = Lambda;
    shift.carry(carried);
    shift.carryBack(back);
    EXPECT_NEAR((Lambda * carried).trace(), (back * P).trace(), 1e-9 * (back * P).trace());
    const VectorXd lambda = two.random.vector(two.layout.size, 1);
    VectorXd lambda_back = lambda;
    MatrixXd square_back = lambda * lambda.transpose();
    shift.carryBack(lambda_back);
    shift.carryBack(square_back);
    EXPECT_LT((square_back - lambda_back * lambda_back.transpose()).norm(), 1e-9 * square_back.norm());
}

}  // namespace
}  // namespace noctule
