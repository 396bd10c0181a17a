// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/observation.h"

#include <gtest/gtest.h>

#include "core/estimation/error_state.h"
#include "core/math/rotation.h"
#include "tests/core/estimation/small_body.h"
#include "tests/support/jacobian_checker.h"

namespace noctule {
namespace {

using Eigen::VectorXd;
using testing::Gaussian;

class Observation : public ::testing::TestWithParam<double> {
protected:
    Observation() : tree(testing::smallSkeleton(), BallCoordinates::kManifold) {
        suit = mountSuit(testing::smallSuit(), {}, testing::actorOf(testing::smallSkeleton()), tree).value();
        const int n = tree.freedoms();
        layout.freedoms = n;
        layout.gyro_bias = 3 * n;
        layout.accel_bias = layout.gyro_bias + 12;
        layout.source_offset = layout.accel_bias + 12;
        layout.sound_scale = layout.source_offset + 2;
        layout.size = layout.sound_scale + 1;
        const double size = GetParam();
        state.motion = tree.stateFromPose(testing::smallSkeleton().zeroPose());
        tree.retract(state.motion, random.vector(n, size));
        state.motion.rate = random.vector(n, 3 * size);
        state.motion.accel = random.vector(n, 20 * size);
        for (int b = 0; b < 4; ++b) {
            state.gyro_bias.push_back(random.vector(0.1));
            state.accel_bias.push_back(random.vector(0.3));
        }
        state.source_offset_m = {0.001, -0.002};
        state.sound_scale = 0.003;
    }

    BodyState perturbed(const VectorXd& d) const {
        BodyState moved = state;
        addError(tree, layout, d, moved);
        return moved;
    }

    void check(const std::function<ObservationBlock(const BodyState&)>& observe, const std::string& what) {
        const ObservationBlock block = observe(state);
        Eigen::MatrixXd full = Eigen::MatrixXd::Zero(block.rows(), layout.size);
        for (size_t k = 0; k < block.columns.size(); ++k)
            full.col(block.columns[k]) += block.H.col(static_cast<Eigen::Index>(k));
        testing::expectJacobian(
            [&](const VectorXd& d) -> VectorXd { return -observe(perturbed(d)).residual; }, full, what, 1e-6);
    }

    InertialMeasurement reading(int board) {
        InertialMeasurement m;
        m.board = board;
        for (int i = 0; i < 3; ++i) {
            // Slightly skewed axes, as a calibrated triad has.
            m.gyro.add({(Vector3d::Unit(i) + random.vector(0.02)).normalized(), 0.3, 0.01});
            if (i != 1)  // an axis may be missing
                m.accel.add({(Vector3d::Unit(i) + random.vector(0.02)).normalized(), 1.0, 0.1});
        }
        return m;
    }

    Gaussian random{17};
    KinematicTree tree;
    SuitModel suit;
    StateLayout layout;
    BodyState state;
};

TEST_P(Observation, GyroscopeAndAccelerometerJacobians) {
    ObservationModel model(tree, suit, layout);
    for (int board = 0; board < 4; ++board)
        for (double offset_s : {0.0, 0.0035, -0.006}) {
            const InertialMeasurement m = reading(board);
            check([&](const BodyState& s) { return model.gyro(s, m, offset_s); },
                  "gyro " + std::to_string(board));
            check([&](const BodyState& s) { return model.accel(s, m, offset_s).block; },
                  "accel " + std::to_string(board));
        }
}

TEST_P(Observation, DistanceJacobians) {
    ObservationModel model(tree, suit, layout);
    for (int board = 0; board < 4; ++board)
        for (int source = 0; source < 2; ++source) {
            DistanceMeasurement m;
            m.board = board;
            m.source = source;
            m.distance_m = 0.4;
            m.sigma_m = 0.001;
            check([&](const BodyState& s) { return model.distance(s, m, -0.006, -0.002).block; },
                  "distance " + std::to_string(board) + std::to_string(source));
        }
}

TEST_P(Observation, DistanceWithinOneRigidSegmentSeesNoMotion) {
    state.motion.rate.setZero();
    state.motion.accel.setZero();
    ObservationModel model(tree, suit, layout);
    DistanceMeasurement m;
    m.board = 1;
    m.source = 1;  // both on the chest
    const auto block = model.distance(state, m, 0, 0).block;
    for (size_t k = 0; k < block.columns.size(); ++k)
        if (block.columns[k] < 3 * layout.freedoms) {
            EXPECT_NEAR(block.H(0, static_cast<Eigen::Index>(k)), 0, 1e-15);
        }
}

TEST_P(Observation, RootJacobian) {
    ObservationModel model(tree, suit, layout);
    RootMeasurement m{0, {0.1, 0.2, 0.3}, state.motion.q_parent_link[0], 0.001, 0.001};
    // The residual's rotation is a logarithm; at zero its derivative is the identity that H states.
    const double offset_s = 0.004;
    ChainMotion chain;
    chain.evaluate(tree, state.motion, 0, offset_s);
    m.q_world_root = Quaterniond(chain.end().R_world_link);
    check([&](const BodyState& s) { return model.root(s, m, offset_s); }, "root");
}

/// Where a board on flesh is, worked out from the pose alone.
struct OnFlesh {
    Matrix3d R_world_board;
    Vector3d p_world_mic;
};

OnFlesh boardOnFlesh(const KinematicTree& tree, const MountedBoard& board, const MotionState& motion) {
    const Pose pose = tree.poseFromState(motion);
    Vector6 features = -board.flesh->at_rest;
    for (Eigen::Index end = 0; end < 2; ++end) {
        const Eigen::AngleAxisd turn(
            pose.q_parent_joint[static_cast<size_t>(board.flesh->joints[static_cast<size_t>(end)])]);
        features.segment<3>(3 * end) += 0.5 * std::sin(turn.angle()) * turn.axis();
    }
    const Vector3d tilt = board.flesh->tilt_rad * features;
    const Matrix3d E = Eigen::AngleAxisd(tilt.norm(), tilt.normalized()).toRotationMatrix();
    ChainMotion chain;
    chain.evaluate(tree, motion, board.link, 0);
    const Vector3d p_link_mic =
        board.p_link_board + board.flesh->shift_m * features + E * (board.p_link_mic - board.p_link_board);
    return {chain.end().R_world_link * E * board.R_link_board, chain.point(p_link_mic).p_m};
}

TEST_P(Observation, ABoardOnFleshTurnsAndShiftsWithTheJointsAtItsEnds) {
    const Matrix36 tilt = Matrix36::NullaryExpr([&] { return random(0.1); });
    const Matrix36 shift = Matrix36::NullaryExpr([&] { return random(0.02); });
    MountedBoard& board = suit.boards[2];
    board.flesh = MountedFlesh{{2, 3}, Vector6::Constant(0.05), tilt, shift};
    ObservationModel model(tree, suit, layout);

    const double h = 1e-5;
    const auto later = [&](double dt) {
        MotionState moved = state.motion;
        tree.retract(moved, dt * state.motion.rate);
        return boardOnFlesh(tree, board, moved);
    };
    const Eigen::AngleAxisd turn(Matrix3d(later(-h).R_world_board.transpose() * later(h).R_world_board));
    const Vector3d omega_board = turn.angle() / (2 * h) * turn.axis();
    const InertialMeasurement m = reading(2);
    const Eigen::VectorXd residual = model.gyro(state, m, 0).residual;
    for (int i = 0; i < 3; ++i) {
        const AxisReading& axis = m.gyro.axes[static_cast<size_t>(i)];
        EXPECT_NEAR(axis.value - residual[i], axis.sensitive_axis_board.dot(omega_board + state.gyro_bias[2]),
                    2e-6);
    }

    DistanceMeasurement distance;
    distance.board = 2;
    distance.distance_m = 0.4;
    const Vector3d p_world_mic = later(0).p_world_mic;
    ChainMotion chain;
    chain.evaluate(tree, state.motion, suit.sources[0].link, 0);
    const double expected_m = (p_world_mic - chain.point(suit.sources[0].p_link_source).p_m).norm();
    EXPECT_NEAR(model.distance(state, distance, 0, 0).block.residual[0],
                distance.distance_m - expected_m * (1 + state.sound_scale) - state.source_offset_m[0], 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Sizes, Observation, ::testing::Values(0.0, 1e-6, 0.4, 1.2));

TEST(ObservationModelTest, StillBoardReadsGravityUpward) {
    const KinematicTree tree(testing::smallSkeleton(), BallCoordinates::kManifold);
    const SuitModel suit =
        mountSuit(testing::smallSuit(), {}, testing::actorOf(testing::smallSkeleton()), tree).value();
    StateLayout layout;
    layout.freedoms = tree.freedoms();
    BodyState state{tree.stateFromPose(testing::smallSkeleton().zeroPose()),
                    std::vector<Vector3d>(4, Vector3d::Zero()),
                    std::vector<Vector3d>(4, Vector3d::Zero()),
                    {0, 0},
                    0};
    ObservationModel model(tree, suit, layout);
    InertialMeasurement m;
    m.board = 0;
    const Vector3d up_in_board =
        testing::smallSuit().boards[0].q_segment_board.conjugate() * Vector3d::UnitY();
    m.accel.add({up_in_board, 9.80665, 0.1});
    EXPECT_NEAR(model.accel(state, m, 0).block.residual[0], 0, 1e-12);
}

}  // namespace
}  // namespace noctule
