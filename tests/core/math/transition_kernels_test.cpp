// SPDX-License-Identifier: Apache-2.0
#include "core/math/transition_kernels.h"

#include <gtest/gtest.h>

namespace noctule {
namespace {

/// As the header says it, written out: F among n coordinates and whatever follows.
Eigen::MatrixXd dense(const LinkTransitions& t, Eigen::Index size) {
    Eigen::MatrixXd F = Eigen::MatrixXd::Identity(size, size);
    for (const LinkTransition& link : t.links)
        for (Eigen::Index i = 0; i < link.count; ++i) {
            const Eigen::Index theta = link.first + i, rate = t.n + theta, accel = 2 * t.n + theta;
            F(rate, accel) = t.dt_s;
            F(accel, accel) = link.decay[i];
            for (Eigen::Index k = 0; k < link.count; ++k) {
                F(theta, link.first + k) = link.turn(i, k);
                F(theta, t.n + link.first + k) = t.dt_s * link.jacobian(i, k);
                F(theta, 2 * t.n + link.first + k) = 0.5 * t.dt_s * t.dt_s * link.jacobian(i, k);
                F(rate, link.first + k) = link.rate_by_theta(i, k);
                F(accel, link.first + k) = link.accel_by_theta(i, k);
            }
        }
    return F;
}

/// Three coordinates, one by itself, three; one that is left alone.
LinkTransitions randomTransitions(double dt_s) {
    LinkTransitions t{8, dt_s};
    for (const auto& [first, count] : {std::pair{0, 3}, {3, 1}, {4, 3}}) {
        LinkTransition& link = t.links.emplace_back();
        link.first = first;
        link.count = count;
        for (Eigen::Matrix3d* m : {&link.turn, &link.jacobian, &link.rate_by_theta, &link.accel_by_theta})
            *m = Eigen::Matrix3d::Random();
        link.decay = Eigen::Vector3d::Random();
    }
    return t;
}

TEST(TransitionKernels, EqualTheDenseProducts) {
    std::srand(9);
    for (const Eigen::Index rows : {1, 4, 7, 34}) {
        const LinkTransitions t = randomTransitions(0.3);
        const Eigen::MatrixXd M = Eigen::MatrixXd::Random(rows, 26), F = dense(t, 26);
        Eigen::MatrixXd forth = M, back = M;
        t.timesTransposed(forth);
        t.times(back);
        EXPECT_LT((forth - M * F.transpose()).cwiseAbs().maxCoeff(), 1e-14) << rows;
        EXPECT_LT((back - M * F).cwiseAbs().maxCoeff(), 1e-14) << rows;
    }
}

TEST(TransitionKernels, CarryBothSidesAndVectors) {
    std::srand(10);
    const LinkTransitions t = randomTransitions(0.3);
    const Eigen::MatrixXd half = Eigen::MatrixXd::Random(26, 26), P = half + half.transpose(),
                          F = dense(t, 26);
    const Eigen::VectorXd x = Eigen::VectorXd::Random(26);
    Eigen::MatrixXd forth = P, back = P;
    Eigen::VectorXd x_forth = x, x_back = x;
    t.carry(forth);
    t.carryBack(back);
    t.carry(x_forth);
    t.carryBack(x_back);
    EXPECT_LT((forth - F * P * F.transpose()).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_LT((back - F.transpose() * P * F).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_LT((x_forth - F * x).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((x_back - F.transpose() * x).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(TransitionKernels, AStepThatBeginsWithAShiftIsBoth) {
    std::srand(11);
    LinkTransitions step = randomTransitions(0.3), shift = randomTransitions(0);
    shift.links.resize(1);
    shift.links[0].first = 4;
    shift.links[0].decay.setOnes();
    const Eigen::MatrixXd expected = dense(step, 26) * dense(shift, 26);
    step.beginWith(shift);
    EXPECT_LT((dense(step, 26) - expected).cwiseAbs().maxCoeff(), 1e-14);
}

}  // namespace
}  // namespace noctule
