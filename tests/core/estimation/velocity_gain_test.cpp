// SPDX-License-Identifier: Apache-2.0
#include "core/estimation/velocity_gain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/rotation.h"

namespace noctule {
namespace {

constexpr double kWindowReading_s = 1.0 / 140;

Skeleton threeBalls() {
    const std::vector<DegreeOfFreedom> all{
        {"x", Vector3d::UnitX()}, {"y", Vector3d::UnitY()}, {"z", Vector3d::UnitZ()}};
    return Skeleton::make({{"Hips", -1, {0, 0, 0}, JointType::kFree, {}, {}, {}},
                           {"Chest", 0, {0.02, 0.3, 0}, JointType::kBall, all, {}, {}},
                           {"Arm", 1, {0.2, 0.2, -0.03}, JointType::kBall, all, {}, {}}})
        .value();
}

/// A trunk and an arm that swing while the root is carried about, all integrated finely; a board sits askew
/// on the arm, another on the hips.
class GainedVelocity : public ::testing::Test {
protected:
    static constexpr size_t kHips = 0, kArm = 1;

    GainedVelocity() {
        layout.freedoms = tree.freedoms();
        layout.accel_bias = 3 * layout.freedoms;
        layout.size = layout.accel_bias + 6;
        truth = tree.stateFromPose(threeBalls().zeroPose());
        tree.retract(truth, Eigen::VectorXd::LinSpaced(tree.freedoms(), -0.4, 0.5));
        boards = {{tree.linkOfJoint(0), Vector3d(0.01, 0.05, 0.1), Matrix3d::Identity(), Vector3d::Zero()},
                  {tree.linkOfJoint(2), Vector3d(0.2, 0.03, -0.04),
                   expQuaternion(Vector3d(0.3, -0.8, 0.5)).toRotationMatrix(), Vector3d::Zero()}};
        setRates();
    }

    void setRates() {
        truth.rate.resize(tree.freedoms());
        truth.accel.resize(tree.freedoms());
        for (int i = 0; i < tree.freedoms(); ++i) {
            const double size = i < 3 ? 0.8 : 2, pace = 4 + 0.7 * i;
            truth.rate[i] = size * std::sin(pace * time_s + i);
            truth.accel[i] = size * pace * std::cos(pace * time_s + i);
        }
    }

    const ChainMotion& chainOf(size_t board, const MotionState& state) {
        chain.evaluate(tree, state, boards[board].link, 0);
        return chain;
    }
    PlacedBoard placed(size_t board) const { return placeBoard(boards[board], tree, truth, 0); }

    void listen() {
        for (size_t b = 0; b < boards.size(); ++b) {
            chainOf(b, truth);
            const Matrix3d R_board_world = (chain.end().R_world_link * boards[b].R_link_board).transpose();
            const Vector3d force = chain.point(boards[b].p_link_board).a_m_per_s2 +
                                   kStandardGravity_m_per_s2 * Vector3d::UnitY();
            gains[b].add(time_s, R_board_world * chain.end().omega_rad_per_s,
                         R_board_world * force + bias[b]);
        }
    }
    void swing(double seconds) {
        constexpr int kFine = 40;
        for (int k = 0; k < std::lround(seconds / kWindowReading_s); ++k) {
            for (int i = 0; i < kFine; ++i) {
                constexpr double dt = kWindowReading_s / kFine;
                time_s += 0.5 * dt;
                setRates();
                tree.retract(truth, dt * truth.rate);
                time_s += 0.5 * dt;
            }
            setRates();
            listen();
        }
    }
    void open() {
        for (size_t b = 0; b < boards.size(); ++b)
            gains[b].open(velocitiesOf(chainOf(b, truth), boards[b].p_link_board));
    }
    void swingThroughAWindow() {
        listen();
        open();
        swing(1);
    }
    ObservationBlock observe(size_t board, const VelocityWindow& window, const MotionState& state) {
        return observeGain(window, chainOf(board, state), placed(board), believed_bias,
                           layout.accel_bias + 3 * static_cast<int>(board), layout,
                           kStandardGravity_m_per_s2);
    }
    ObservationBlock observe(size_t board) {
        return observe(board, gains[board].window(time_s).value(), truth);
    }

    KinematicTree tree{threeBalls(), BallCoordinates::kManifold};
    StateLayout layout;
    MotionState truth;
    double time_s = 0;
    std::vector<MountedBoard> boards;
    std::vector<Vector3d> bias{Vector3d::Zero(), Vector3d::Zero()};
    Vector3d believed_bias = Vector3d::Zero();
    std::vector<VelocityGain> gains{2};
    ChainMotion chain;
};

TEST_F(GainedVelocity, ForcesOfAWindowAreGravityAndWhatTheBoardGained) {
    swingThroughAWindow();
    for (const size_t board : {kHips, kArm})
        EXPECT_LT(observe(board).residual.norm(), 0.004) << board;
}

TEST_F(GainedVelocity, ABiasIsInItAsItsDerivativeSays) {
    bias[kArm] = Vector3d(0.3, -0.2, 0.4);
    swingThroughAWindow();
    const ObservationBlock block = observe(kArm);
    ASSERT_EQ(block.columns.back(), layout.accel_bias + 5);
    EXPECT_LT((block.residual - block.H.rightCols<3>() * bias[kArm]).norm(), 0.004);
    EXPECT_GT(block.residual.norm(), 0.3);
    believed_bias = bias[kArm];
    EXPECT_LT(observe(kArm).residual.norm(), 0.004);
}

/// Attitudes that gyroscopes have carried through the window from a wrong beginning are all turned alike, in
/// the world.
TEST_F(GainedVelocity, AWrongAttitudeShowsAsItsDerivativesSay) {
    const auto contributions = [](const Eigen::Matrix3Xd& v) {
        Eigen::Matrix3Xd each = v.leftCols(v.cols() - 1);
        each.leftCols(each.cols() - 1) -= v.middleCols(1, each.cols() - 1);
        return each;
    };
    swingThroughAWindow();
    const VelocityWindow window = gains[kArm].window(time_s).value();
    const std::vector<ChainMotion::Frame> frames = chainOf(kArm, truth).frames();
    for (int axis = 3; axis < tree.freedoms(); ++axis) {
        Eigen::VectorXd error = Eigen::VectorXd::Zero(tree.freedoms());
        error[axis] = 1e-4;
        MotionState state = truth;
        tree.retract(state, error);
        const std::vector<ChainMotion::Frame> wrong = chainOf(kArm, state).frames();
        VelocityWindow believed = window;
        Vector3d omega_above = Vector3d::Zero();
        const Eigen::Matrix3Xd each = contributions(window.v_begin_m_per_s);
        believed.v_begin_m_per_s.setZero();
        const Vector3d v_root = window.v_begin_m_per_s.rightCols<1>() - window.v_begin_m_per_s.col(0);
        for (size_t l = 0; l < frames.size(); ++l) {
            const auto at = static_cast<Eigen::Index>(l);
            const Matrix3d turned = wrong[l].R_world_link * frames[l].R_world_link.transpose();
            believed.v_begin_m_per_s.leftCols(at + 1).colwise() += Vector3d(turned * each.col(at));
            const Vector3d omega = turned * frames[l].omega_rad_per_s;
            state.rate.segment<3>(3 + 3 * at) = wrong[l].R_world_link.transpose() * (omega - omega_above);
            omega_above = omega;
        }
        believed.v_begin_m_per_s.rightCols<1>() = v_root + believed.v_begin_m_per_s.col(0);

        const ObservationBlock block = observe(kArm, window, truth);
        const auto column = std::find(block.columns.begin(), block.columns.end(), layout.theta(axis));
        ASSERT_NE(column, block.columns.end());
        const Vector3d slope = (block.residual - observe(kArm, believed, state).residual) / 1e-4;
        const Vector3d expected = block.H.col(column - block.columns.begin());
        EXPECT_LT((slope - expected).norm(), 0.002 * expected.norm() + 0.002) << axis;
        EXPECT_GT(expected.norm(), 1) << axis;
    }
}

TEST_F(GainedVelocity, AnUnknownVelocityOfTheRootCancelsAgainstABoardOnIt) {
    swingThroughAWindow();
    const Vector3d wrong(0.5, -0.3, 0.2);
    std::vector<ObservationBlock> right, off;
    for (const size_t board : {kHips, kArm}) {
        VelocityWindow window = gains[board].window(time_s).value();
        right.push_back(observe(board, window, truth));
        window.v_begin_m_per_s.rightCols<1>() += wrong;
        off.push_back(observe(board, window, truth));
        EXPECT_NEAR((off.back().residual - right.back().residual).norm(), wrong.norm(), 1e-12);
    }
    right[kHips].variance.setConstant(0.5);
    right[kArm].variance.setConstant(0.25);
    const ObservationBlock difference = lessTheOther(right[kArm], right[kHips]);
    EXPECT_LT((difference.residual - lessTheOther(off[kArm], off[kHips]).residual).norm(), 1e-12);
    EXPECT_EQ(difference.variance, Vector3d::Constant(0.75));
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3, layout.size);
    const auto spread = [&](const ObservationBlock& block, double sign) {
        for (size_t k = 0; k < block.columns.size(); ++k)
            dense.col(block.columns[k]) += sign * block.H.col(static_cast<Eigen::Index>(k));
    };
    spread(right[kArm], 1);
    spread(right[kHips], -1);
    spread(difference, -1);
    EXPECT_LT(dense.norm(), 1e-12);
}

/// Nothing on a suit tells the heading, however wrong a window finds the rest.
TEST_F(GainedVelocity, OfAFreeRootTheHeadingIsNotTold) {
    bias[kArm] = Vector3d(0.3, -0.2, 0.4);
    swingThroughAWindow();
    ObservationBlock block = lessTheOther(observe(kArm), observe(kHips));
    ASSERT_GT(block.residual.norm(), 0.3);
    const Vector3d up_root = truth.q_parent_link[0].conjugate() * Vector3d::UnitY();
    const auto told = [&] {
        Vector3d sum = Vector3d::Zero();
        for (size_t k = 0; k < block.columns.size(); ++k)
            for (int axis = 0; axis < 3; ++axis)
                if (block.columns[k] == layout.theta(3 + axis))
                    sum += up_root[axis] * block.H.col(static_cast<Eigen::Index>(k));
        return sum.norm();
    };
    EXPECT_GT(told(), 0.1);
    leaveHeadingUntold(block, layout, truth);
    EXPECT_LT(told(), 1e-12);
}

TEST_F(GainedVelocity, NothingIsSaidOfAWindowThatWasNotSeenWhole) {
    swing(1.2);
    EXPECT_FALSE(gains[kArm].window(time_s)) << "never opened";
    open();
    swing(0.9);
    EXPECT_FALSE(gains[kArm].window(time_s)) << "too short";
    swing(0.1);
    EXPECT_TRUE(gains[kArm].window(time_s));
    EXPECT_FALSE(gains[kArm].window(time_s + 2 * kWindowReading_s)) << "no reading at its end";
    time_s += 0.05;
    swing(1);
    EXPECT_FALSE(gains[kArm].window(time_s)) << "a gap";
}

TEST_F(GainedVelocity, ForcesThatShookTheBoardMakeItLessSure) {
    listen();
    open();
    const double before = gains[kArm].variance_m2_per_s2();
    gains[kArm].add(time_s + kWindowReading_s, Vector3d::Zero(), Vector3d(0, 60, 0));
    EXPECT_GT(gains[kArm].variance_m2_per_s2(), 2 * before);
}

TEST_F(GainedVelocity, AWindowComesBackFromItsNumbers) {
    swingThroughAWindow();
    const VelocityWindow window = gains[kArm].window(time_s).value();
    Eigen::VectorXd numbers = window.packed();
    const Eigen::Index size = numbers.size();
    numbers.conservativeResize(size + 2);
    numbers.tail<2>() << 5, 6;
    const auto [again, rest] = VelocityWindow::unpacked(numbers);
    EXPECT_EQ(again.packed(), window.packed());
    EXPECT_EQ(again.felt_by_bias_s, window.felt_by_bias_s);
    EXPECT_EQ(again.v_begin_m_per_s, window.v_begin_m_per_s);
    EXPECT_EQ(rest, Eigen::Vector2d(5, 6));
}

}  // namespace
}  // namespace noctule
