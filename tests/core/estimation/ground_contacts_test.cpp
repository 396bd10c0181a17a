// SPDX-License-Identifier: Apache-2.0
// What a foot on the ground tells the filter: derivatives, the floor, limits, treadmills.
#include "core/estimation/ground_contacts.h"

#include <gtest/gtest.h>

#include "tests/core/estimation/small_body.h"

namespace noctule {
namespace {

using testing::Gaussian;

/// A root on one leg.
struct OneLeg {
    OneLeg() {
        std::vector<Joint> joints;
        joints.push_back({"Hips", -1, {0, 0, 0}, JointType::kFree, {}, {}, {}});
        const auto dof = [](const char* name, const Vector3d& axis) { return DegreeOfFreedom{name, axis}; };
        joints.push_back(
            {"LeftUpLeg",
             0,
             {0.1, 0, 0},
             JointType::kBall,
             {dof("x", Vector3d::UnitX()), dof("y", Vector3d::UnitY()), dof("z", Vector3d::UnitZ())},
             {},
             {}});
        joints.push_back(
            {"LeftLeg", 1, {0, -0.4, 0}, JointType::kHinge, {dof("flexion", Vector3d::UnitX())}, {}, {}});
        joints.push_back({"LeftFoot",
                          2,
                          {0, -0.4, 0},
                          JointType::kUniversal,
                          {dof("inversion", Vector3d::UnitZ()), dof("flexion", Vector3d::UnitX())},
                          {},
                          {}});
        joints.push_back(
            {"LeftToeBase", 3, {0, -0.06, 0.13}, JointType::kFixed, {}, Vector3d(0, 0, 0.06), {}});
        skeleton = Skeleton::make(joints).value();
        tree = KinematicTree(skeleton, BallCoordinates::kManifold);
        for (const int joint : {0, 3})
            suit.boards.push_back({tree.linkOfJoint(joint), {0.01, 0.02, 0.05}});
        layout.freedoms = tree.freedoms();
        layout.size = 3 * layout.freedoms;
        state.motion = rest = tree.stateFromPose(skeleton.zeroPose());
        state.gyro_bias.assign(2, Vector3d::Zero());
        P = Covariance(Eigen::VectorXd::Constant(layout.size, 0.01));
    }

    /// As if the left foot stood all the time.
    std::vector<ObservationBlock> observe(GroundParameters parameters = {}) {
        parameters.given = {{"LeftFoot", {{0, 10, 0}}}};
        GroundContacts ground(skeleton, tree, suit, rest, parameters);
        return ground.observe(tree, layout, state, P, 1, log);
    }
    /// As moved by a small error of all its states.
    BodyState moved(const Eigen::VectorXd& error) const {
        BodyState other = state;
        const int n = layout.freedoms;
        tree.retract(other.motion, error.head(n));
        other.motion.rate += error.segment(n, n);
        other.motion.accel += error.segment(2 * n, n);
        return other;
    }

    Skeleton skeleton;
    KinematicTree tree;
    SuitModel suit;
    StateLayout layout;
    MotionState rest;
    BodyState state;
    Covariance P;
    ContactLog log;
};

/// The residuals of all rows by all states, by central differences.
Eigen::MatrixXd differences(OneLeg& body) {
    constexpr double kStep = 1e-5;
    const BodyState there = body.state;
    const auto residual = [&](const Eigen::VectorXd& error) {
        body.state = there;
        body.state = body.moved(error);
        const auto blocks = body.observe();
        body.state = there;
        Eigen::Vector4d all;
        all << blocks[0].residual, blocks[1].residual;
        return all;
    };
    Eigen::MatrixXd by_error(4, body.layout.size);
    for (Eigen::Index k = 0; k < body.layout.size; ++k) {
        const Eigen::VectorXd e = Eigen::VectorXd::Unit(body.layout.size, k) * kStep;
        by_error.col(k) = (residual(-e) - residual(e)) / (2 * kStep);
    }
    return by_error;
}

TEST(GroundContacts, theRootIsObservedAndTheBodyIsNoise) {
    OneLeg body;
    Gaussian random(7);
    constexpr double kVariance = 1e4;  // nothing is gated
    for (int trial = 0; trial < 5; ++trial) {
        body.state.motion = body.rest;
        body.tree.retract(body.state.motion, random.vector(body.layout.freedoms, 0.1));
        // On the ball or on the heel: a point that stays where it is on the foot.
        body.tree.retract(body.state.motion,
                          (trial % 2 ? 0.7 : -0.7) * Eigen::VectorXd::Unit(body.layout.freedoms, 3));
        body.state.motion.rate = random.vector(body.layout.freedoms, 0.3);
        const Eigen::MatrixXd A =
            Eigen::MatrixXd::NullaryExpr(body.layout.size, body.layout.size, [&] { return random(1.0); });
        const Eigen::MatrixXd P = kVariance * (A * A.transpose() / body.layout.size);
        body.P = Covariance(P.diagonal());
        body.P.dense() = P;  // correlated, so that signs count
        GroundParameters parameters;
        parameters.slip_lasts_s = 0;
        const auto blocks = body.observe(parameters);
        ASSERT_EQ(blocks.size(), 2U);
        Eigen::MatrixXd rest = differences(body);
        const MotionState& motion = body.state.motion;
        const Vector3d up_root = motion.q_parent_link[0].conjugate() * Vector3d::UnitY();
        rest.block<3, 3>(0, 3) -= (rest.block<3, 3>(0, 3) * up_root).eval() * up_root.transpose();
        int row = 0;
        for (const ObservationBlock& block : blocks)
            for (Eigen::Index i = 0; i < block.rows(); ++i, ++row) {
                for (Eigen::Index k = 0; k < block.H.cols(); ++k) {
                    const int column = block.columns[static_cast<size_t>(k)];
                    if (column >= 3 && column < 6) {  // turned together with its velocity it is as likely
                        const Vector3d turned = Vector3d::UnitY().cross(motion.rate.head<3>());
                        EXPECT_NEAR(block.H(i, k), -turned[i] * up_root[column - 3], 1e-12);
                        continue;
                    }
                    EXPECT_NEAR(block.H(i, k), rest(row, column), 1e-7);
                    rest(row, column) = 0;
                }
                const double expected = rest.row(row).dot(P * rest.row(row).transpose());
                EXPECT_NEAR(block.variance[i], expected, 1e-5 * expected) << "row " << row;
            }
    }
}

TEST(GroundContacts, aSlipThatLastsTellsLess) {
    OneLeg body;
    GroundParameters parameters;
    parameters.slip_lasts_s = 0;
    const auto alone = body.observe(parameters);
    parameters.slip_lasts_s = 0.1;
    const auto lasting = body.observe(parameters);
    // Of many updates that share an error of correlation r the mean has (1 + r) / (1 - r) times the variance.
    Gaussian random(4);
    const double r = std::exp(-parameters.interval_s / parameters.slip_lasts_s);
    double error = random(1.0), sum = 0, sum_of_squares = 0;
    constexpr int kMeans = 4000, kEach = 400;
    for (int mean = 0; mean < kMeans; ++mean) {
        sum = 0;
        for (int k = 0; k < kEach; ++k, error = r * error + random(std::sqrt(1 - r * r)))
            sum += error;
        sum_of_squares += sum * sum / kEach / kMeans;
    }
    EXPECT_NEAR(lasting[0].variance[0] / alone[0].variance[0], sum_of_squares, 0.08 * sum_of_squares);
    EXPECT_EQ(lasting[1].variance, alone[1].variance);
}

TEST(GroundContacts, anotherProgramsNameOfAFootIsKnown) {
    OneLeg body;
    std::vector<Joint> joints = body.skeleton.joints();
    joints[3].aliases["mixamo"] = "mixamorig:LeftFoot";
    const Skeleton named = Skeleton::make(joints).value();
    for (const char* name : {"LeftFoot", "mixamorig:LeftFoot", "RightFoot"}) {
        GroundParameters parameters;
        parameters.given = {{name, {{0, 10, 0}}}};
        body.log = {};
        GroundContacts ground(named, body.tree, body.suit, body.rest, parameters);
        ground.observe(body.tree, body.layout, body.state, body.P, 1, body.log);
        EXPECT_EQ(body.log.feet().size(), std::string(name) == "RightFoot" ? 0U : 1U) << name;
    }
}

TEST(GroundContacts, theFeetStandInTheRestPose) {
    OneLeg body;
    GroundContacts found(body.skeleton, body.tree, body.suit, body.rest, {});
    found.rest(0.5, 2, body.log);
    ASSERT_EQ(body.log.feet().size(), 1U);
    EXPECT_EQ(body.log.feet()[0].contacts.front().from_s, 0.5);
    EXPECT_EQ(body.log.feet()[0].contacts.front().to_s, 2);
    found.observe(body.tree, body.layout, body.state, body.P, 2.01, body.log);
    ASSERT_EQ(body.log.feet()[0].contacts.size(), 1U) << "it goes on";
    EXPECT_EQ(body.log.feet()[0].contacts.front().to_s, 2.01);
    // An operator who has cleared it is believed.
    GroundParameters parameters;
    parameters.given = {{"LeftFoot", {{1.5, 3, 0}}}};
    body.log = {};
    GroundContacts given(body.skeleton, body.tree, body.suit, body.rest, parameters);
    given.rest(0.5, 2, body.log);
    EXPECT_EQ(body.log.feet()[0].contacts.front().from_s, 1.5);
}

TEST(GroundContacts, updatesStopTheFootAndPutItOnTheFloor) {
    OneLeg body;
    body.state.motion.rate[0] = 0.2;
    body.state.motion.p_world_root.y() += 0.04;
    const int n = body.layout.freedoms;
    for (int k = 0; k < 480; ++k) {  // a slip lasts: each counts as a seventh of white noise's
        const Eigen::VectorXd delta = body.P.update(body.observe());
        body.tree.retract(body.state.motion, delta.head(n));
        body.state.motion.rate += delta.segment(n, n);
    }
    ChainMotion chain;
    chain.evaluate(body.tree, body.state.motion, body.tree.linkOfJoint(3), 0);
    const auto toes = chain.point({0, -0.06, 0.13});
    EXPECT_LT(toes.v_m_per_s.norm(), 0.01);
    EXPECT_NEAR(toes.p_m.y(), -0.86, 0.01);
}

TEST(GroundContacts, groundDecidesWhatIsHeld) {
    OneLeg body;
    const auto count = [&](Ground ground, bool holds_feet) {
        GroundParameters parameters;
        parameters.ground = ground;
        parameters.holds_feet = holds_feet;
        body.log = {};
        const size_t blocks = body.observe(parameters).size();
        return std::pair(blocks, body.log.feet().size());
    };
    EXPECT_EQ(count(Ground::kLevel, true), std::pair(size_t{2}, size_t{1}));
    EXPECT_EQ(count(Ground::kUneven, true), std::pair(size_t{1}, size_t{1}));
    EXPECT_EQ(count(Ground::kTreadmill, true), std::pair(size_t{0}, size_t{1}));
    EXPECT_EQ(count(Ground::kNone, true), std::pair(size_t{0}, size_t{0}));
    EXPECT_EQ(count(Ground::kLevel, false), std::pair(size_t{0}, size_t{1}));
}

TEST(GroundContacts, aStepIsNotPulledToTheFloor) {
    OneLeg body;
    body.P = Covariance(Eigen::VectorXd::Constant(body.layout.size, 1e-4));
    const double y_m = body.state.motion.p_world_root.y();
    for (const double stair_m : {0.17, 0.25, 0.5, -0.17}) {
        body.state.motion.p_world_root.y() = y_m + stair_m;
        EXPECT_EQ(body.observe().size(), 1U) << stair_m;
    }
    body.state.motion.p_world_root.y() = y_m + 0.06;
    EXPECT_EQ(body.observe().size(), 2U) << "what a filter may have drifted";
}

TEST(GroundContacts, aHeightKnownBetterThanFloorsAreLevelIsNotPulledToTheFloor) {
    OneLeg body;
    body.state.motion.p_world_root.y() += 0.02;  // as people stand in a recording
    body.P = Covariance(Eigen::VectorXd::Constant(body.layout.size, 0.005 * 0.005));
    const int height = body.layout.theta(1);
    EXPECT_EQ(body.observe().size(), 1U) << "it stands still, wherever the floor is";
    EXPECT_EQ(body.P.dense()(height, height), 0.005 * 0.005) << "its height stays as sure";
    body.P = Covariance(Eigen::VectorXd::Constant(body.layout.size, 0.02 * 0.02));
    EXPECT_EQ(body.observe().size(), 2U);
}

TEST(GroundContacts, withoutBoardsOnTheFeetTheLowestOnesCount) {
    OneLeg body;
    body.suit.boards = {{body.tree.linkOfJoint(0)}, {body.tree.linkOfJoint(1)}, {body.tree.linkOfJoint(2)}};
    GroundParameters parameters;
    parameters.given = {{"LeftLeg", {{0, 10, 0}}}, {"Hips", {{0, 10, 0}}}, {"LeftUpLeg", {{0, 10, 0}}}};
    GroundContacts ground(body.skeleton, body.tree, body.suit, body.rest, parameters);
    ground.observe(body.tree, body.layout, body.state, body.P, 1, body.log);
    ASSERT_EQ(body.log.feet().size(), 1U);
    EXPECT_EQ(body.log.feet().front().foot, "LeftLeg");
}

TEST(GroundContacts, aShortFlightIsPartOfTheContact) {
    ContactLog log;
    log.note("LeftFoot", 1.0, 1.1);
    log.note("LeftFoot", 1.0, 1.2);
    log.note("LeftFoot", 1.23, 1.3);
    log.note("LeftFoot", 1.5, 1.6);
    ASSERT_EQ(log.feet().size(), 1U);
    ASSERT_EQ(log.feet()[0].contacts.size(), 2U);
    EXPECT_EQ(log.feet()[0].contacts[0].from_s, 1.0);
    EXPECT_EQ(log.feet()[0].contacts[0].to_s, 1.3);
}

}  // namespace
}  // namespace noctule
