// SPDX-License-Identifier: Apache-2.0
#include "core/math/transition_kernels.h"

#include <gtest/gtest.h>

namespace noctule {
namespace {

/// As the header says it, written out: F of one link among n coordinates and whatever follows.
Eigen::MatrixXd denseTransition(Eigen::Index n, Eigen::Index size, double dt_s, const LinkTransition& link) {
    Eigen::MatrixXd F = Eigen::MatrixXd::Identity(size, size);
    for (Eigen::Index i = 0; i < link.count; ++i) {
        const Eigen::Index theta = link.first + i, rate = n + theta, accel = 2 * n + theta;
        F(rate, accel) = dt_s;
        F(accel, accel) = link.decay[i];
        for (Eigen::Index k = 0; k < link.count; ++k) {
            F(theta, link.first + k) = link.turn(i, k);
            F(theta, n + link.first + k) = dt_s * link.jacobian(i, k);
            F(theta, 2 * n + link.first + k) = 0.5 * dt_s * dt_s * link.jacobian(i, k);
        }
    }
    return F;
}

TEST(TransitionKernels, EqualTheDenseProducts) {
    std::srand(9);
    constexpr double kStep_s = 0.3;
    for (const Eigen::Index rows : {1, 4, 7, 34})
        for (const int count : {1, 3}) {
            constexpr Eigen::Index n = 8, size = 3 * n + 2;
            LinkTransition link;
            link.first = 4;
            link.count = count;
            link.decay = Eigen::Vector3d::Random();
            if (count == 3) {
                link.turn = Eigen::Matrix3d::Random();
                link.jacobian = Eigen::Matrix3d::Random();
            }
            const Eigen::MatrixXd F = denseTransition(n, size, kStep_s, link);
            const Eigen::MatrixXd M = Eigen::MatrixXd::Random(rows, size);
            Eigen::MatrixXd forth = M, back = M;
            mixColumns(forth, n, kStep_s, link);
            mixColumnsBack(back, n, kStep_s, link);
            EXPECT_LT((forth - M * F.transpose()).cwiseAbs().maxCoeff(), 1e-14) << rows << " " << count;
            EXPECT_LT((back - M * F).cwiseAbs().maxCoeff(), 1e-14) << rows << " " << count;
        }
}

TEST(TransitionKernels, ShiftsEqualTheDenseProducts) {
    std::srand(10);
    for (const Eigen::Index rows : {1, 4, 7, 34}) {
        constexpr Eigen::Index n = 8, size = 3 * n + 2;
        const RotationShift link{4, Eigen::Matrix3d::Random(), Eigen::Matrix3d::Random(),
                                 Eigen::Matrix3d::Random()};
        Eigen::MatrixXd S = Eigen::MatrixXd::Identity(size, size);
        S.block<3, 3>(4, 4) = link.to_theta;
        S.block<3, 3>(n + 4, 4) = link.to_rate;
        S.block<3, 3>(2 * n + 4, 4) = link.to_accel;
        const Eigen::MatrixXd M = Eigen::MatrixXd::Random(rows, size);
        Eigen::MatrixXd forth = M, back = M;
        shiftColumns(forth, n, link);
        shiftColumnsBack(back, n, link);
        EXPECT_LT((forth - M * S.transpose()).cwiseAbs().maxCoeff(), 1e-14) << rows;
        EXPECT_LT((back - M * S).cwiseAbs().maxCoeff(), 1e-14) << rows;
    }
}

}  // namespace
}  // namespace noctule
