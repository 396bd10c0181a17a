// SPDX-License-Identifier: Apache-2.0
#include "core/calibration/motion/arrowhead_system.h"

#include <gtest/gtest.h>

#include <random>

#include "core/math/linear_solvers.h"

namespace noctule {
namespace {

constexpr int kNodeSize = 6, kBorderSize = 60;

/// The same least squares with one dense matrix: nodes one after the other, the border last.
class DenseSystem {
public:
    explicit DenseSystem(int nodes)
        : nodes_(nodes),
          normal_(Eigen::MatrixXd::Zero(size(), size())),
          gradient_(Eigen::VectorXd::Zero(size())) {}

    void add(const ResidualBlock& residuals) {
        Eigen::MatrixXd J = Eigen::MatrixXd::Zero(3, size());
        for (const ColumnBlock& block : residuals.columns)
            J.middleCols(block.border ? nodes_ * kNodeSize + block.first
                                      : residuals.first_node * kNodeSize + block.first,
                         block.width) += block.J.leftCols(block.width);
        normal_ += J.transpose() * residuals.weight.asDiagonal() * J;
        gradient_ += J.transpose() * residuals.weight.cwiseProduct(residuals.residual);
    }

    Eigen::VectorXd step(double damping) {
        normal_.diagonal() *= 1 + damping;
        return -solveSymmetric(normal_, gradient_);
    }
    Eigen::MatrixXd borderCovariance() const {
        return inverseOf(normal_).bottomRightCorner(kBorderSize, kBorderSize);
    }

private:
    int size() const { return nodes_ * kNodeSize + kBorderSize; }

    int nodes_;
    Eigen::MatrixXd normal_;
    Eigen::VectorXd gradient_;
};

class RandomResiduals {
public:
    explicit RandomResiduals(int nodes) : nodes_(nodes) {}

    ResidualBlock next() {
        ResidualBlock residuals;
        residuals.first_node = upTo(nodes_ - 1);
        residuals.residual = vector();
        residuals.weight = vector().cwiseAbs() + Vector3d::Constant(0.1);
        const int reach = std::min(3, nodes_ - residuals.first_node);
        for (int i = 0; i < 3; ++i)
            residuals.addNode(3 * upTo(2 * reach - 1), matrix());
        residuals.addBorder(3 * upTo(kBorderSize / 3 - 1), matrix());
        residuals.addBorder(upTo(kBorderSize - 1), vector());
        return residuals;
    }

private:
    int upTo(int last) { return std::uniform_int_distribution<int>(0, last)(random_); }
    double number() { return std::normal_distribution<double>()(random_); }
    Vector3d vector() { return {number(), number(), number()}; }
    Matrix3d matrix() {
        return Matrix3d::NullaryExpr([this] { return number(); });
    }

    int nodes_;
    std::mt19937 random_{1};
};

class ArrowheadSystemTest : public testing::TestWithParam<int> {};

TEST_P(ArrowheadSystemTest, SolvesAsOneDenseMatrixDoes) {
    const int nodes = GetParam();
    constexpr double kDamping = 1e-3;
    ArrowheadSystem system(nodes, kNodeSize, kBorderSize);
    DenseSystem dense(nodes);
    RandomResiduals random(nodes);
    for (int i = 0; i < 40 * (nodes + 2); ++i) {
        const ResidualBlock residuals = random.next();
        system.add(residuals);
        dense.add(residuals);
    }
    ASSERT_TRUE(system.solve(kDamping));
    const Eigen::VectorXd expected = dense.step(kDamping);
    const Eigen::Map<const Eigen::MatrixXd> node_steps(expected.data(), kNodeSize, nodes);
    EXPECT_LT((system.nodeSteps() - node_steps).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((system.borderStep() - expected.tail(kBorderSize)).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((system.borderCovariance() - dense.borderCovariance()).cwiseAbs().maxCoeff(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Nodes, ArrowheadSystemTest, testing::Range(1, 18),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace noctule
