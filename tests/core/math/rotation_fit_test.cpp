// SPDX-License-Identifier: Apache-2.0
#include "core/math/rotation_fit.h"

#include <gtest/gtest.h>

#include <random>

#include "core/math/rotation.h"

namespace noctule {
namespace {

class RotationFit : public testing::Test {
protected:
    Vector3d vector() { return {normal_(generator_), normal_(generator_), normal_(generator_)}; }
    Matrix3d matrix() {
        Matrix3d M;
        for (int c = 0; c < 3; ++c)
            M.col(c) = vector();
        return M;
    }
    std::mt19937 generator_{5};
    std::normal_distribution<double> normal_;
};

TEST_F(RotationFit, NoOtherRotationIsNearer) {
    for (int draw = 0; draw < 50; ++draw) {
        const Matrix3d M = matrix(), R = nearestRotation(M);  // half of them mirror
        EXPECT_LT((R * R.transpose() - Matrix3d::Identity()).norm(), 1e-12);
        EXPECT_NEAR(R.determinant(), 1, 1e-12);
        for (int other = 0; other < 20; ++other) {
            const Matrix3d near = R * expQuaternion(0.1 * vector()).toRotationMatrix();
            EXPECT_LE((R - M).norm(), (near - M).norm() + 1e-12);
        }
    }
}

TEST_F(RotationFit, PointsAreCarriedBack) {
    for (int draw = 0; draw < 20; ++draw) {
        const Matrix3d R = expQuaternion(2 * vector()).toRotationMatrix();
        const Vector3d p = vector();
        Eigen::Matrix3Xd from(3, 7), to(3, 7);
        for (Eigen::Index k = 0; k < 7; ++k)
            from.col(k) = vector();
        to = (R * from).colwise() + p;
        const Eigen::Isometry3d rigid = rigidFit(from, to);
        EXPECT_LT((rigid.linear() - R).norm() + (rigid.translation() - p).norm(), 1e-12);
        to = (2.5 * R * from).colwise() + p;
        const Eigen::Affine3d similar = similarityFit(from, to);
        EXPECT_LT((similar.linear() - 2.5 * R).norm() + (similar.translation() - p).norm(), 1e-11);
    }
}

TEST_F(RotationFit, OfNoisyPointsNothingNearFitsBetter) {
    for (int draw = 0; draw < 20; ++draw) {
        const Matrix3d R = expQuaternion(2 * vector()).toRotationMatrix();
        Eigen::Matrix3Xd from(3, 7), to(3, 7);
        for (Eigen::Index k = 0; k < 7; ++k) {
            from.col(k) = vector();
            if (draw % 2)
                from(2, k) = 0;  // in a plane, which noise mirrors as readily
            to.col(k) = 1.5 * R * from.col(k) + 0.2 * vector() + Vector3d(1, 2, 3);
        }
        const auto error = [&](const Matrix3d& M, const Vector3d& t) {
            return ((M * from).colwise() + t - to).squaredNorm();
        };
        const Eigen::Isometry3d rigid = rigidFit(from, to);
        const Eigen::Affine3d similar = similarityFit(from, to);
        EXPECT_NEAR(rigid.linear().determinant(), 1, 1e-12);
        for (const double scale : {0.999, 1.001})
            EXPECT_GT(error(scale * similar.linear(), similar.translation()),
                      error(similar.linear(), similar.translation()));
        for (int other = 0; other < 20; ++other) {
            const Matrix3d turned = expQuaternion(0.05 * vector()).toRotationMatrix();
            const Vector3d shift = 0.05 * vector();
            const double larger = 1 + 0.05 * vector().x();
            EXPECT_GE(error(rigid.linear() * turned, rigid.translation() + shift),
                      error(rigid.linear(), rigid.translation()));
            EXPECT_GE(error(similar.linear() * turned * larger, similar.translation() + shift),
                      error(similar.linear(), similar.translation()));
        }
    }
}

}  // namespace
}  // namespace noctule
