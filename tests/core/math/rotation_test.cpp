// SPDX-License-Identifier: Apache-2.0
#include "core/math/rotation.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/support/jacobian_checker.h"

namespace noctule {
namespace {

TEST(Rotation, ExpAndLogAreInverse) {
    for (double angle : {0.0, 1e-12, 1e-5, 0.1, 1.0, 3.0, 3.14159})
        for (const Vector3d& axis :
             {Vector3d(1, 0, 0), Vector3d(0.6, -0.8, 0), Vector3d(Vector3d(1, 2, -2) / 3.0)}) {
            const Vector3d v = angle * axis;
            EXPECT_LT((logQuaternion(expQuaternion(v)) - v).norm(), 1e-9) << angle;
            const Quaterniond q = expQuaternion(v);
            EXPECT_LT((logQuaternion(Quaterniond(-q.w(), -q.x(), -q.y(), -q.z())) - v).norm(), 1e-9);
        }
}

TEST(Rotation, ExpMatchesRodrigues) {
    const Vector3d v(0.3, -0.7, 1.1);
    const Matrix3d expected = Eigen::AngleAxisd(v.norm(), v.normalized()).toRotationMatrix();
    EXPECT_LT((expQuaternion(v).toRotationMatrix() - expected).norm(), 1e-14);
}

TEST(Rotation, RightJacobian) {
    for (double angle : {0.0, 1e-6, 1e-3, 0.5, 2.0, 3.1}) {
        const Vector3d v = angle * Vector3d(2, -1, 2) / 3.0;
        const Quaterniond q = expQuaternion(v);
        testing::expectJacobian(
            [&](const Eigen::VectorXd& d) -> Eigen::VectorXd {
                return logQuaternion(q.conjugate() * expQuaternion(v + Vector3d(d)));
            },
            rightJacobian(v), "right Jacobian at " + std::to_string(angle));
    }
}

TEST(Rotation, SmallestRotationTurnsOneDirectionIntoTheOther) {
    const Vector3d from(1, 2, 3), to(-2, 0.5, 1);
    const Quaterniond q = smallestRotation(from, to);
    EXPECT_LT((q * from.normalized() - to.normalized()).norm(), 1e-12);
    EXPECT_NEAR(angleBetween(q, Quaterniond::Identity()), std::acos(from.normalized().dot(to.normalized())),
                1e-12);
    EXPECT_LT((smallestRotation(from, -from) * from + from).norm(), 1e-12);
    for (const Vector3d& none : {from, Vector3d(Vector3d::Zero())})
        EXPECT_EQ(smallestRotation(Vector3d::Zero(), none).coeffs(), Quaterniond::Identity().coeffs());
    for (const double short_of_half_rad : {1e-2, 1e-4, 1e-6}) {
        const Quaterniond turn = axisAngle(from.unitOrthogonal(), std::numbers::pi - short_of_half_rad);
        const Quaterniond found = smallestRotation(from, turn * from);
        EXPECT_NEAR(found.norm(), 1, 1e-12);
        EXPECT_LT((found * from - turn * from).norm(), 1e-9) << short_of_half_rad;
    }
}

}  // namespace
}  // namespace noctule
