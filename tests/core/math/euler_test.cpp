// SPDX-License-Identifier: Apache-2.0
#include "core/math/euler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/math/rotation.h"

namespace noctule {
namespace {

const EulerOrder kAllOrders[] = {kEulerXYZ, kEulerXZY, kEulerYXZ, kEulerYZX, kEulerZXY, kEulerZYX};

Quaterniond randomRotation(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Quaterniond{normal(random), normal(random), normal(random), normal(random)}.normalized();
}

TEST(Euler, TheFirstAngleIsTheOutermost) {
    // Rz(90 degrees) Rx(90 degrees) takes y to z under Rx, which Rz leaves alone.
    const Quaterniond q = rotationFromEuler(kEulerZXY, {radians(90), radians(90), 0});
    EXPECT_LT((q * Vector3d::UnitY() - Vector3d::UnitZ()).norm(), 1e-15);
    EXPECT_LT((q * Vector3d::UnitX() - Vector3d::UnitY()).norm(), 1e-15);
}

TEST(Euler, ComposesAsTheProductOfItsTurns) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> angle(-7, 7);
    for (const EulerOrder& order : kAllOrders) {
        const Vector3d e{angle(random), angle(random), angle(random)};
        Matrix3d R = Matrix3d::Identity();
        for (int n = 0; n < 3; ++n)
            R = R * Eigen::AngleAxisd(e[n], Vector3d::Unit(order[static_cast<size_t>(n)])).toRotationMatrix();
        EXPECT_LT((rotationFromEuler(order, e).toRotationMatrix() - R).norm(), 1e-14);
    }
}

TEST(Euler, ExtractsWhatComposesToTheSameRotation) {
    std::mt19937 random(2);
    for (const EulerOrder& order : kAllOrders)
        for (int n = 0; n < 1000; ++n) {
            const Quaterniond q = randomRotation(random);
            const Vector3d e = eulerFromRotation(order, q);
            ASSERT_LT(angleBetween(q, rotationFromEuler(order, e)), 1e-13);
            ASSERT_LE(std::abs(e[1]), radians(90));
        }
}

TEST(Euler, StaysExactUpToAndInsideTheGimbalLock) {
    for (const EulerOrder& order : kAllOrders)
        for (const double sign : {-1.0, 1.0})
            for (double distance = 0.1; distance > 1e-17; distance /= 3) {
                const Quaterniond q = rotationFromEuler(order, {0.7, sign * (radians(90) - distance), -1.9});
                ASSERT_LT(angleBetween(q, rotationFromEuler(order, eulerFromRotation(order, q))), 3e-9);
                const Vector3d near = eulerFromRotation(order, q, {0.6, sign * 1.5, -1.8});
                ASSERT_LT(angleBetween(q, rotationFromEuler(order, near)), 3e-9);
            }
}

TEST(Euler, CurvesFollowManyTurnsWithoutAJump) {
    for (const EulerOrder& order : kAllOrders) {
        Vector3d previous = Vector3d::Zero();
        for (int n = 0; n <= 2000; ++n) {
            const double t = 0.01 * n;  // the middle angle passes 90 degrees again and again
            const Vector3d truth(1.5 * t, 2.5 * std::sin(t), -0.8 * t);
            const Vector3d e = eulerFromRotation(order, rotationFromEuler(order, truth), previous);
            ASSERT_LT((e - truth).norm(), 1e-6) << "at " << t;
            previous = e;
        }
    }
}

TEST(Euler, HoldsTheFirstAngleWhileLocked) {
    Vector3d previous(0.4, radians(90), 0.1);
    const Quaterniond q = rotationFromEuler(kEulerZXY, {1.4, radians(90), 0.1});
    const Vector3d e = eulerFromRotation(kEulerZXY, q, previous);
    EXPECT_DOUBLE_EQ(e[0], 0.4);
    EXPECT_LT(angleBetween(q, rotationFromEuler(kEulerZXY, e)), 1e-9);
}

}  // namespace
}  // namespace noctule
