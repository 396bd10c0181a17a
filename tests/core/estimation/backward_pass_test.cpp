// SPDX-License-Identifier: Apache-2.0
// The backward pass on a linear problem of the filter's own shape, beside a solution that knows nothing of
// filters: all states of all instants as one Gaussian, conditioned on all measurements at once.
#include "core/estimation/backward_pass.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "core/estimation/prediction.h"
#include "core/math/rotation.h"
#include "tests/core/estimation/small_body.h"

namespace noctule {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kConstants = 2;  // states beside the body's, which do not move
constexpr int kSteps = 10;
constexpr double kStep_s = 0.05;

/// As the header says it, written out.
MatrixXd denseTransition(const KinematicTree& tree, const MotionState& motion, const VectorXd& decay,
                         Index size) {
    const Index n = tree.freedoms();
    MatrixXd F = MatrixXd::Identity(size, size);
    const auto by_rate = [&](Index i, Index j, double value) {
        F(i, n + j) = kStep_s * value;
        F(i, 2 * n + j) = 0.5 * kStep_s * kStep_s * value;
    };
    for (Index i = 0; i < n; ++i) {
        by_rate(i, i, 1);
        F(n + i, 2 * n + i) = kStep_s;
        F(2 * n + i, 2 * n + i) = decay[i];
    }
    for (const Link& link : tree.links())
        if (link.type == LinkType::kBall || link.type == LinkType::kFree) {
            const Index first = link.first + (link.type == LinkType::kFree ? 3 : 0);
            const Vector3d u = kStep_s * motion.rate.segment<3>(first) +
                               0.5 * kStep_s * kStep_s * motion.accel.segment<3>(first);
            F.block<3, 3>(first, first) = expQuaternion(-u).toRotationMatrix();
            const Matrix3d J = rightJacobian(u);
            for (Index i = 0; i < 3; ++i)
                for (Index j = 0; j < 3; ++j)
                    by_rate(first + i, first + j, J(i, j));
        }
    return F;
}

/// Error states x of `kSteps` instants as linear maps A of independent sources (the first error and every
/// step's noise), and the measurements as maps of the same.
struct Batch {
    MatrixXd sources;  ///< covariance of the sources
    std::vector<MatrixXd> A;
    MatrixXd H;  ///< of all measurements, by the sources
    VectorXd variance, measured;

    explicit Batch(const VectorXd& first_variance) {
        const Index n = first_variance.size();
        sources = MatrixXd::Zero(n * (kSteps + 1), n * (kSteps + 1));
        sources.diagonal().head(n) = first_variance;
        A.push_back(MatrixXd::Identity(n, n * (kSteps + 1)));
    }
    void move(const MatrixXd& F, const VectorXd& noise) {
        const Index n = F.rows(), step = static_cast<Index>(A.size());
        sources.diagonal().segment(n * step, n) = noise;
        A.push_back(F * A.back());
        A.back().middleCols(n * step, n) += MatrixXd::Identity(n, n);
    }
    void observe(const MatrixXd& H_now, const VectorXd& values, const VectorXd& noise) {
        const Index old = H.rows();
        H.conservativeResize(old + H_now.rows(), sources.cols());
        H.bottomRows(H_now.rows()) = H_now * A.back();
        variance.conservativeResize(old + noise.size());
        variance.tail(noise.size()) = noise;
        measured.conservativeResize(old + values.size());
        measured.tail(values.size()) = values;
    }
    /// Mean and covariance of the error at an instant, all measurements known.
    std::pair<VectorXd, MatrixXd> at(size_t instant) const {
        const MatrixXd cross = A[instant] * sources * H.transpose();
        const MatrixXd all = H * sources * H.transpose() + MatrixXd(variance.asDiagonal());
        const Eigen::LLT<MatrixXd> solver(all);
        return {cross * solver.solve(measured),
                A[instant] * sources * A[instant].transpose() - cross * solver.solve(cross.transpose())};
    }
};

ObservationBlock blockOn(std::vector<int> columns, Index rows, testing::Gaussian& random) {
    const Index count = std::ssize(columns);
    return {std::move(columns), random.vector(rows * count, 1).reshaped(rows, count), random.vector(rows, 1),
            random.vector(rows, 0.3).cwiseAbs().array() + 0.05};
}

class LinearProblem : public ::testing::Test {
protected:
    LinearProblem()
        : tree_(testing::smallSkeleton(), BallCoordinates::kManifold),
          size_(3 * tree_.freedoms() + kConstants),
          batch_(firstVariance()),
          covariance_(VectorXd(batch_.sources.diagonal().head(size_))),
          mean_(VectorXd::Zero(size_)) {
        taped_.push_back({});
        instants_.push_back({mean_, covariance_.dense()});
        motion_ = tree_.stateFromPose(testing::smallSkeleton().zeroPose());
        for (int step = 1; step <= kSteps; ++step)
            filterStep(step);
    }

    VectorXd firstVariance() { return random_.vector(size_, 1).cwiseAbs().array() + 0.1; }

    void filterStep(int step) {
        motion_.rate = random_.vector(tree_.freedoms(), 3);
        motion_.accel = random_.vector(tree_.freedoms(), 20);
        const VectorXd decay = random_.vector(tree_.freedoms(), 0.2).array().abs().min(1);
        const LinkTransitions transition = motionTransition(tree_, motion_, kStep_s, decay);
        const MatrixXd F = denseTransition(tree_, motion_, decay, size_);
        VectorXd noise = random_.vector(size_, 0.1).cwiseAbs();
        noise.tail(kConstants).setZero();
        if (step == kSteps / 2)  // a filter that begins anew
            noise.head(tree_.freedoms()).array() += 1e4;
        transition.carry(covariance_.dense());
        covariance_.dense().diagonal() += noise;
        mean_ = F * mean_;
        batch_.move(F, noise);
        taped_.push_back({transition, {}});
        const int last = static_cast<int>(size_) - 1;
        observe({blockOn({step, step + 7, 30, last}, 3, random_), blockOn({2, last - 1}, 1, random_)});
        observe({blockOn({1, 12 + step, 11}, 2, random_)});
        instants_.push_back({mean_, covariance_.dense()});
    }

    /// The blocks' residuals are taken for measured values.
    void observe(std::vector<ObservationBlock> blocks) {
        for (ObservationBlock& block : blocks) {
            MatrixXd H = MatrixXd::Zero(block.rows(), size_);
            for (size_t k = 0; k < block.columns.size(); ++k)
                H.col(block.columns[k]) = block.H.col(static_cast<Index>(k));
            batch_.observe(H, block.residual, block.variance);
            block.residual -= H * mean_;
        }
        ObservedUpdate observed;
        mean_ += covariance_.update(blocks, &observed);
        taped_.back().updates.push_back(std::move(observed));
    }

    struct Taped {
        std::optional<LinkTransitions> transition;
        std::vector<ObservedUpdate> updates;
    };
    struct Instant {
        VectorXd mean;
        MatrixXd P;
    };

    testing::Gaussian random_{4};
    KinematicTree tree_;
    Index size_;
    Batch batch_;
    Covariance covariance_;
    VectorXd mean_;
    MotionState motion_;
    std::vector<Taped> taped_;
    std::vector<Instant> instants_;  ///< as the filter leaves them
};

TEST_F(LinearProblem, EqualsTheBatchSolution) {
    BackwardPass backward(size_);
    for (size_t instant = instants_.size(); instant-- > 0;) {
        const auto [mean, covariance] = batch_.at(instant);
        const Instant& filtered = instants_[instant];
        const BackwardPass::Smoothed smoothed = backward.smooth(filtered.P);
        EXPECT_LT((filtered.mean + smoothed.error - mean).norm(), 1e-9 * (1 + mean.norm())) << instant;
        EXPECT_LT((smoothed.covariance - covariance).norm(), 1e-9 * (1 + filtered.P.norm())) << instant;
        for (auto update = taped_[instant].updates.rbegin(); update != taped_[instant].updates.rend();
             ++update)
            backward.back(*update);
        if (taped_[instant].transition)
            backward.back(*taped_[instant].transition);
    }
}

TEST_F(LinearProblem, LeadingStatesAloneAreSmoothedTheSame) {
    BackwardPass backward(size_);
    backward.back(taped_.back().updates.back());
    const MatrixXd& P = instants_.back().P;
    const BackwardPass::Smoothed whole = backward.smooth(P), part = backward.smooth(P.topRows(5));
    EXPECT_LT((whole.error.head(5) - part.error).norm(), 1e-12);
    EXPECT_LT((whole.covariance.topLeftCorner(5, 5) - part.covariance).norm(), 1e-12 * P.norm());
}

TEST(BackwardPass, WhatWasNotObservedTellsNothing) {
    Covariance covariance(VectorXd::Ones(4));
    ObservedUpdate nothing;
    covariance.update({}, &nothing);
    BackwardPass backward(4);
    backward.back(nothing);
    const BackwardPass::Smoothed smoothed = backward.smooth(covariance.dense());
    EXPECT_EQ(smoothed.error.norm(), 0);
    EXPECT_EQ((smoothed.covariance - covariance.dense()).norm(), 0);
}

}  // namespace
}  // namespace noctule
