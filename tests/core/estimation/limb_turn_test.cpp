// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/limb_turn.h"

#include <gtest/gtest.h>

#include "core/estimation/error_state.h"
#include "core/estimation/joint_give.h"
#include "core/math/rotation.h"
#include "tests/core/estimation/adjoint_law.h"

namespace noctule {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing::Gaussian;

/// The small body with ball joints throughout, somewhere and in motion.
struct LimbTurn : ::testing::Test {
    LimbTurn() {
        layout.freedoms = tree.freedoms();
        layout.size = 3 * layout.freedoms + 2;
        before = somewhere();
        after = somewhere();
    }
    MotionState somewhere() {
        MotionState motion = tree.stateFromPose(testing::smallSkeleton().zeroPose());
        tree.retract(motion, random.vector(layout.freedoms, 0.7));
        motion.rate = random.vector(layout.freedoms, 8);
        motion.accel = random.vector(layout.freedoms, 50);
        return motion;
    }
    MotionState plus(const MotionState& motion, const VectorXd& error) const {
        BodyState state;
        state.motion = motion;
        VectorXd padded = VectorXd::Zero(layout.size);
        padded.head(error.size()) = error;
        addError(tree, layout, padded, state);
        return state.motion;
    }
    struct Seen {
        Matrix3d R_world_link;
        Vector3d omega_link, alpha_link;
    };
    /// By the kinematics that predict readings, which know nothing of limbs' turns.
    Seen seen(const MotionState& motion, int link) const {
        ChainMotion chain;
        chain.evaluate(tree, motion, link, 0);
        const auto& end = chain.end();
        return {end.R_world_link, end.R_world_link.transpose() * end.omega_rad_per_s,
                end.R_world_link.transpose() * end.alpha_rad_per_s2};
    }

    Gaussian random{5};
    KinematicTree tree{givingSkeleton(testing::smallSkeleton(), {false, false, true, true}),
                       BallCoordinates::kManifold};
    StateLayout layout;
    MotionState before, after;
    std::vector<bool> all = std::vector<bool>(4, true);
};

constexpr double kSmall_rad = 1e-6;

TEST_F(LimbTurn, NoGyroscopeNoticesIt) {
    const int chest = 1;
    const Vector3d turn(1, -2, 0.5);
    const VectorXd error = LimbTurns(tree, before).errorOf(tree, chest, all) * turn;
    const MotionState turned = plus(before, kSmall_rad * error);
    for (int link = 0; link < 4; ++link) {
        const Seen then = seen(before, link), now = seen(turned, link);
        EXPECT_LT((now.omega_link - then.omega_link).norm(), 1e-3 * kSmall_rad) << link;
        EXPECT_LT((now.alpha_link - then.alpha_link).norm(), 1e-2 * kSmall_rad) << link;
        const Vector3d by =
            logQuaternion(Quaterniond(Matrix3d(then.R_world_link.transpose() * now.R_world_link)));
        EXPECT_LT((by - ((link == chest ? kSmall_rad : 0.0) * turn)).norm(), 1e-3 * kSmall_rad) << link;
    }
    EXPECT_GT(error.segment(layout.freedoms, layout.freedoms).norm(), 1) << "rates had nothing to do";
}

TEST_F(LimbTurn, WhatNothingHoldsGoesAlong) {
    std::vector<bool> stays = all;
    stays[2] = false;
    const VectorXd error = LimbTurns(tree, before).errorOf(tree, 1, stays) * Vector3d(1, -2, 0.5);
    const MotionState turned = plus(before, kSmall_rad * error);
    EXPECT_GT(
        angleBetween(Quaterniond(seen(before, 2).R_world_link), Quaterniond(seen(turned, 2).R_world_link)),
        kSmall_rad);
    EXPECT_LT(
        angleBetween(Quaterniond(seen(before, 3).R_world_link), Quaterniond(seen(turned, 3).R_world_link)),
        1e-3 * kSmall_rad);
}

TEST_F(LimbTurn, FarTurnsKeepWhatGyroscopesRead) {
    const int chest = 1;
    const VectorXd straight = LimbTurns(tree, before).errorOf(tree, chest, all) * Vector3d(0.8, -0.5, 0.4);
    const MotionState turned = plus(before, bendTurns(tree, before, straight)),
                      unbent = plus(before, straight);
    for (const int link : {1, 2, 3}) {
        const Seen then = seen(before, link), now = seen(turned, link);
        EXPECT_LT((now.omega_link - then.omega_link).norm(), 1e-9) << link;
        EXPECT_LT((now.alpha_link - then.alpha_link).norm(), 1e-8) << link;
    }
    EXPECT_GT((seen(unbent, chest).omega_link - seen(before, chest).omega_link).norm(), 0.5);
}

TEST_F(LimbTurn, StaysOneAfterACorrection) {
    for (const int link : {1, 2, 3}) {
        const Vector3d turn_world(0.3, 1, -0.5);
        const auto errorAt = [&](const MotionState& motion) {
            VectorXd error = VectorXd::Zero(layout.size);
            error.head(3 * layout.freedoms) = LimbTurns(tree, motion).errorOf(tree, link, all) *
                                              (seen(motion, link).R_world_link.transpose() * turn_world);
            return error;
        };
        const VectorXd turning = errorAt(before), expected = errorAt(after);
        MatrixXd P = turning * turning.transpose();
        limbShift(tree, LimbTurns(tree, before), LimbTurns(tree, after)).carry(P);
        EXPECT_LT((P - expected * expected.transpose()).norm(), 1e-9 * expected.squaredNorm()) << link;
        EXPECT_GT((P - turning * turning.transpose()).norm(), 1) << "nothing was to do";
    }
}

TEST_F(LimbTurn, GoesBackByItsAdjoint) {
    testing::expectAdjoint(limbShift(tree, LimbTurns(tree, before), LimbTurns(tree, after)), layout.size,
                           random);
}

}  // namespace
}  // namespace noctule
