// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/joint_give.h"

#include <gtest/gtest.h>

#include "core/math/rotation.h"
#include "tests/core/estimation/small_body.h"
#include "tests/support/jacobian_checker.h"

namespace noctule {
namespace {

using Eigen::VectorXd;

/// The small body whose universal and hinge joints give.
class JointGiveTest : public ::testing::Test {
protected:
    JointGiveTest()
        : actor(testing::smallSkeleton()),
          giving(givingSkeleton(actor, gives)),
          tree(giving, BallCoordinates::kManifold),
          P(VectorXd::Constant(3 * tree.freedoms(), 1e-8)),
          give(actor, tree, gives, gives, {}) {}

    /// Arm and forearm moved by their own freedoms, then by `off_rad` of what they lack.
    MotionState at(double time_s, double off_rad) const {
        Pose pose = actor.zeroPose();
        const double a = std::sin(time_s), b = std::cos(0.7 * time_s);
        pose.q_parent_joint[2] = axisAngle(Vector3d::UnitZ(), a) * axisAngle(Vector3d::UnitX(), off_rad) *
                                 axisAngle(Vector3d::UnitY(), b);
        pose.q_parent_joint[3] = axisAngle(Vector3d::UnitY(), 1 + b) * axisAngle(Vector3d::UnitX(), off_rad);
        return tree.stateFromPose(pose);
    }

    double largestResidual(const std::vector<ObservationBlock>& blocks) const {
        double largest = 0;
        for (const ObservationBlock& block : blocks)
            largest = std::max(largest, std::abs(block.residual[0]));
        return largest;
    }

    /// Ten seconds in which the joints give by `amplitude_rad`.
    std::vector<ObservationBlock> observed(double amplitude_rad) { return observed(give, amplitude_rad); }
    std::vector<ObservationBlock> observed(JointGive& by, double amplitude_rad) const {
        std::vector<ObservationBlock> last;
        for (int k = 1; k <= 100; ++k)
            last = by.observe(at(0.1 * k, amplitude_rad * std::sin(0.6 * k)), P, 0.1);
        return last;
    }

    const std::vector<bool> gives{false, false, true, true};
    Skeleton actor, giving;
    KinematicTree tree;
    Covariance P;
    JointGive give;
};

TEST_F(JointGiveTest, WhatTheActorsJointsCanDoIsNoDeviation) {
    const auto blocks = give.initial(at(0.8, 0));
    EXPECT_EQ(blocks.size(), 3u);  // one direction of the universal joint, two of the hinge
    EXPECT_LT(largestResidual(blocks), 1e-12);
    EXPECT_NEAR(largestResidual(give.initial(at(0.8, 0.05))), 0.05, 0.001);
}

class JointGiveFarOff : public JointGiveTest, public ::testing::WithParamInterface<double> {};

TEST_P(JointGiveFarOff, JacobiansEqualDifferences) {
    const MotionState state = at(0.8, GetParam());
    const auto blocks = give.initial(state);
    for (size_t i = 0; i < blocks.size(); ++i) {
        Eigen::MatrixXd full = Eigen::MatrixXd::Zero(1, tree.freedoms());
        for (size_t k = 0; k < blocks[i].columns.size(); ++k)
            full.col(blocks[i].columns[k]) = blocks[i].H.col(static_cast<Eigen::Index>(k));
        testing::expectJacobian(
            [&](const VectorXd& delta) -> VectorXd {
                MotionState moved = state;
                tree.retract(moved, delta);
                return -give.initial(moved)[i].residual;
            },
            full, "constraint " + std::to_string(i));
    }
}

INSTANTIATE_TEST_SUITE_P(Deviations, JointGiveFarOff, ::testing::Values(0.0, 1e-4, 0.07, 1.5, 2.8));

TEST_F(JointGiveTest, AHingeTurnedNearlyRoundIsFarOffAndLost) {
    const auto turned = give.initial(at(0.8, 2.8));
    EXPECT_NEAR(std::hypot(turned[1].residual[0], turned[2].residual[0]), 2.8, 1e-9)
        << "and not the sine of it, 0.33";
    EXPECT_TRUE(give.lostLinks(at(0.8, 0.3)).empty());
    const int forearm = tree.linkOfJoint(3);
    EXPECT_EQ(give.lostLinks(at(0.8, 2.8)), std::vector<int>{forearm});
    const auto blocks = give.observe(at(0.8, 2.8), P, 0.1);
    EXPECT_LT(blocks[1].variance[0] + blocks[2].variance[0], 0.1) << "it is to come back at once";
}

TEST_F(JointGiveTest, JointsThatNeverGiveBecomeRigid) {
    for (const ObservationBlock& block : observed(0))
        EXPECT_LT(std::sqrt(block.variance[0]), 0.001);
    EXPECT_LT(give.fleshShare(), 0.001);
    EXPECT_LT(std::sqrt(give.meanVariance_rad2()), 0.001);
}

TEST_F(JointGiveTest, JointsThatGiveAreBelievedTo) {
    observed(0.08);
    EXPECT_GT(give.fleshShare(), 0.7);
    const double rms_rad = 0.08 / std::sqrt(2.0);
    EXPECT_GT(std::sqrt(give.meanVariance_rad2()), 0.7 * rms_rad);
    EXPECT_LT(std::sqrt(give.meanVariance_rad2()), 2 * rms_rad);
}

TEST_F(JointGiveTest, ADeviationThatStaysIsPulledBackSlowlyWhereJointsGive) {
    const auto blocks = observed(0.08);
    // Ten seconds of observations, were they all of another error, would pull to a fifth of what is given.
    for (const ObservationBlock& block : blocks)
        EXPECT_GT(std::sqrt(block.variance[0] / 100), 0.5 * std::sqrt(give.meanVariance_rad2()));
}

TEST_F(JointGiveTest, NoJointGivesFarForLong) {
    observed(0.05);
    const double lasting_rad = GiveParameters{}.lasting_rad;
    const MotionState far = at(0.8, 0.5);
    const auto before = give.initial(far);  // the whole deviations
    const auto blocks = give.observe(far, P, 0.1);
    int turned_back = 0;
    for (size_t i = 0; i < blocks.size(); ++i) {
        const double whole = before[i].residual[0], counts = blocks[i].residual[0];
        EXPECT_EQ(give.again(blocks[i].origin, far).residual[0], counts);
        if (std::abs(whole) < lasting_rad) {
            EXPECT_EQ(counts, whole);
            continue;
        }
        ++turned_back;
        EXPECT_NEAR(std::abs(counts), std::abs(whole) - lasting_rad, 1e-12);
        EXPECT_GT(counts * whole, 0);
        EXPECT_LT(blocks[i].variance[0], 0.1);
    }
    EXPECT_GT(turned_back, 0);
}

TEST_F(JointGiveTest, WhatASegmentWithoutGyroscopeHidesCountsAsTheSeenJoints) {
    JointGive partly(actor, tree, gives, {false, false, true, false}, {});
    const auto blocks = observed(partly, 0.08);
    JointGive arm(actor, tree, {false, false, true, false}, {false, false, true, false}, {});
    observed(arm, 0.08);
    EXPECT_DOUBLE_EQ(partly.fleshShare(), arm.fleshShare()) << "only what is seen teaches";
    EXPECT_DOUBLE_EQ(partly.meanVariance_rad2(), arm.meanVariance_rad2());
    ASSERT_EQ(blocks.size(), 3u);
    for (size_t i : {1u, 2u}) {
        EXPECT_GT(blocks[i].variance[0], partly.meanVariance_rad2()) << "the hinge is not taken for rigid";
        EXPECT_LT(blocks[i].variance[0], 3 * partly.meanVariance_rad2()) << "nor may it stay away";
    }
}

TEST_F(JointGiveTest, WithNothingSeenHiddenJointsAreRigid) {
    JointGive hidden(actor, tree, gives, {false, false, false, false}, {});
    for (const ObservationBlock& block : observed(hidden, 0.08))
        EXPECT_LT(std::sqrt(block.variance[0]), 0.001);
}

/// Ball joints alone teach nothing. Taken for rigid, boards on people made a filter sure of wrong poses.
TEST(JointGiveUntaught, ActorsOfBallJointsAloneRideOnFlesh) {
    std::vector<Joint> joints = testing::smallSkeleton().joints();
    for (size_t j = 1; j < joints.size(); ++j) {
        joints[j].type = JointType::kBall;
        joints[j].dof = {{"x", Vector3d::UnitX()}, {"y", Vector3d::UnitY()}, {"z", Vector3d::UnitZ()}};
    }
    const Skeleton balls = Skeleton::make(joints).value();
    const KinematicTree tree(balls, BallCoordinates::kManifold);
    const std::vector<bool> all(4, true), none(4, false);
    JointGive give(balls, tree, all, {false, true, true, true}, {});
    EXPECT_EQ(give.fleshShare(), 1);
    const Covariance P(Eigen::VectorXd::Constant(3 * tree.freedoms(), 1e-6));
    EXPECT_TRUE(give.observe(tree.stateFromPose(balls.zeroPose()), P, 0.1).empty());
    EXPECT_EQ(give.fleshShare(), 1);
    EXPECT_NEAR(std::sqrt(give.meanVariance_rad2()), GiveParameters{}.untaught_rad, 1e-12);
    EXPECT_EQ(JointGive(balls, tree, none, none, {}).fleshShare(), 0) << "nothing is worn that tells more";
}

/// Boards that see none of the actor's hinges do not count as riding on flesh for that.
TEST_F(JointGiveTest, HingesThatNoBoardSeesAreNoBallJoints) {
    const std::vector<bool> all(4, true);
    JointGive unseen(testing::smallSkeleton(), tree, all, {false, true, false, false}, {});
    EXPECT_EQ(unseen.fleshShare(), 0);
}

/// held() is the constraint of an error of the limb's attitude, at both of the limb's ends.
TEST_F(JointGiveTest, HeldDirectionsAreTheConstraintsOfATurnedLimb) {
    const MotionState motion = at(0.7, 0.2);
    const Quaterniond D = axisAngle(Vector3d(1, 2, -1).normalized(), 0.6);
    for (const int joint : {2, 3}) {
        const int link = tree.linkOfJoint(joint);
        MotionState turned = motion;
        turned.q_parent_link[static_cast<size_t>(link)] = motion.q_parent_link[static_cast<size_t>(link)] * D;
        if (joint == 2)  // the forearm stays as it lies in the world
            turned.q_parent_link[static_cast<size_t>(tree.linkOfJoint(3))] =
                D.conjugate() * motion.q_parent_link[static_cast<size_t>(tree.linkOfJoint(3))];
        std::vector<double> before, after;
        for (const auto& held : give.held(tree, link, motion))
            before.push_back(held.c - held.a.dot(D * held.b));
        for (const auto& held : give.held(tree, link, turned))
            after.push_back(held.c - held.a.dot(held.b));
        ASSERT_EQ(before.size(), joint == 2 ? 5u : 4u);
        ASSERT_EQ(before.size(), after.size());
        for (size_t i = 0; i < before.size(); ++i)
            EXPECT_NEAR(before[i], after[i], 1e-12);
    }
}

TEST_F(JointGiveTest, OneFarDeviationAfterAnOutageTeachesLittle) {
    observed(0);
    give.observe(at(10.1, 0.6), P, 0.1);
    EXPECT_LT(give.fleshShare(), 0.001);
}

}  // namespace
}  // namespace noctule
