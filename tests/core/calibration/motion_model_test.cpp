// SPDX-License-Identifier: Apache-2.0
// The parts of the calibration from motion: derivatives against differences, the solver against a dense one,
// the sums of readings against a motion that is known.
#include "core/calibration/motion/motion_model.h"

#include <gtest/gtest.h>

#include "core/calibration/motion/board_signal.h"
#include "core/calibration/motion/motion_priors.h"
#include "core/math/linear_solvers.h"
#include "core/math/rotation.h"
#include "core/simulation/random.h"
#include "core/suit/default_suit.h"
#include "tests/support/jacobian_checker.h"

namespace noctule {
namespace {

/// Three nodes of a body in any pose, and constants that are all off.
struct AnyMotion {
    simulation::Random random;
    Observations take;
    MotionBody body;
    MotionLayout layout;
    MotionUnknowns unknowns;
    std::vector<int> rest_of_node{0, 0, 0};

    explicit AnyMotion(uint64_t seed)
        : random(seed, "any motion"), take(withDefaultSuit()), body(take.actor) {
        layout = {body.size(), 18, 8, static_cast<int>(body.bones().size()), true};
        Matrix3d start[32];
        for (int s = 0; s < body.size(); ++s)
            start[s] = expQuaternion(random.gaussianVector(0.8)).toRotationMatrix();
        for (int k = 0; k < 3; ++k) {
            MotionNode node{random.gaussianVector(0.3), {}};
            for (int s = 0; s < body.size(); ++s)
                node.R_world_segment.push_back(start[s] *
                                               expQuaternion(random.gaussianVector(0.2)).toRotationMatrix());
            unknowns.nodes.push_back(node);
        }
        for (const Board& board : take.suit.boards) {
            BoardConstants constants;
            constants.q_segment_board = board.q_segment_board * expQuaternion(random.gaussianVector(0.1));
            constants.p_segment_board_m = board.p_segment_board_m + random.gaussianVector(0.01);
            constants.gyro_zero_rad_per_s = random.gaussianVector(0.01);
            constants.tilt_rad = Matrix36::NullaryExpr([&] { return random.gaussian(0.1); });
            constants.shift_m = Matrix36::NullaryExpr([&] { return random.gaussian(0.02); });
            unknowns.boards.push_back(constants);
        }
        for (const Source& source : take.suit.sources)
            unknowns.sources.push_back(
                {source.p_segment_source_m + random.gaussianVector(0.005), random.gaussian(0.002)});
        for (int bone = 0; bone < layout.bones; ++bone)
            unknowns.bone_scale.push_back(1 + random.gaussian(0.03));
        unknowns.sound_scale = 1.004;
    }

    static Observations withDefaultSuit() {
        Observations take;
        take.suit = defaultSuit();
        take.suit.boards[5].p_board_mic_m = {0.01, -0.02, 0.005};
        take.actor = defaultActor();
        return take;
    }

    /// Nodes, then the border.
    int columns() const { return 3 * layout.nodeSize() + layout.borderSize(); }
    MotionUnknowns moved(const Eigen::VectorXd& step) const {
        MotionUnknowns result = unknowns;
        const Eigen::MatrixXd nodes = step.head(3 * layout.nodeSize()).reshaped(layout.nodeSize(), 3);
        move(result, layout, nodes, step.tail(layout.borderSize()));
        return result;
    }

    /// Differences only of those columns that the block names, and none of the others may matter.
    template <class Make>
    void expectDerivatives(const Make& make, const std::string& what) const {
        const ResidualBlock block = make(unknowns);
        Eigen::MatrixXd J = Eigen::MatrixXd::Zero(block.rows, columns());
        for (const ColumnBlock& part : block.columns) {
            const int first = part.border ? 3 * layout.nodeSize() + part.first
                                          : block.first_node * layout.nodeSize() + part.first;
            J.middleCols(first, part.width) += part.J.topLeftCorner(block.rows, part.width);
        }
        testing::expectJacobian(
            [&](const Eigen::VectorXd& step) -> Eigen::VectorXd {
                return make(moved(step)).residual.head(block.rows);
            },
            J, what, 1e-6);
    }
};

TEST(MotionModel, DerivativesAreThoseOfDifferences) {
    AnyMotion any(7);
    MotionModel model(any.body, any.take, any.layout, 0.1);
    model.freezeFlesh(any.unknowns, any.rest_of_node);
    for (const int board : {0, 5, 13, 17}) {
        const BoardTurn turn{true, expQuaternion(any.random.gaussianVector(0.3))};
        any.expectDerivatives([&](const MotionUnknowns& u) { return model.gyro(u, board, 1, turn, 7.5); },
                              "gyroscope");
        const BoardForce force{true, any.random.gaussianVector(9)};
        any.expectDerivatives([&](const MotionUnknowns& u) { return model.accel(u, board, 1, force); },
                              "accelerometer");
        for (const int source : {0, 7})
            for (const double at : {-0.4, 0.0, 0.3}) {
                const HeardDistance heard{1, at, at + 0.04, source, board, 0.5, 1};
                any.expectDerivatives([&](const MotionUnknowns& u) { return model.distance(u, heard, 0); },
                                      "distance");
            }
    }
}

TEST(MotionPriors, DerivativesAreThoseOfDifferences) {
    AnyMotion any(8);
    const MotionSettings settings;
    const MotionPriors priors(any.body, any.layout, settings);
    ExpectedConstants expected;
    std::vector<int> segments;
    for (const Board& board : any.take.suit.boards) {
        expected.boards.push_back({board.q_segment_board, board.p_segment_board_m});
        segments.push_back(any.body.segmentOfJoint(any.take.actor.skeleton.find(board.segment)));
    }
    for (const Source& source : any.take.suit.sources)
        expected.sources.push_back({source.p_segment_source_m, 0});
    const std::vector<std::function<void(const MotionUnknowns&, const ResidualSink&)>> kinds{
        [&](const auto& u, const auto& sink) { priors.addConstants(u, expected, segments, sink); },
        [&](const auto& u, const auto& sink) { priors.addRest(u, 1, true, sink); },
        [&](const auto& u, const auto& sink) { priors.addRest(u, 1, false, sink); },
        [&](const auto& u, const auto& sink) { priors.addJoints(u, 1, sink); },
        [&](const auto& u, const auto& sink) { priors.addRootStep(u, 1, true, sink); },
        [&](const auto& u, const auto& sink) { priors.addFollowing(u, 1, 4, sink); },
        [&](const auto& u, const auto& sink) { priors.addFollowing(u, 1, 0, sink); }};
    for (size_t kind = 0; kind < kinds.size(); ++kind) {
        std::vector<ResidualBlock> blocks;
        kinds[kind](any.unknowns, [&](const ResidualBlock& block) { blocks.push_back(block); });
        // Of many alike a few will do.
        for (size_t i = 0; i < blocks.size(); i += 1 + blocks.size() / 12)
            any.expectDerivatives(
                [&](const MotionUnknowns& u) {
                    std::vector<ResidualBlock> again;
                    kinds[kind](u, [&](const ResidualBlock& block) { again.push_back(block); });
                    return again[i];
                },
                "prior " + std::to_string(kind) + ", block " + std::to_string(i));
    }
}

TEST(ArrowheadSystem, SolvesAsADenseSolverDoes) {
    constexpr int kNodes = 19, kNode = 6, kBorder = 5, kAll = kNodes * kNode + kBorder;
    simulation::Random random(3, "arrowhead");
    const auto matrix = [&] { return Matrix3d(Matrix3d::NullaryExpr([&] { return random.gaussian(); })); };
    ArrowheadSystem system(kNodes, kNode, kBorder);
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(kAll, kAll);
    Eigen::VectorXd g = Eigen::VectorXd::Zero(kAll);
    for (int i = 0; i < 160; ++i) {
        ResidualBlock block;
        block.first_node = i % (kNodes - 2);
        block.rows = i % 4 == 0 ? 1 : 3;
        block.residual = random.gaussianVector(1);
        block.weight = Vector3d(1, 2, 3);
        for (const int first : {0, 3, 6, 9, 12, 15, 9})  // one of them twice
            block.addNode(first, matrix());
        block.addBorder(i % 2 ? 0 : 2, matrix());
        block.addBorder(4, Vector3d(random.gaussianVector(1)));
        for (ColumnBlock& part : block.columns)
            part.J.bottomRows(3 - block.rows).setZero();
        Eigen::MatrixXd J = Eigen::MatrixXd::Zero(block.rows, kAll);
        for (const ColumnBlock& part : block.columns)
            J.middleCols(part.border ? kNodes * kNode + part.first : block.first_node * kNode + part.first,
                         part.width) += part.J.topLeftCorner(block.rows, part.width);
        const Eigen::VectorXd w = block.weight.head(block.rows);
        H += J.transpose() * w.asDiagonal() * J;
        g += J.transpose() * w.asDiagonal() * block.residual.head(block.rows);
        system.add(block);
    }
    const Eigen::MatrixXd inverse = inverseOf(H);
    const Eigen::VectorXd step = -inverse * g;
    ASSERT_TRUE(system.solve(0));
    EXPECT_LT((system.nodeSteps().reshaped() - step.head(kNodes * kNode)).norm(), 1e-8 * step.norm());
    EXPECT_LT((system.borderStep() - step.tail(kBorder)).norm(), 1e-8 * step.norm());
    EXPECT_LT((system.borderCovariance() - inverse.bottomRightCorner(kBorder, kBorder)).norm(),
              1e-8 * inverse.norm());
}

/// A board that turns and moves as functions of time say; its readings, 140 a second, in SI.
struct KnownBoard {
    static Quaterniond orientation(double t) {
        return expQuaternion({1.2 * std::sin(3 * t), 0.7 * std::cos(2 * t), 0.5 * std::sin(4 * t + 1)});
    }
    static Vector3d place(double t) {
        return {0.3 * std::sin(4 * t), 0.2 * std::cos(3 * t), 0.1 * std::sin(6 * t)};
    }
    static BoardSignal signal() {
        BoardCalibration identity;
        identity.gyro.zero_counts = identity.accel.zero_counts = Vector3d::Zero();
        std::vector<CountReading> readings;
        constexpr double d = 1e-4;
        for (int i = 0; i < 140; ++i) {
            const double t = i / 140.0;
            const Quaterniond q = orientation(t);
            const Vector3d rate =
                logQuaternion(orientation(t - d).conjugate() * orientation(t + d)) / (2 * d);
            const Vector3d a = (place(t - d) - 2 * place(t) + place(t + d)) / (d * d);
            readings.push_back(
                {t, rate, q.conjugate() * (a + kStandardGravity_m_per_s2 * Vector3d::UnitY())});
        }
        return BoardSignal(readings, identity);
    }
};

TEST(BoardSignal, SumsAreTheMotionBetweenNodes) {
    const BoardSignal signal = KnownBoard::signal();
    for (const double t : {0.2, 0.45, 0.7}) {
        const double h = 0.1;
        ASSERT_TRUE(signal.covers(t - h, t + h));
        const Quaterniond turn = KnownBoard::orientation(t).conjugate() * KnownBoard::orientation(t + h);
        EXPECT_LT(angleBetween(signal.turn(t, t + h), turn), 1e-3);
        const Vector3d a =
            (KnownBoard::place(t - h) - 2 * KnownBoard::place(t) + KnownBoard::place(t + h)) / (h * h);
        const Vector3d force =
            KnownBoard::orientation(t).conjugate() * (a + kStandardGravity_m_per_s2 * Vector3d::UnitY());
        EXPECT_LT((signal.meanForce(t, h) - force).norm(), 0.02);
    }
    EXPECT_FALSE(signal.covers(0.9, 1.1));
}

}  // namespace
}  // namespace noctule
